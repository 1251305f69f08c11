/* value.c: see value.h. */
#include "common/value.h"

#include <errno.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"

uint64_t app_value_whole(const char *option, const char *text, uint64_t least, uint64_t most,
                         struct argp_state *state)
{
    char *end;
    errno = 0;
    unsigned long long x = strtoull(text, &end, 10);
    if (*text < '0' || *text > '9' || *end != '\0' || errno != 0 || x < least || x > most)
        argp_error(state, "%s: expected a whole number from %llu to %llu, found '%s'", option,
                   (unsigned long long)least, (unsigned long long)most, text);
    return x;
}

bool app_value_two(const char *text, char between, uint64_t most, uint64_t out[2])
{
    for (int i = 0; i < 2; i++) {
        char *end;
        out[i] = strtoull(text, &end, 10);
        if (*text < '0' || *text > '9' || *end != (i == 0 ? between : '\0') || out[i] < 1 ||
            out[i] > most)
            return false;
        text = end + 1;
    }
    return true;
}

double app_value_number(const char *option, const char *text, double least, double most,
                        struct argp_state *state)
{
    char *end;
    errno = 0;
    double x = strtod(text, &end);
    if (x == 0 && errno == ERANGE) /* it would mean something else */
        argp_error(state, "%s: expected 0 or a number that is not 0 as a double, found '%s'",
                   option, text);
    bool good = end != text && *end == '\0' && x >= least && x <= most;
    if (!good && least == -DBL_MAX && most == DBL_MAX)
        argp_error(state, "%s: expected a number, found '%s'", option, text);
    if (!good && most == DBL_MAX)
        argp_error(state, "%s: expected a number >= %g, found '%s'", option, least, text);
    if (!good)
        argp_error(state, "%s: expected a number from %g to %g, found '%s'", option, least, most,
                   text);
    return x;
}

int app_value_choice(const char *option, const char *word, const char *const *list,
                     struct argp_state *state)
{
    char all[200] = "";
    for (int i = 0; list[i]; i++) {
        size_t used = strlen(all);
        if (strcmp(word, list[i]) == 0)
            return i;
        snprintf(all + used, sizeof all - used, "%s%s", i > 0 ? "|" : "", list[i]);
    }
    argp_error(state, "%s: expected %s, found '%s'", option, all, word);
    return 0;
}

void app_value_each(const char *option, const char *list,
                    void (*use)(const char *word, struct argp_state *state),
                    struct argp_state *state)
{
    char *rest, *copy = app_need(strdup(list)), *word = strtok_r(copy, ",", &rest);
    if (!word)
        argp_error(state, "%s: expected words with a comma between, found '%s'", option, list);
    for (; word; word = strtok_r(NULL, ",", &rest))
        use(word, state);
    free(copy);
}
