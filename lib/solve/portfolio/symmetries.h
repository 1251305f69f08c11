/* symmetries.h: symmetries that a caller gives for projections (fmb/symmetry.h).
 *
 * v->moved says where each takes variables and rows of the system at hand, from the check until the
 * query has ended. A symmetry that takes a connected part to another one is of no use to either.
 */
#ifndef FMB_SOLVE_SYMMETRIES_H
#define FMB_SOLVE_SYMMETRIES_H

#include "solve/query/solver.h"
#include "symmetry/group.h"

/* Before a query that keeps the variables with place[dim] >= 0: are those that were given, if any
 * count, symmetries? Errors: ARG, MEMORY. In any case fmb_symmetries_leave. */
fmb_status fmb_symmetries_enter(fmb_solver *v, const fmb_system *s, const int *place);
void fmb_symmetries_leave(fmb_solver *v, const fmb_system *s);

/* Those of a part, whose program is written; its kept columns are column[0..k). In any case
 * fmb_group_clear it. Errors: MEMORY, LIMIT. */
fmb_status fmb_symmetries_of_part(fmb_query *q, int part, const int *column, size_t k,
                                  fmb_group *out);

#endif
