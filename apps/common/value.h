/* value.h: values of options. One that is no good ends the program with APP_USAGE. */
#ifndef APP_VALUE_H
#define APP_VALUE_H

#include <argp.h>
#include <stdint.h>

#include <fmb/options.h>

uint64_t app_value_whole(const char *text, uint64_t least, uint64_t most, struct argp_state *state);
double app_value_number(const char *text, double least, double most, struct argp_state *state);
fmb_simd app_value_simd(const char *word, struct argp_state *state);
/* Call use for every word of a comma list; there must be one. */
void app_value_each(const char *list, void (*use)(const char *word, struct argp_state *state),
                    struct argp_state *state);

#endif
