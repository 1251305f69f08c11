/* certify.h: certificates of a basic solution: is the goal optimal there, are the frames apart? */
#ifndef FMB_PAIR_CERTIFY_H
#define FMB_PAIR_CERTIFY_H

#include "pair/exact_box/point.h"

/* Are the closed frames certainly apart in the direction given by these weights of the basic
 * artificial unknowns? False: doubles cannot prove it. */
bool fmb_exact_box_are_apart(const fmb_exact_box *v, const double *weight);
/* Is the goal optimal at v, over all z in their places with M z = h? */
bool fmb_exact_box_is_farthest(fmb_exact_box *v, const fmb_exact_box_goal *goal);

/* det times the prices of the rows, y = c P^-1, where c are the costs of the basic unknowns,
 * relative to those of references or absolute. */
void fmb_exact_box_find_prices(fmb_exact_box *v, const fmb_wide *const *cost, fmb_wide *y);
/* det times the negative reduced cost of unknown j, y m_j - cost, for the same costs. */
void fmb_exact_box_find_loss(fmb_exact_box *v, const fmb_wide *y, const fmb_wide *cost, int j,
                             fmb_wide *out);

#endif
