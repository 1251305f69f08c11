/* work.h: estimates of the time of integer arithmetic by the length of the numbers, in steps of
 * about a nanosecond (trace/run.h). The measurements are in docs/experiments.md.
 */
#ifndef FMB_NUM_WORK_H
#define FMB_NUM_WORK_H

#include <stddef.h>
#include <stdint.h>

/* (a b + c d) / e, all numbers of so many limbs. */
static inline uint64_t fmb_limbs_work(size_t limbs)
{
    return 35 + limbs * (10 + (uint64_t)limbs);
}

/* The greatest common divisor of two integers. */
static inline uint64_t fmb_gcd_work(size_t limbs)
{
    return limbs * (150 + 3 * (uint64_t)limbs / 2);
}

#endif
