/* support.h: the projection of a part as the hull of what support queries find, without eliminating
 * anything. */
#ifndef FMB_SOLVE_SUPPORT_H
#define FMB_SOLVE_SUPPORT_H

#include "solve/query/solver.h"

/* Append the projection of a part on those of its variables with place[] >= 0, perhaps none, to
 * out. *feasible false: the part has no solution. At a limit (LIMIT), the rows that are proved are
 * appended. */
fmb_status fmb_query_support_part(fmb_query *q, int part, const int *place, fmb_system *out,
                                  bool *feasible);

#endif
