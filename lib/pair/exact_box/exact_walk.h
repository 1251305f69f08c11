/* exact_walk.h: the simplex walk from a basis to a vertex, and from vertex to vertex, in integers:
 * used if doubles did not reach a vertex that can be proved. */
#ifndef FMB_PAIR_EXACT_WALK_H
#define FMB_PAIR_EXACT_WALK_H

#include "pair/exact_box/certify.h"

/* From the basis of v, which may be any, to a vertex of the common points, and then to one where
 * the goal, unless it is NULL, is optimal. INFEASIBLE: there are no common points; UNKNOWN: too
 * many steps, or the poll ended it. */
fmb_verdict fmb_exact_box_walk_exactly(fmb_exact_box *v, const fmb_exact_box_goal *goal);

#endif
