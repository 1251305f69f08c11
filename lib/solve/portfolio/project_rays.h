/* project_rays.h: the projection of a part by double description, slice by slice. */
#ifndef FMB_SOLVE_PROJECT_RAYS_H
#define FMB_SOLVE_PROJECT_RAYS_H

#include "solve/prepare/reduced_part.h"

/* A part on its way, in the query's arena. */
typedef struct fmb_ray_projection fmb_ray_projection;

/* of stays until this is closed. Close *out, unless it is NULL, in any case. Errors: MEMORY, LIMIT.
 */
fmb_status fmb_ray_projection_open(fmb_reduced_part *of, fmb_ray_projection **out);

void fmb_ray_projection_close(fmb_ray_projection *h);

/* Go on, until a slice is over. *ready: the projection is known, or *feasible is false. Errors:
 * MEMORY, LIMIT, here and below. */
fmb_status fmb_ray_projection_run(fmb_ray_projection *h, bool *feasible, bool *ready);
/* Append a projection that is known to out, with claims, as fmb_query_project_part does. */
fmb_status fmb_ray_projection_put(fmb_ray_projection *h, fmb_system *out, bool *feasible);
/* There is no use in going on: it must be eliminated. */
bool fmb_ray_projection_has_given_up(const fmb_ray_projection *h);

#endif
