/* outward.h: fractions of integers as the doubles next to them. */
#ifndef FMB_PAIR_OUTWARD_H
#define FMB_PAIR_OUTWARD_H

#include "pair/exact_box/wide.h"

/* Returns x of 53 bits such that x 2^*exponent is numerator / det, det > 0, rounded up (up) or
 * down. */
double fmb_exact_box_round_outward(const fmb_wide *numerator, const fmb_wide *det, bool up,
                                   int *exponent);

#endif
