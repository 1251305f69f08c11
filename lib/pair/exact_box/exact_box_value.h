/* exact_box_value.h: goals at a basic solution: what they are made of, and their values, as
 * fractions of integers, or in double-doubles as far as these tell the double next to them.
 */
#ifndef FMB_PAIR_EXACT_BOX_VALUE_H
#define FMB_PAIR_EXACT_BOX_VALUE_H

#include "pair/exact_box/point.h"

/* What one unit of each unknown adds to the goal. In coordinates of B goals of the world have the
 * other sign: - x_i = - origin of B + (- axes of B, - speed of B) z + the artificial unknown of row
 * i, which tells how far the two are apart. */
void fmb_exact_box_list_costs(const fmb_exact_box *v, const fmb_exact_box_goal *goal,
                              const fmb_exact_box_number *cost[FMB_EXACT_BOX_UNKNOWNS]);

/* The cost of unknown j. */
static inline fmb_exact_box_relative
fmb_exact_box_relative_cost(const fmb_exact_box *v, const fmb_exact_box_number *const *cost, int j)
{
    int reference = fmb_exact_box_reference_of(v, j);
    return (fmb_exact_box_relative){cost[j], reference < 0 ? &fmb_exact_box_zero : cost[reference]};
}

/* The value of the goal here as a fraction, denominator > 0, in the unit of its row if it is one of
 * the world. */
void fmb_exact_box_value(fmb_exact_box *v, const fmb_exact_box_goal *goal, fmb_wide *numerator,
                         fmb_wide *denominator);
/* The same as a double, off by at most 2^-50 of itself. */
double fmb_exact_box_value_roughly(fmb_exact_box *v, const fmb_exact_box_goal *goal);
/* The least double that is not below (of a greatest end), or the greatest that is not above, the
 * value over 2^exponent. False: it is near the ends of what doubles are. */
bool fmb_exact_box_value_outward(fmb_exact_box *v, const fmb_exact_box_goal *goal, int exponent,
                                 double *out);

#endif
