/* active_test.h: redundancy tests on few rows at a time. */
#ifndef FMB_LP_ACTIVE_TEST_H
#define FMB_LP_ACTIVE_TEST_H

#include "lp/redundancy/slack.h"

/* fmb_lp_test, where many rows may be asleep: x[n] gets the point of a violation, which satisfies
 * them too. center[n] is roughly a point inside: rows are activated where the way from it to a
 * violation first meets one. */
fmb_status fmb_lp_test_active(fmb_lp *lp, size_t i, const double *center, mpq_t *x,
                              fmb_lp_end *end);

/* Put every basic slack of an inequality that counts to sleep: pivots then cost nothing for it. */
void fmb_lp_deactivate(fmb_lp *lp);
/* Add the current point to sum[n], roughly. */
void fmb_lp_add_point(const fmb_lp *lp, double *sum);

#endif
