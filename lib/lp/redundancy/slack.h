/* slack.h: what one row means to the others: is it implied, is it always tight. */
#ifndef FMB_LP_SLACK_H
#define FMB_LP_SLACK_H

#include "lp/dictionary/exact_simplex.h"

/* From a feasible dictionary: is the inequality i implied by the other rows that count? OPTIMUM:
 * yes, and the row is relaxed; VIOLATED: no. Never UNBOUNDED. The dictionary is feasible again
 * afterwards (call fmb_lp_restore once the answer has been read). */
fmb_status fmb_lp_test(fmb_lp *lp, size_t i, fmb_lp_end *end);
fmb_status fmb_lp_restore(fmb_lp *lp);

/* From a feasible dictionary: make slack i as large as possible, stopping early once it is positive
 * in the limit delta = 0. OPTIMUM: it is 0 everywhere; UNBOUNDED: it can be positive. */
fmb_status fmb_lp_widen_slack(fmb_lp *lp, size_t i, fmb_lp_end *end);

/* Hold slack i at 0 from now on (it is 0 everywhere): its row counts as an equality. *depends: it
 * is a combination of rows locked before (fmb_lp_dependence reads it) and was relaxed instead. */
fmb_status fmb_lp_lock(fmb_lp *lp, size_t i, bool *depends);

/* Is slack i positive at the current point, in the limit delta = 0? */
bool fmb_lp_is_slack(const fmb_lp *lp, size_t i);

#endif
