/* thin.h: the irredundant rows of what an elimination left.
 *
 * Every row that comes out carries the multipliers that prove it.
 */
#ifndef FMB_SOLVE_THIN_H
#define FMB_SOLVE_THIN_H

#include "solve/solver.h"

/* Append the irredundant rows of e's live rows, which name kept variables only, to out, with
 * claims; place[dim] is the column of a variable there. Inequalities that always hold with equality
 * become equalities. *feasible false: the rows have no solution, and nothing was appended. Rows may
 * leave e's live list. */
fmb_status fmb_thin_out(fmb_query *q, const fmb_part *p, const int *place, fmb_elim *e,
                        fmb_system *out, bool *feasible);

/* Append row r of a part, which names kept variables only, to out as a row of that relation. */
fmb_status fmb_query_append_row(fmb_query *q, const fmb_part *p, const fmb_derived *r, fmb_rel rel,
                                const int *place, fmb_system *out);

#endif
