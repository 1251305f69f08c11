/* nearest.h: "did you mean ...?" for unknown words. */
#ifndef APP_NEAREST_H
#define APP_NEAREST_H

#include <stddef.h>

enum { APP_HINT_SIZE = 128 };

/* The candidate nearest to a word so far; of equally near ones the first. */
typedef struct app_nearest {
    const char *word;
    const char *best; /* NULL: none is near enough to be meant */
    size_t distance;  /* of best */
} app_nearest;

app_nearest app_nearest_to(const char *word);

/* Try one more candidate; it must live as long as the search. */
void app_nearest_try(app_nearest *n, const char *candidate);

/* "; did you mean 'BEST'?", or "" if nothing is near. Returns hint. */
const char *app_nearest_hint(const app_nearest *n, char hint[APP_HINT_SIZE]);

#endif
