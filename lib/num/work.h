/* work.h: what arithmetic on integers takes, in steps of about a nanosecond (trace/run.h), by how
 * long they are. docs/experiments.md has what was measured.
 */
#ifndef FMB_NUM_WORK_H
#define FMB_NUM_WORK_H

#include <stddef.h>
#include <stdint.h>

/* The sum of two products of numbers of so many limbs, over a third one. */
static inline uint64_t fmb_limbs_work(size_t limbs)
{
    return 35 + limbs * (10 + (uint64_t)limbs);
}

/* The greatest common divisor of two. */
static inline uint64_t fmb_gcd_work(size_t limbs)
{
    return limbs * (150 + 3 * (uint64_t)limbs / 2);
}

#endif
