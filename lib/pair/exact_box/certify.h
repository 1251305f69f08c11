/* certify.h: what is certain of a basic solution: is a goal at its end there, are frames apart? */
#ifndef FMB_PAIR_CERTIFY_H
#define FMB_PAIR_CERTIFY_H

#include "pair/exact_box/point.h"

/* Are the closed frames apart in the direction of these weights of the basic artificial unknowns,
 * in which the basis, which need not be common, is nearest? */
bool fmb_exact_box_are_apart(fmb_exact_box *v, const fmb_exact_box_program *s,
                             const fmb_exact_box_basis *basis, const double *weight);
/* Is the goal nowhere in M z = h, z in its places, farther out than here? */
bool fmb_exact_box_is_farthest(fmb_exact_box *v, const fmb_exact_box_goal *goal);

#endif
