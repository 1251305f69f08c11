/* exact_box_value.h: goals at a basic solution: what they are made of, and their values, as
 * fractions of integers, or in double-doubles as far as these tell the double next to them.
 */
#ifndef FMB_PAIR_EXACT_BOX_VALUE_H
#define FMB_PAIR_EXACT_BOX_VALUE_H

#include "pair/exact_box/point.h"

/* What one unit of an unknown adds to the goal: a whole number, and scaled as in a vector. */
typedef struct fmb_exact_box_cost {
    const fmb_wide *whole;
    double near, rest;
} fmb_exact_box_cost;

/* Costs of all unknowns. In coordinates of B goals of the world have the
 * other sign: - x_i = - origin of B + (- axes of B, - speed of B) z + the artificial unknown of row
 * i, which tells how far the two are apart. */
void fmb_exact_box_list_costs(const fmb_exact_box *v, const fmb_exact_box_goal *goal,
                              fmb_exact_box_cost *cost);

/* The cost of unknown j, relative to that of its reference: it lies there, or in *room. */
static inline const fmb_wide *fmb_exact_box_relative_cost(const fmb_exact_box *v,
                                                          const fmb_exact_box_cost *cost, int j,
                                                          fmb_wide *room)
{
    int reference = fmb_exact_box_reference_of(v, j);
    return fmb_exact_box_difference(cost[j].whole, reference < 0 ? NULL : cost[reference].whole,
                                    room);
}

/* The value of the goal here as a fraction, denominator > 0, in the unit of its row if it is one of
 * the world. */
void fmb_exact_box_value(fmb_exact_box *v, const fmb_exact_box_goal *goal, fmb_wide *numerator,
                         fmb_wide *denominator);
/* The value over 2^exponent as a double, off by at most 2^-50 of itself. */
double fmb_exact_box_value_roughly(fmb_exact_box *v, const fmb_exact_box_goal *goal, int exponent);
/* The least double that is not below (of a greatest end), or the greatest that is not above, the
 * value over 2^exponent. False: it is beyond all doubles. */
bool fmb_exact_box_value_outward(fmb_exact_box *v, const fmb_exact_box_goal *goal, int exponent,
                                 double *out);

#endif
