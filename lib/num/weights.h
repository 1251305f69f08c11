/* weights.h: multipliers over numbered rows: value[i] counts for row index[i]. */
#ifndef FMB_NUM_WEIGHTS_H
#define FMB_NUM_WEIGHTS_H

#include <gmp.h>

#include "base/mem.h"

typedef struct fmb_weights {
    uint32_t *index;
    mpq_t *value;
    size_t size, index_capacity, value_capacity;
} fmb_weights;

/* Append (row, value); value is copied. Errors: MEMORY, LIMIT. */
fmb_status fmb_weights_add(fmb_weights *w, uint32_t row, const mpq_t value, fmb_mem *mem);
void fmb_weights_clear(fmb_weights *w, fmb_mem *mem);

#endif
