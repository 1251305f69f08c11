/* integral.h: which claims also hold over the integers, for systems with integer variables. */
#ifndef FMB_PROOF_INTEGRAL_H
#define FMB_PROOF_INTEGRAL_H

#include "proof/evidence/evidence.h"

/* Is the point integral in all integer variables? */
bool fmb_point_is_integral(const fmb_system *s, const fmb_sparse_vector *point);
/* Does a claim that holds over the reals also hold if solutions must be integral in all integer
 * variables? Combined rows and equalities hold for all solutions, so for these. A point proves its
 * claim if it is integral there; from such a point, a rational ray meets infinitely many others:
 * `solution` says whether some accepted claim FEASIBLE has one. A projection keeps its meaning if
 * all integer variables are kept. CORNER is about the rows alone. */
bool fmb_claim_is_integral(const fmb_system *s, const fmb_claim *q, bool solution);

#endif
