/* mesh_distance.h: how far two meshes are apart, before and after the walk that lists pairs of
 * cells within a bound. */
#ifndef FMB_MESH_MESH_DISTANCE_H
#define FMB_MESH_MESH_DISTANCE_H

#include "mesh/tree_walk.h"

/* Make the clearance of the plan a distance that some pair of cells does not exceed. Errors:
 * MEMORY, LIMIT. */
fmb_status fmb_mesh_bound_distance(fmb_walk_plan *plan);
/* Fill in plan->nearest from the pairs within that clearance, by a, then b. Errors: MEMORY, LIMIT.
 */
fmb_status fmb_mesh_choose_nearest(fmb_walk_plan *plan, const fmb_mesh_answer *near);

#endif
