/* history.h: which base rows a row was combined from, and what follows from that.
 *
 * The history of a row is the set of base rows with a positive multiplier in it, followed in memory
 * by the set of variables effectively eliminated on the way. A combination has the unions of its
 * parents' sets; the variable just cancelled joins the latter.
 */
#ifndef FMB_ELIM_HISTORY_H
#define FMB_ELIM_HISTORY_H

#include "elim/store/store.h"

/* Memory for a history and its variables; NULL on failure. */
uint64_t *fmb_history_get(fmb_elim *e);

/* Each base row becomes its own history. Errors: MEMORY, LIMIT. */
fmb_status fmb_history_number_base(fmb_elim *e);

/* Set the history of r, just combined from p and q; does nothing while no histories are kept. */
fmb_status fmb_history_join(fmb_elim *e, fmb_derived *r, const fmb_derived *p,
                            const fmb_derived *q);

/* out[var_words] = the variables of the base rows of r that are neither in r nor effectively
 * eliminated. */
void fmb_history_implicit(const fmb_elim *e, const fmb_derived *r, uint64_t *out);

/* rank.c: is r minimal, that is, rank(A_{H,O}) = |H| - 1, with H its history and O the variables
 * eliminated since the base? Errors: MEMORY, LIMIT. */
fmb_status fmb_elim_minimal(const fmb_elim *e, const fmb_derived *r, bool *minimal);

#endif
