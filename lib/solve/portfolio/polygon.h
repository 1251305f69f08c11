/* polygon.h: the projection of a part on one or two variables, without eliminating anything. */
#ifndef FMB_SOLVE_POLYGON_H
#define FMB_SOLVE_POLYGON_H

#include "solve/query/solver.h"

/* Append the projection of a feasible part on those of its variables with place[] >= 0 to out.
 * *done false (and nothing appended): there are more than two of them, or none; or the projection
 * has no inner points or no vertex, or the part has strict rows: then it must be eliminated. */
fmb_status fmb_query_polygon_part(fmb_query *q, int part, const int *place, fmb_system *out,
                                  bool *done);

#endif
