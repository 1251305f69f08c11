/* modular_lu.h: sparse LU factors modulo p of a square matrix of integers, with its rank.
 *
 * Pivots are chosen by Markowitz's rule (markowitz.h): bases of linear programs are nearly
 * triangular. Where they are not, a switch to dense rows saves little.
 *
 * Order: pivot k is in row row_at[k] and column column_at[k]; in that order the matrix is lower
 * times upper. From number `rank` on there are no pivots but dependent rows, paired with columns
 * left over: they are factored as if row row_at[k] were the unit vector of column_at[k].
 *
 * A pivot that is alone in its row when chosen has entries in its own column and in those of such
 * pivots before it; one alone in its column may have any. So if all are of these kinds, the matrix
 * is triangular in the order of `turn`: pivots alone in rows, in order, then the others, backwards.
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
    int *turn;          /* [n] then: pivots in the order of solving for unknowns */
} fmb_modular_lu;

/* The factors are in `lasting`, scratch is in `passing`. Errors: MEMORY, LIMIT. */
fmb_status fmb_modular_lu_factor(fmb_modular_lu *f, fmb_run *run, fmb_arena *lasting,
                                 fmb_arena *passing, const fmb_sparse *a, const fmb_prime *q);

#endif
