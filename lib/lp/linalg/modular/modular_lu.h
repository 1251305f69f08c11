/* modular_lu.h: sparse LU factors modulo p of a square matrix of integers, with rank.
 *
 * Pivots are taken by Markowitz's rule (markowitz.h): bases of linear programs are nearly
 * triangular. Where they are not, elimination of dense rows as such saves little.
 *
 * Order: pivot k stands in row row_at[k] and column column_at[k]; in that order the matrix is lower
 * times upper. Pivots from `rank` on are none: rows that depend on others, beside columns left
 * over. They are factored as if row row_at[k] were the unit vector of column_at[k].
 *
 * A pivot that is alone in its row, when it is taken, names columns of such pivots before it and
 * its own; one that is alone in its column, any. So if all pivots are of these kinds, the matrix is
 * triangular in the order of `turn`: those of rows, in order, then those of columns, backwards.
 */
#ifndef FMB_LP_MODULAR_LU_H
#define FMB_LP_MODULAR_LU_H

#include "lp/linalg/modular/sparse.h"
#include "lp/linalg/modular/sweep.h"
#include "trace/run.h"

typedef struct fmb_modular_lu {
    size_t n, rank;
    int *row_at, *column_at;       /* [n] */
    int *row_place, *column_place; /* [n] the inverse of these */
    fmb_sweep lower, upper;
    bool is_triangular; /* all pivots were alone */
    int *turn;          /* [n] then: pivots in the order in which unknowns are solved for */
} fmb_modular_lu;

/* The factors lie in lasting, scratch in passing. Errors: MEMORY, LIMIT. */
fmb_status fmb_modular_lu_factor(fmb_modular_lu *f, fmb_run *run, fmb_arena *lasting,
                                 fmb_arena *passing, const fmb_sparse *a, const fmb_prime *q);

#endif
