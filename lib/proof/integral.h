/* integral.h: which claims are true of integers, too, where a system has integer variables. */
#ifndef FMB_PROOF_INTEGRAL_H
#define FMB_PROOF_INTEGRAL_H

#include "proof/evidence/evidence.h"

/* Is the point integral in all integer variables? */
bool fmb_point_is_integral(const fmb_system *s, const fmb_sparse_vector *point);
/* Is a right claim right when solutions are those integral in all integer variables, too? Combined
 * rows and equalities hold for all solutions, so for these. A point shows something if it is one of
 * them; from such a one, a ray of rationals meets others without end: solution tells whether some
 * right claim FEASIBLE has one. A projection keeps its meaning if all integer variables are kept.
 * CORNER tells of the rows alone. */
bool fmb_claim_is_integral(const fmb_system *s, const fmb_claim *q, bool solution);

#endif
