/* seidel.h: do two frames meet? By Seidel's randomised linear programming, in doubles: rows come in
 * a random order; where one cuts off the optimum of those before it, the new optimum lies on it,
 * and is found in one variable less. Expected time linear in the rows for each number of variables.
 *
 * Rounded, with a tolerance: near touching it may be wrong. For studies.
 *
 * Source: Seidel 1991.
 */
#ifndef FMB_STUDY_SEIDEL_H
#define FMB_STUDY_SEIDEL_H

#include "study/rivals/rows.h"

/* Has s a solution in the unit box? random is a state of study_splitmix, any number, and moves on.
 */
bool study_seidel_feasible(const study_rows *s, uint64_t *random);

/* The same for a pair with all axes, p with an inverse; else UNKNOWN. */
fmb_verdict study_seidel_decide(const fmb_frame *p, const fmb_frame *q, uint64_t *random);

#endif
