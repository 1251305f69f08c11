/* outward.h: fractions of integers as the doubles next to them. */
#ifndef FMB_PAIR_OUTWARD_H
#define FMB_PAIR_OUTWARD_H

#include "pair/exact_box/wide.h"

/* x, of 53 bits: x 2^*exponent is the least such number that is not below (up), or the greatest
 * that is not above, numerator / det, det > 0. */
double fmb_exact_box_round_outward(const fmb_wide *numerator, const fmb_wide *det, bool up,
                                   int *exponent);

#endif
