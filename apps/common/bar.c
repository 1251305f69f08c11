/* bar.c: see bar.h. */
#include "common/bar.h"

#include <stdio.h>
#include <unistd.h>

#include "base/clock.h"

enum { WIDTH = 40, NAME = 12 };     /* characters */
static const double interval = 0.2; /* between two updates [s] */

app_bar app_bar_begin(bool quiet)
{
    return (app_bar){.wanted = !quiet && isatty(STDERR_FILENO), .last = fmb_monotonic_seconds()};
}

static void draw(uint64_t permille, const char *name)
{
    char bar[WIDTH + 1];
    for (unsigned i = 0; i < WIDTH; i++)
        bar[i] = i * 1000 < permille * WIDTH ? '#' : '.';
    bar[WIDTH] = '\0';
    fprintf(stderr, "\r[%s] %3u %% %-*.*s", bar, (unsigned)(permille / 10), NAME, NAME,
            name ? name : "");
    fflush(stderr);
}

void app_bar_show(app_bar *b, uint64_t done, uint64_t all, const char *name)
{
    double t = b->wanted ? fmb_monotonic_seconds() : 0;
    if (!b->wanted || t - b->last < interval)
        return;
    draw(all > 0 ? done * 1000 / all : 1000, name);
    b->last = t;
}

void app_bar_end(const app_bar *b)
{
    if (b->wanted)
        fprintf(stderr, "\r%*s\r", WIDTH + NAME + 12, "");
    fflush(stderr);
}
