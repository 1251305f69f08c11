/* parts.h: the JSON files written by the shards of one run, each with "shard": [I, N]. */
#ifndef APP_PARTS_H
#define APP_PARTS_H

#include <argp.h>
#include <jansson.h>
#include <stdint.h>

enum { APP_MOST_SHARDS = 1000000 };

/* Parse I/N, the value of --shard; exits after an error. */
void app_shard_parse(const char *text, uint64_t *shard, uint64_t *shards, struct argp_state *state);

/* [give, app_parts_free] Read the files, n of them: all N shards of a run, each once, which agree
 * on the keys of `same` (NULL ends them). APP_YES, or an exit code after a message. */
int app_parts_read(char **file, size_t n, const char *const *same, json_t ***out);
void app_parts_free(json_t **part, size_t n);

#endif
