/* bar.h: a progress bar for long runs, shown on a terminal only. */
#ifndef APP_BAR_H
#define APP_BAR_H

#include <stdbool.h>
#include <stdint.h>

typedef struct app_bar {
    bool wanted;
    double last; /* when it was drawn [s] */
} app_bar;

app_bar app_bar_begin(bool quiet);
/* Show that `done` of `all` is done, in the part of that name (or NULL). Drawn now and then. */
void app_bar_show(app_bar *b, uint64_t done, uint64_t all, const char *name);
/* Erase it. */
void app_bar_end(const app_bar *b);

#endif
