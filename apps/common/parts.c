/* parts.c: see parts.h. */
#include "common/parts.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "common/message.h"
#include "common/value.h"

void app_shard_parse(const char *text, uint64_t *shard, uint64_t *shards, struct argp_state *state)
{
    uint64_t part[2];
    if (!app_value_two(text, '/', APP_MOST_SHARDS, part) || part[0] > part[1])
        argp_error(state, "--shard: expected I/N, where 1 <= I <= N <= %d, found '%s'",
                   APP_MOST_SHARDS, text);
    *shard = part[0];
    *shards = part[1];
}

static int read_part(const char *path, json_t **out)
{
    FILE *f;
    json_error_t why;
    int code = app_file_open(path, &f);
    if (code != APP_YES)
        return code;
    *out = json_loadf(f, 0, &why);
    app_file_close_input(f);
    return *out ? APP_YES
                : app_error_at((app_place){path, why.line, why.column}, APP_BAD_INPUT, "%s",
                               why.text);
}

/* Is it a shard of n that was not there before? */
static bool is_new_shard(const json_t *part, size_t n, bool *seen)
{
    const json_t *shard = json_object_get(part, "shard");
    json_int_t i = json_integer_value(json_array_get(shard, 0)),
               of = json_integer_value(json_array_get(shard, 1));
    if (i < 1 || i > of || (size_t)of != n || seen[i - 1])
        return false;
    seen[i - 1] = true;
    return true;
}

static bool agrees(const json_t *part, const json_t *first, const char *const *same)
{
    for (; *same; same++)
        if (!json_equal(json_object_get(part, *same), json_object_get(first, *same)))
            return false;
    return true;
}

int app_parts_read(char **file, size_t n, const char *const *same, json_t ***out)
{
    json_t **part = app_need(calloc(n + 1, sizeof *part));
    bool *seen = app_need(calloc(n + 1, sizeof *seen));
    int code = n > 0 ? APP_YES : app_error(APP_USAGE, "--merge: expected the files of all shards");
    for (size_t i = 0; code == APP_YES && i < n; i++) {
        code = read_part(file[i], &part[i]);
        if (code == APP_YES && !is_new_shard(part[i], n, seen))
            code = app_error(APP_BAD_INPUT, "%s: expected one shard of %zu, each once", file[i], n);
        if (code == APP_YES && !agrees(part[i], part[0], same))
            code = app_error(APP_BAD_INPUT, "%s: a shard of another run than %s", file[i], file[0]);
    }
    free(seen);
    if (code == APP_YES)
        *out = part;
    else
        app_parts_free(part, n);
    return code;
}

void app_parts_free(json_t **part, size_t n)
{
    for (size_t i = 0; i < n; i++)
        json_decref(part[i]);
    free(part);
}
