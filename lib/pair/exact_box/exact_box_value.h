/* exact_box_value.h: the costs of a goal and its value at a basic solution, as a fraction of
 * integers, or in double-doubles where these determine the nearest double.
 */
#ifndef FMB_PAIR_EXACT_BOX_VALUE_H
#define FMB_PAIR_EXACT_BOX_VALUE_H

#include "pair/exact_box/point.h"

/* What one unit of an unknown adds to the goal: an integer, and scaled doubles as in a vector. */
typedef struct fmb_exact_box_cost {
    const fmb_wide *whole;
    double near, rest;
} fmb_exact_box_cost;

/* Costs of all unknowns. In coordinates of B world goals have the opposite sign: - x_i = - origin
 * of B + (- axes of B, - speed of B) z + the artificial unknown of row i, which is the distance of
 * the two points along axis i. */
void fmb_exact_box_list_costs(const fmb_exact_box *v, const fmb_exact_box_goal *goal,
                              fmb_exact_box_cost *cost);

/* The cost of unknown j minus that of its reference; returns a pointer to it, perhaps room. */
static inline const fmb_wide *fmb_exact_box_relative_cost(const fmb_exact_box *v,
                                                          const fmb_exact_box_cost *cost, int j,
                                                          fmb_wide *room)
{
    int reference = fmb_exact_box_reference_of(v, j);
    return fmb_exact_box_difference(cost[j].whole, reference < 0 ? NULL : cost[reference].whole,
                                    room);
}

/* The value of the goal at v as a fraction, denominator > 0; a world goal in the unit of its row.
 */
void fmb_exact_box_value(fmb_exact_box *v, const fmb_exact_box_goal *goal, fmb_wide *numerator,
                         fmb_wide *denominator);
/* The value over 2^exponent as a double, with a relative error of at most 2^-50. */
double fmb_exact_box_value_roughly(fmb_exact_box *v, const fmb_exact_box_goal *goal, int exponent);
/* The value over 2^exponent rounded outward: up for a greatest end, else down. False: it is beyond
 * all doubles. */
bool fmb_exact_box_value_outward(fmb_exact_box *v, const fmb_exact_box_goal *goal, int exponent,
                                 double *out);

#endif
