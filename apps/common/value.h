/* value.h: values of options. An invalid one ends the program with APP_USAGE and the message
 * "OPTION: expected ..., found '...'".
 */
#ifndef APP_VALUE_H
#define APP_VALUE_H

#include <argp.h>
#include <stdbool.h>
#include <stdint.h>

#include <fmb/options.h>

uint64_t app_value_whole(const char *option, const char *text, uint64_t least, uint64_t most,
                         struct argp_state *state);
/* Parse two numbers from 1 to most, separated by `between`; false if the text is something else. */
bool app_value_two(const char *text, char between, uint64_t most, uint64_t out[2]);
/* most = DBL_MAX: there is no upper end. */
double app_value_number(const char *option, const char *text, double least, double most,
                        struct argp_state *state);
/* The index of the word in a list ended by NULL. */
int app_value_choice(const char *option, const char *word, const char *const *list,
                     struct argp_state *state);
/* The value of --simd, if this processor and this library support it. */
fmb_simd app_value_simd(const char *word, struct argp_state *state);
/* Call use for every word of a comma list; there must be one. */
void app_value_each(const char *option, const char *list,
                    void (*use)(const char *word, struct argp_state *state),
                    struct argp_state *state);

#endif
