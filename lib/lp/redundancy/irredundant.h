/* irredundant.h: removes redundant rows, one after another, by linear programs.
 *
 * Three passes remove equalities that depend on others; turn inequalities that always hold with
 * equality into equalities (or remove those that depend on others); and remove every inequality
 * that the remaining rows imply. Each proof names remaining rows only, so the removals are sound in
 * their order. Source: Schrijver 1986, section 8.1; Fukuda, Frequently asked questions in
 * polyhedral computation, 2.21.
 */
#ifndef FMB_LP_IRREDUNDANT_H
#define FMB_LP_IRREDUNDANT_H

#include <fmb/solve.h>

#include "lp/model/row.h"
#include "lp/redundancy/verdicts.h"
#include "trace/run.h"

/* fate[m] is UNKNOWN on entry; or REDUNDANT for rows removed before, or KEPT for inequalities known
 * to be irredundant and not always tight, which are not tested. told may be NULL.
 * *feasible false: there is no solution, and fates have no meaning. On LIMIT the fates set so far
 * hold. Errors: MEMORY, LIMIT. */
fmb_status fmb_irredundant(fmb_run *run, size_t n, size_t m, const fmb_lp_row *row, fmb_fate *fate,
                           const fmb_verdicts *told, bool *feasible);

/* Like the function above without the second pass: no inequality becomes an equality. If paused is
 * not NULL, *paused is NULL at the first call. At the end of a slice of the run the function
 * returns with *paused not NULL: call it again with the same rows and fates to go on, or close
 * *paused. */
fmb_status fmb_redundant(fmb_run *run, size_t n, size_t m, const fmb_lp_row *row,
                         fmb_pruner **paused, fmb_fate *fate, bool *feasible);
void fmb_pruner_close(fmb_pruner *paused);

#endif
