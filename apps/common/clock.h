/* clock.h: the clock on the wall. */
#ifndef APP_CLOCK_H
#define APP_CLOCK_H

#include <time.h>

/* Since some moment that does not change [s]. */
static inline double app_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

#endif
