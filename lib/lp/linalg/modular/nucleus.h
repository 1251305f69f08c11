/* nucleus.h: LU factors modulo p of a sparse matrix that has no order to begin with.
 *
 * While there are zeros enough, elimination fills in little (markowitz.h). Once the rest is dense,
 * it is factored as such (dense_lu.h).
 */
#ifndef FMB_LP_NUCLEUS_H
#define FMB_LP_NUCLEUS_H

#include "lp/linalg/markowitz.h"
#include "lp/linalg/modular/dense_lu.h"

typedef struct fmb_nucleus {
    const fmb_prime *q;
    fmb_markowitz sparse;
    fmb_dense_lu dense; /* the rest */
} fmb_nucleus;

/* No rows yet. Errors: MEMORY, LIMIT. */
fmb_status fmb_nucleus_open(fmb_nucleus *u, fmb_run *run, fmb_arena *arena, const fmb_prime *q,
                            size_t size, size_t entries);
/* Append an entry to the row that is being filled, i; rows are filled one after the other. */
static inline void fmb_nucleus_put(fmb_nucleus *u, int i, int column, uint64_t value)
{
    fmb_markowitz_put(&u->sparse, i, column, (fmb_number){.residue = value});
}
/* Factor. Errors: MEMORY, LIMIT. */
fmb_status fmb_nucleus_factor(fmb_nucleus *u);

#endif
