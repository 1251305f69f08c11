/* with_ppl.h: systems for and from the Parma Polyhedra Library, by its C interface. */
#ifndef FMB_BENCH_WITH_PPL_H
#define FMB_BENCH_WITH_PPL_H

#include <ppl_c.h>

#include "peers.h"

/* [give] a.x of the row, or -a.x, the right side added or not. */
ppl_Linear_Expression_t ppl_expression(const problem_row *r, int n, bool negate, bool constant);

/* [give] All rows: b - a.x >= 0, > 0 or = 0. */
ppl_Constraint_System_t ppl_rows(const problem *p);

/* [give] Constraints on the first n variables as a system. */
fmb_system *ppl_system(ppl_const_Constraint_System_t rows, int n);

#endif
