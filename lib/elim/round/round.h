/* round.h: the steps of a round, shared by the files of this folder. */
#ifndef FMB_ELIM_ROUND_H
#define FMB_ELIM_ROUND_H

#include "elim/store/store.h"

/* order.c: note in e->candidates the variables with drop[var] that are not eliminated yet. */
void fmb_elim_note_candidates(fmb_elim *e, const bool *drop);
/* The one of them to eliminate next; -1: none. *growth: how many rows more its pairs make than rows
 * are removed with it; 0 if it is in an equality. */
fmb_status fmb_elim_choose(fmb_elim *e, int *var, double *growth);

/* base.c: make the box; a row that it refutes is a clash. Else rules drop rows, and the i-th live
 * row becomes base row i, its own history. */
fmb_status fmb_elim_start_histories(fmb_elim *e);

/* combine.c: derive a row from p and q by cancelling var, and append it to the next live rows
 * unless it is trivial or a rule drops it. */
fmb_status fmb_elim_combine(fmb_elim *e, uint32_t p, uint32_t q, int var);

/* pairs.c: eliminate a variable by pairing: every row of the round contains it, the lower rows come
 * first. Continues from e->at.next. */
fmb_status fmb_elim_pair(fmb_elim *e, const fmb_round *round);
/* Is it time to pause? Also sets e->paused. */
bool fmb_elim_is_slice_over(fmb_elim *e);
/* squeeze.c: the same for the last variable, when the rows of the round contain no other: combines
 * only the tightest bounds. */
fmb_status fmb_elim_squeeze(fmb_elim *e, const fmb_round *round, size_t lowers);

#endif
