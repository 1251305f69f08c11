/* rank.h: is a combination of base rows minimal? */
#ifndef FMB_ELIM_RANK_H
#define FMB_ELIM_RANK_H

#include "elim/elim.h"

/* Is rank(A_{H,O}) = |H| - 1, with H the history of r and O the columns eliminated since the base?
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_elim_minimal(const fmb_elim *e, const fmb_derived *r, bool *minimal);

#endif
