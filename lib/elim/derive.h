/* derive.h: multipliers over the base rows, read from the derivation of a row. */
#ifndef FMB_ELIM_DERIVE_H
#define FMB_ELIM_DERIVE_H

#include "elim/elim.h"

/* Multipliers over rows of the store: value[i] counts for row index[i]. */
typedef struct fmb_weights {
    uint32_t *index;
    mpq_t *value;
    size_t size, index_capacity, value_capacity;
} fmb_weights;

/* Append (row, value); value is copied. */
fmb_status fmb_weights_add(fmb_weights *w, uint32_t row, const mpq_t value, fmb_mem *mem);
void fmb_weights_clear(fmb_weights *w, fmb_mem *mem);

/* Replace the rows named in w by the base rows they come from: the combination stays the same. Each
 * base row appears once; weights of inequalities keep their sign. */
fmb_status fmb_elim_derive(const fmb_elim *e, fmb_weights *w);

#endif
