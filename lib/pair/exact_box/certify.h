/* certify.h: what is certain of a basic solution: is a goal at its end there, are frames apart? */
#ifndef FMB_PAIR_CERTIFY_H
#define FMB_PAIR_CERTIFY_H

#include "pair/exact_box/point.h"

/* Are the closed frames apart in the direction of these weights of the basic artificial unknowns?
 * False: doubles do not tell. */
bool fmb_exact_box_are_apart(const fmb_exact_box *v, const double *weight);
/* Is the goal nowhere in M z = h, z in its places, farther out than here? */
bool fmb_exact_box_is_farthest(fmb_exact_box *v, const fmb_exact_box_goal *goal);

/* det times the prices of the rows, y = c P^-1, where c are costs of the basic unknowns, relative
 * or as they stand. */
void fmb_exact_box_find_prices(fmb_exact_box *v, const fmb_wide *const *cost, fmb_wide *y);
/* det times what unknown j loses, y m_j - cost, for the same costs. */
void fmb_exact_box_find_loss(fmb_exact_box *v, const fmb_wide *y, const fmb_wide *cost, int j,
                             fmb_wide *out);

#endif
