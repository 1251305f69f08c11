/* value.c: see value.h. */
#include "common/value.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"

uint64_t app_value_whole(const char *text, uint64_t least, uint64_t most, struct argp_state *state)
{
    char *end;
    errno = 0;
    unsigned long long x = strtoull(text, &end, 10);
    if (*text < '0' || *text > '9' || *end != '\0' || errno != 0 || x < least || x > most)
        argp_error(state, "'%s' is not a whole number from %llu to %llu", text,
                   (unsigned long long)least, (unsigned long long)most);
    return x;
}

double app_value_number(const char *text, double least, double most, struct argp_state *state)
{
    char *end;
    errno = 0;
    double x = strtod(text, &end);
    if (end == text || *end != '\0' || errno != 0 || !(x >= least && x <= most))
        argp_error(state, "'%s' is not a number from %g to %g", text, least, most);
    return x;
}

fmb_simd app_value_simd(const char *word, struct argp_state *state)
{
    fmb_options o = fmb_options_default();
    if (fmb_options_set(&o, "simd", word) != FMB_OK)
        argp_error(state, "'%s' is not one of auto, plain, avx2, avx512", word);
    return o.simd;
}

void app_value_each(const char *list, void (*use)(const char *word, struct argp_state *state),
                    struct argp_state *state)
{
    char *rest, *copy = app_need(strdup(list)), *word = strtok_r(copy, ",", &rest);
    if (!word)
        argp_error(state, "'%s' has no words", list);
    for (; word; word = strtok_r(NULL, ",", &rest))
        use(word, state);
    free(copy);
}
