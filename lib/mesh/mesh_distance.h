/* mesh_distance.h: the distance of two meshes: an upper bound before the walk that lists the pairs
 * of cells within it, and the nearest pair afterwards. */
#ifndef FMB_MESH_MESH_DISTANCE_H
#define FMB_MESH_MESH_DISTANCE_H

#include "mesh/tree_walk.h"

/* Set the clearance of the plan to an upper bound of the distance: some pair of cells is as near.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_mesh_bound_distance(fmb_walk_plan *plan);
/* Set plan->nearest from the pairs within that clearance, sorted by a, then b. Errors: MEMORY,
 * LIMIT. */
fmb_status fmb_mesh_choose_nearest(fmb_walk_plan *plan, const fmb_mesh_answer *near);

#endif
