/* modular_lu.h: sparse LU factors modulo p of a square matrix of integers, with rank.
 *
 * Bases of linear programs are nearly triangular. So a row with one entry in what is left is taken
 * first, or a column: neither makes new entries, and nothing is computed. What has neither is the
 * nucleus (nucleus.h).
 *
 * Order: pivot k stands in row row_at[k] and column column_at[k]; in that order the matrix is lower
 * times upper. Pivots from `rank` on are none: rows that depend on others, beside columns left
 * over. They are factored as if row row_at[k] were the unit vector of column_at[k].
 *
 * A row that is peeled by itself names columns peeled by rows before it and its own; one that goes
 * with its column, any. So if all are peeled, the matrix is triangular in the order of `turn`: by
 * rows, in order, then by columns, backwards.
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
    bool is_triangular; /* all pivots were peeled */
    int *turn;          /* [n] then: pivots in the order in which unknowns are solved for */
} fmb_modular_lu;

/* The factors lie in lasting, scratch in passing. Errors: MEMORY, LIMIT. */
fmb_status fmb_modular_lu_factor(fmb_modular_lu *f, fmb_run *run, fmb_arena *lasting,
                                 fmb_arena *passing, const fmb_sparse *a, const fmb_prime *q);

#endif
