/* exact_walk.h: from a basis to a vertex, and from vertex to vertex, in integers: where doubles did
 * not get to one that can be proved. */
#ifndef FMB_PAIR_EXACT_WALK_H
#define FMB_PAIR_EXACT_WALK_H

#include "pair/exact_box/certify.h"

/* From the basis of v, any one, to a vertex of the common points, and on to one where the goal, if
 * it is not NULL, is at its end. INFEASIBLE: there are none; UNKNOWN: too many steps, or who
 * is polled ended it. */
fmb_verdict fmb_exact_box_walk_exactly(fmb_exact_box *v, const fmb_exact_box_goal *goal);

#endif
