/* rays.h: the projection of a part by double description. */
#ifndef FMB_SOLVE_RAYS_H
#define FMB_SOLVE_RAYS_H

#include "solve/query/solver.h"

/* Append the projection of a part to out, with claims, as fmb_query_project_part does. *done false,
 * and nothing appended: it must be eliminated. */
fmb_status fmb_query_project_by_rays(fmb_query *q, int part, const int *place, fmb_system *out,
                                     bool *feasible, bool *done);

#endif
