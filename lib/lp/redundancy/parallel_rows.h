/* parallel_rows.h: finds rows with parallel left sides by hashing. */
#ifndef FMB_LP_PARALLEL_ROWS_H
#define FMB_LP_PARALLEL_ROWS_H

#include "lp/model/row.h"
#include "lp/redundancy/irredundant.h"

/* Of rows whose coefficients are positive multiples of one another, one is kept: an equality, or
 * the tightest inequality, the first of equal ones. Two different equalities are both left alone.
 * fate[m] of removed rows becomes REDUNDANT, and told (or NULL) is notified. Rows with another fate
 * than UNKNOWN do not count. Errors: MEMORY, LIMIT. */
fmb_status fmb_drop_parallel_rows(fmb_run *run, size_t n, size_t m, const fmb_lp_row *row,
                                  fmb_fate *fate, const fmb_verdicts *told);

#endif
