/* portfolio.h: the projection of one part.
 *
 * Several ways lead to it; they are tried one after another, each for a while, as the selection
 * tells (selection.h; docs/theory.md, "Projections: which way"). The rows that come out are
 * irredundant, and each carries the multipliers that prove it.
 */
#ifndef FMB_SOLVE_PORTFOLIO_H
#define FMB_SOLVE_PORTFOLIO_H

#include "solve/query/solver.h"

/* Append the projection of a part to out, with claims; place[dim] is the column of a variable
 * there, -1 if it goes. *feasible false: it has no solution, and out is of no use. */
fmb_status fmb_query_project_part(fmb_query *q, int part, const int *place, fmb_system *out,
                                  bool *feasible);

#endif
