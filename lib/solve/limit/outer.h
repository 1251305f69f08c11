/* outer.h: bounds and rows that can be proved at little cost after a limit was reached.
 *
 * The rows of a system that name one variable bound it; a row bounds one of its variables by the
 * ends of the others. Such ends are combinations of rows, made in the store of an elimination like
 * any other, so they have multipliers. They may be larger than the truth, never smaller. Source:
 * Davis, Constraint propagation with interval labels, 1987.
 *
 * The work is bounded for every system, so a limit is exceeded by milliseconds only. Ends and rows
 * for which there is no memory are left out. So no function here returns FMB_LIMIT.
 */
#ifndef FMB_SOLVE_OUTER_H
#define FMB_SOLVE_OUTER_H

#include "solve/query/exact_intervals.h"
#include "solve/query/solver.h"

/* Are the dense rows of the part few enough to be read after the time limit? */
static inline bool fmb_outer_is_cheap(const fmb_part *p)
{
    return p->row || p->m < ((size_t)1 << 22) / ((size_t)p->n + 1);
}

/* Ends of the part's variables that are unknown in box become outer ends, from the rows of an
 * elimination that a limit has cut short; with claims. Errors: MEMORY. */
fmb_status fmb_outer_from_rows(fmb_query *q, const fmb_part *p, fmb_elim *e, fmb_box *box);

/* Like the function above, for all parts, from the rows of the system. If ends contradict each
 * other, *verdict is INFEASIBLE, with a claim, and the query counts as complete. Errors: MEMORY. */
fmb_status fmb_outer_box(fmb_query *q, fmb_box *box, fmb_verdict *verdict);

/* Append to out all rows of e that name kept variables only, and ends of kept variables; with
 * claims. place[dim]: the column of a variable in out, -1 if it is eliminated. Errors: MEMORY. */
fmb_status fmb_outer_rows(fmb_query *q, const fmb_part *p, fmb_elim *e, const int *place,
                          fmb_system *out);

/* Like the function above, from the rows of the system; *verdict as for fmb_outer_box. */
fmb_status fmb_outer_projection(fmb_query *q, int part, const int *place, fmb_system *out,
                                fmb_verdict *verdict);

/* Among the rows of out from number first on, keep the tightest of each set of parallel rows; all
 * claims are kept. Errors: MEMORY. */
fmb_status fmb_outer_drop_parallel_rows(fmb_query *q, fmb_system *out, size_t first);

/* Close all oracles and release what the arena holds beyond `place`. Call it before the functions
 * about all parts. */
void fmb_outer_release(fmb_query *q, fmb_arena_place place);

#endif
