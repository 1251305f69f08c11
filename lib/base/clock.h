/* clock.h: clocks; the one on the wall is what limits go by. The programs use them, too. */
#ifndef FMB_BASE_CLOCK_H
#define FMB_BASE_CLOCK_H

#include <time.h>

/* What a clock of POSIX shows [s]. */
static inline double fmb_clock_seconds(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Since some moment that does not change [s]. */
static inline double fmb_monotonic_seconds(void)
{
    return fmb_clock_seconds(CLOCK_MONOTONIC);
}

#endif
