/* symmetries.h: symmetries that a caller gives for projections (fmb/symmetry.h).
 *
 * v->moved holds the images of variables and rows of the current system under each symmetry, from
 * the check until the query ends. A symmetry that maps a part to another one is not used.
 */
#ifndef FMB_SOLVE_SYMMETRIES_H
#define FMB_SOLVE_SYMMETRIES_H

#include "solve/query/solver.h"
#include "symmetry/group.h"

/* Before a query that keeps the variables with place[dim] >= 0: check that the permutations that
 * were given are symmetries. fmb_symmetries_leave, even after an error. Errors: ARG, MEMORY. */
fmb_status fmb_symmetries_enter(fmb_solver *v, const fmb_system *s, const int *place);
void fmb_symmetries_leave(fmb_solver *v, const fmb_system *s);

/* The symmetries of a part whose program is written; its kept columns are column[0..k).
 * fmb_group_clear *out, even after an error. Errors: MEMORY, LIMIT. */
fmb_status fmb_symmetries_of_part(fmb_query *q, int part, const int *column, size_t k,
                                  fmb_group *out);

#endif
