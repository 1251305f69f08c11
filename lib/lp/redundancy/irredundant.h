/* irredundant.h: which of some rows can go, one after another, by linear programs.
 *
 * Three passes: equalities that depend on others go; inequalities that always hold with equality
 * become equalities (or go, if they depend on others); every other inequality that the rows still
 * there imply goes. A row is proved redundant from rows not yet gone, so the removals are sound in
 * their order. Source: Schrijver 1986, section 8.1; Fukuda, Frequently asked questions in
 * polyhedral computation, 2.21.
 */
#ifndef FMB_LP_IRREDUNDANT_H
#define FMB_LP_IRREDUNDANT_H

#include <fmb/solve.h>

#include "lp/model/row.h"
#include "lp/redundancy/verdicts.h"
#include "trace/run.h"

/* fate[m] comes in UNKNOWN; or REDUNDANT for rows that have gone, or KEPT for inequalities that are
 * known to be irredundant and not always tight: those are not looked at. told may be NULL.
 * *feasible false: there is no solution, and nothing else is said. On LIMIT the fates set so far
 * hold. Errors: MEMORY, LIMIT. */
fmb_status fmb_irredundant(fmb_run *run, size_t n, size_t m, const fmb_lp_row *row, fmb_fate *fate,
                           const fmb_verdicts *told, bool *feasible);

/* The same without the second pass: inequalities stay what they are, and only their redundancy is
 * decided. Where paused is not NULL, begin with *paused NULL. It stops where a slice of the run is
 * over, *paused not NULL: the next call with it goes on, with the same rows and fates, or close it.
 */
fmb_status fmb_redundant(fmb_run *run, size_t n, size_t m, const fmb_lp_row *row,
                         fmb_pruner **paused, fmb_fate *fate, bool *feasible);
void fmb_pruner_close(fmb_pruner *paused);

#endif
