/* seidel.h: do two frames meet? By Seidel's randomised linear programming, in doubles: rows are
 * added in random order; if one cuts off the optimum so far, the new optimum lies on it, and is
 * found in one variable less. The expected time is linear in the rows for a fixed number of
 * variables.
 *
 * Rounded, with a tolerance: near touching it may be wrong. For studies.
 *
 * Source: Seidel 1991.
 */
#ifndef FMB_STUDY_SEIDEL_H
#define FMB_STUDY_SEIDEL_H

#include "study/rivals/rows.h"

/* Has s a solution in the unit box? random is a state of study_splitmix, which advances. */
bool study_seidel_feasible(const study_rows *s, uint64_t *random);

/* The verdict on a pair with all axes; UNKNOWN if p has no inverse. */
fmb_verdict study_seidel_decide(const fmb_frame *p, const fmb_frame *q, uint64_t *random);

#endif
