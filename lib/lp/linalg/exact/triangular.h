/* triangular.h: triangular matrices of integers, solved by substitution. */
#ifndef FMB_LP_TRIANGULAR_H
#define FMB_LP_TRIANGULAR_H

#include "lp/linalg/modular/sparse.h"

/* A matrix that a suitable order of rows and columns makes triangular: unknowns are solved for in
 * the order of `turn`, or backwards, unknown k from row k. */
typedef struct fmb_triangular {
    const fmb_sparse *b;
    const int *turn; /* [n] */
    bool backwards;
    bool *reached; /* [n] scratch: unknowns that may be nonzero */
} fmb_triangular;

/* Solve B x = right, with right[right_at[k]] in row k: unknown k is x[at[k]] / den, in lowest terms
 * together. False: the numbers would be long, and another way may be faster. */
bool fmb_triangular_solve(const fmb_triangular *t, mpz_t *right, const int *right_at, const int *at,
                          mpz_t *x, mpz_t den);

#endif
