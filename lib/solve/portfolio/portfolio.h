/* portfolio.h: the projection of one part.
 *
 * Several engines can compute it; they run in turns, in an order and with budgets that the
 * selection decides (selection.h; docs/theory.md, "Projections: which way"). The resulting rows are
 * irredundant, and each carries the multipliers that prove it.
 */
#ifndef FMB_SOLVE_PORTFOLIO_H
#define FMB_SOLVE_PORTFOLIO_H

#include "solve/query/solver.h"

/* Append the projection of a part to out, with claims; place[dim]: the column of a variable there,
 * -1 if it is eliminated. *feasible false: the part has no solution, and out has no meaning. */
fmb_status fmb_query_project_part(fmb_query *q, int part, const int *place, fmb_system *out,
                                  bool *feasible);

#endif
