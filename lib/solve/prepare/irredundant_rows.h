/* irredundant_rows.h: the irredundant ones among the live rows of an elimination.
 *
 * Every resulting row carries the multipliers that prove it.
 */
#ifndef FMB_SOLVE_IRREDUNDANT_ROWS_H
#define FMB_SOLVE_IRREDUNDANT_ROWS_H

#include "solve/query/solver.h"

/* Append the irredundant rows of e's live rows, which name kept variables only, to out, with
 * claims; place[dim] is the column of a variable there. Implicit equalities are appended as
 * equalities. *feasible false: the rows have no solution (impossible if the part is known to be
 * feasible), and nothing was appended. Rows may leave e's live list. */
fmb_status fmb_irredundant_rows_append(fmb_query *q, const fmb_part *p, const int *place,
                                       fmb_elim *e, bool known, fmb_system *out, bool *feasible);

#endif
