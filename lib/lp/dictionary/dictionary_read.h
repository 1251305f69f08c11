/* dictionary_read.h: what a dictionary says, and its proof, where the last program stopped. */
#ifndef FMB_LP_DICTIONARY_READ_H
#define FMB_LP_DICTIONARY_READ_H

#include "lp/dictionary/dictionary.h"
#include "num/weights.h"

/* Multipliers over the rows whose combination reads 0 <= negative or 0 < 0. */
fmb_status fmb_lp_conflict(const fmb_lp *lp, fmb_weights *w);
/* Multipliers y with sum_i y_i (b_i - a_i.x) = constant - sign * B, B the variable last pushed (an
 * x_j, or the slack of a test): they prove the optimum. */
fmb_status fmb_lp_optimum(const fmb_lp *lp, int sign, fmb_weights *w);
/* B = K/d + D/d delta: the optimum itself; *step gets the sign of D. */
void fmb_lp_value(const fmb_lp *lp, mpq_t value, int *step);
/* A point that satisfies every row that counts; with `closure`, the limit delta = 0. x[n]. */
fmb_status fmb_lp_point(const fmb_lp *lp, bool closure, mpq_t *x);
/* The point that a test found: satisfies the other rows, violates the one tested. */
fmb_status fmb_lp_violation(const fmb_lp *lp, mpq_t *x);
/* The direction of an UNBOUNDED push. */
void fmb_lp_ray(const fmb_lp *lp, mpq_t *x);

#endif
