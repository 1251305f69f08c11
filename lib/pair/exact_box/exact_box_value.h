/* exact_box_value.h: goals at a basic solution: what they are made of, and their values, as
 * fractions of integers, or in double-doubles as far as these tell the double next to them.
 */
#ifndef FMB_PAIR_EXACT_BOX_VALUE_H
#define FMB_PAIR_EXACT_BOX_VALUE_H

#include "pair/exact_box/point.h"

/* What one unit of each unknown adds to the goal. In coordinates of B goals of the world have the
 * other sign: - x_i = - origin of B + (- axes of B, - speed of B) z + the artificial unknown of row
 * i, which tells how far the two are apart. */
void fmb_extreme_list_costs(const fmb_extreme *v, const fmb_extreme_goal *goal,
                            const fmb_extreme_number *cost[FMB_EXTREME_UNKNOWNS]);

/* The cost of unknown j. */
static inline fmb_extreme_relative
fmb_extreme_relative_cost(const fmb_extreme *v, const fmb_extreme_number *const *cost, int j)
{
    int reference = fmb_extreme_reference_of(v, j);
    return (fmb_extreme_relative){cost[j], reference < 0 ? &fmb_extreme_zero : cost[reference]};
}

/* The value of the goal here as a fraction, denominator > 0, in the unit of its row if it is one of
 * the world. */
void fmb_extreme_value(fmb_extreme *v, const fmb_extreme_goal *goal, fmb_wide *numerator,
                       fmb_wide *denominator);
/* The same as a double, off by at most 2^-50 of itself. */
double fmb_extreme_value_roughly(fmb_extreme *v, const fmb_extreme_goal *goal);
/* The least double that is not below (of a greatest end), or the greatest that is not above, the
 * value over 2^exponent. False: it is near the ends of what doubles are. */
bool fmb_extreme_value_outward(fmb_extreme *v, const fmb_extreme_goal *goal, int exponent,
                               double *out);

#endif
