/* clock.h: the clock that limits go by. */
#ifndef FMB_BASE_CLOCK_H
#define FMB_BASE_CLOCK_H

#include <time.h>

/* Since some moment that does not change [s]. */
static inline double fmb_monotonic_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

#endif
