/* dense_lu.h: LU factors modulo p of a dense matrix, in the order of Crout, with rank.
 *
 * Each entry is one long sum of products, reduced once in 64 terms. A column without a pivot moves
 * to the end; rows without one are left at the end.
 */
#ifndef FMB_LP_DENSE_LU_H
#define FMB_LP_DENSE_LU_H

#include "base/arena.h"
#include "num/prime.h"
#include "trace/run.h"

typedef struct fmb_dense_lu {
    size_t rows, columns, rank;
    int *row, *column; /* [rows], [columns] what stands there, in the caller's numbers */
    uint64_t *at;      /* [rows][columns] multipliers below the pivots, the upper factor above */
    uint64_t *across;  /* [columns][rows] the upper factor by columns */
    uint64_t *inverse; /* [rank] of the pivots */
} fmb_dense_lu;

/* All zeros. Errors: MEMORY, LIMIT. */
fmb_status fmb_dense_lu_open(fmb_dense_lu *d, fmb_arena *arena, size_t rows, size_t columns);
/* Factor. Errors: LIMIT. */
fmb_status fmb_dense_lu_factor(fmb_dense_lu *d, fmb_run *run, const fmb_prime *q);

#endif
