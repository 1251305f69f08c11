/* outward.h: fractions of integers as the doubles next to them. */
#ifndef FMB_PAIR_OUTWARD_H
#define FMB_PAIR_OUTWARD_H

#include "pair/exact_box/wide.h"

/* The least double that is not below (up), or the greatest that is not above, numerator / det, det
 * > 0. False: it is near the ends of what doubles are. */
bool fmb_exact_box_round_outward(const fmb_wide *numerator, const fmb_wide *det, bool up,
                                 double *out);

#endif
