/* parallel_rows.h: rows that say the same in the same direction, found by hashing. */
#ifndef FMB_LP_PARALLEL_ROWS_H
#define FMB_LP_PARALLEL_ROWS_H

#include "lp/model/row.h"
#include "lp/redundancy/irredundant.h"

/* Of rows whose coefficients are multiples of one another by positive factors, one is left: an
 * equality, or the tightest inequality, of equal ones the first. Two equalities are left to others
 * unless they are equal. fate[m] of those that go becomes REDUNDANT, and told (or NULL) hears of
 * it. Rows with another fate do not count. Errors: MEMORY, LIMIT. */
fmb_status fmb_drop_parallel_rows(fmb_run *run, size_t n, size_t m, const fmb_lp_row *row,
                                  fmb_fate *fate, const fmb_verdicts *told);

#endif
