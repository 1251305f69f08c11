/* clock.h: clocks. Time limits go by the monotonic one. The programs use this file, too. */
#ifndef FMB_BASE_CLOCK_H
#define FMB_BASE_CLOCK_H

#include <time.h>

/* The time of a POSIX clock [s]. */
static inline double fmb_clock_seconds(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Seconds since some fixed moment. */
static inline double fmb_monotonic_seconds(void)
{
    return fmb_clock_seconds(CLOCK_MONOTONIC);
}

#endif
