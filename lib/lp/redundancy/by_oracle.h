/* by_oracle.h: which rows of a feasible system can go, by linear programs that are guessed in
 * doubles and certified: for sparse systems, and for those that leave no point strictly inside.
 *
 * The three passes of irredundant.h, with the same outcome. Rows must not be strict.
 */
#ifndef FMB_LP_BY_ORACLE_H
#define FMB_LP_BY_ORACLE_H

#include "lp/oracle/oracle.h"
#include "lp/redundancy/irredundant.h"

/* Are linear programs that are guessed quicker than pivots of a dictionary? False if some row is
 * strict. */
bool fmb_suits_oracle(size_t n, size_t m, const fmb_lp_row *row);

/* fate[m] and told as fmb_irredundant has them; rows are feasible. Errors: MEMORY, LIMIT. */
fmb_status fmb_irredundant_by_oracle(fmb_run *run, size_t n, size_t m, const fmb_lp_row *row,
                                     fmb_fate *fate, const fmb_verdicts *told);
/* As fmb_redundant: inequalities stay what they are. */
fmb_status fmb_redundant_by_oracle(fmb_run *run, size_t n, size_t m, const fmb_lp_row *row,
                                   fmb_fate *fate);

#endif
