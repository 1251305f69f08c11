/* minors_said.h: the combined result of rows (minors_kernel.h) or tests (minors_signs.h). */
#ifndef FMB_PAIR_MINORS_SAID_H
#define FMB_PAIR_MINORS_SAID_H

#include <stdbool.h>

#include "pair/kernels/lane/lane.h"
#include "pair/kernels/minors_kernels.h"

typedef struct minors_said {
    lane apart;      /* largest gap - its error: positive means apart */
    lane meet;       /* largest gap + its error: negative means meet, if all rows were tested */
    lane_mask known; /* in other lanes both are undefined */
} minors_said;

FMB_INLINE minors_said minors_silent(void)
{
    return (minors_said){lane_of(-INFINITY), lane_of(-INFINITY), lane_less(lane_of(0), lane_of(1))};
}

/* Add the largest gap of some rows, with its error bound. */
FMB_INLINE void minors_hear(minors_said *said, lane gap, lane error)
{
    said->apart = lane_max(said->apart, gap - error);
    said->meet = lane_max(said->meet, gap + error);
}

/* Add a test of numbers with the least absolute value `least` and that error bound. passed < 0: all
 * signs are right for "apart"; doubt < 0: those of the minors in it are certain. Returns error -
 * least: negative iff all signs of the numbers are certain. */
FMB_INLINE lane minors_hear_signs(minors_said *said, lane least, lane passed, lane error,
                                  lane doubt)
{
    const lane own = error - least, all = lane_of(0) - lane_max(own, doubt);
    said->meet = lane_max(said->meet, own);
    said->apart = lane_max_where(lane_negative(passed), said->apart, all);
    return own;
}

FMB_INLINE fmb_pair_bits minors_bits(const minors_said *said)
{
    const lane zero = lane_of(0);
    const unsigned apart = lane_bits(lane_and(said->known, lane_less(zero, said->apart)));
    const unsigned meet = lane_bits(lane_and(said->known, lane_less(said->meet, zero)));
    return (fmb_pair_bits){.apart = apart, .meet = meet & ~apart};
}

FMB_INLINE bool minors_all_apart(const minors_said *said)
{
    return minors_bits(said).apart == (1U << FMB_LANES) - 1;
}

#endif
