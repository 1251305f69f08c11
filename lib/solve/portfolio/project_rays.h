/* project_rays.h: the projection of a part by double description, slice by slice. */
#ifndef FMB_SOLVE_PROJECT_RAYS_H
#define FMB_SOLVE_PROJECT_RAYS_H

#include "solve/prepare/reduced_part.h"

/* A projection in progress, in the query's arena. */
typedef struct fmb_ray_projection fmb_ray_projection;

/* `of` must outlive *out. Close *out unless it is NULL, even after an error. Errors: MEMORY, LIMIT.
 */
fmb_status fmb_ray_projection_open(fmb_reduced_part *of, fmb_ray_projection **out);

void fmb_ray_projection_close(fmb_ray_projection *h);

/* Continue until the slice is used up. *ready: the projection is known, or *feasible is false.
 * Errors: MEMORY, LIMIT, here and below. */
fmb_status fmb_ray_projection_run(fmb_ray_projection *h, bool *feasible, bool *ready);
/* Append the projection, once it is known, to out, with claims, as fmb_query_project_part does. */
fmb_status fmb_ray_projection_put(fmb_ray_projection *h, fmb_system *out, bool *feasible);
/* Continuing would be useless: the part must be projected by elimination. */
bool fmb_ray_projection_has_given_up(const fmb_ray_projection *h);

#endif
