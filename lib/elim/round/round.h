/* round.h: the steps of a round, for the files of this folder. */
#ifndef FMB_ELIM_ROUND_H
#define FMB_ELIM_ROUND_H

#include "elim/store/store.h"

/* order.c: the variable to eliminate next among those with drop[var] and not yet done; -1: none. */
fmb_status fmb_elim_choose(fmb_elim *e, const bool *drop, int *var);
/* How many more rows pairs make than go with the variable; 0 where it stands in an equality. */
double fmb_elim_growth(const fmb_elim *e, int var);

/* base.c: the box is made, rows go that it or a rule refutes, and live rows become their own
 * histories: the i-th live row is base row i. */
fmb_status fmb_elim_start_histories(fmb_elim *e);

/* combine.c: append a row derived from p and q by cancelling var to the next live rows. Rows that
 * say nothing, or that a rule drops, are not kept. */
fmb_status fmb_elim_combine(fmb_elim *e, uint32_t p, uint32_t q, int var);

/* pairs.c: eliminate a variable by pairing: every row of the round names it, lowers come first.
 * Goes on from e->at.next. */
fmb_status fmb_elim_pair(fmb_elim *e, const fmb_round *round);
/* Is it time to pause? Notes that in e->paused. */
bool fmb_elim_is_slice_over(fmb_elim *e);
/* squeeze.c: the same for the last variable, when every row of the round names no other: only the
 * tightest bounds are combined. */
fmb_status fmb_elim_squeeze(fmb_elim *e, const fmb_round *round, size_t lowers);

#endif
