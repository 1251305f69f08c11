/* triangular.h: triangular matrices of integers, solved by substitution. */
#ifndef FMB_LP_TRIANGULAR_H
#define FMB_LP_TRIANGULAR_H

#include "lp/linalg/modular/sparse.h"

/* A matrix that rows and columns in the right order make triangular: unknowns are solved for in the
 * order of `turn`, or backwards, unknown k from row k. */
typedef struct fmb_triangular {
    const fmb_sparse *b;
    const int *turn; /* [n] */
    bool backwards;
    bool *reached; /* [n] scratch: unknowns that may not be 0 */
} fmb_triangular;

/* x[at[k]] / den = unknown k, in lowest terms together, of B x = right, right[right_at[k]] in row
 * k. False: numbers would be long, and there may be a shorter way. */
bool fmb_triangular_solve(const fmb_triangular *t, mpz_t *right, const int *right_at, const int *at,
                          mpz_t *x, mpz_t den);

#endif
