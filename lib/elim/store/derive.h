/* derive.h: multipliers over the base rows, read from the derivation of a row. */
#ifndef FMB_ELIM_DERIVE_H
#define FMB_ELIM_DERIVE_H

#include "elim/store/store.h"
#include "num/weights.h"

/* Replace the rows in w by the base rows they are derived from, without changing the combination.
 * Each base row appears once; weights of inequalities keep their sign. */
fmb_status fmb_elim_derive(const fmb_elim *e, fmb_weights *w);

#endif
