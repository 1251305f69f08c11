/* minors.h: small square matrices of integers, factored once without fractions.
 *
 * Every number of the factors is a minor of the matrix, and every one of a solution is, too: they
 * are as long as Cramer's rule says, while lifting goes through a prime for the digits of both
 * sides of a fraction. Factors are shared by all right sides, and by the transposed matrix.
 *
 * Sources: Bareiss 1968, Sylvester's identity and multistep integer-preserving Gaussian
 * elimination; Nakos, Turner, Williams 1997, Fraction-free algorithms for linear and polynomial
 * equations.
 */
#ifndef FMB_LP_MINORS_H
#define FMB_LP_MINORS_H

#include "lp/linalg/modular/sparse.h"
#include "num/integers.h"
#include "trace/run.h"

typedef struct fmb_minors {
    size_t n;
    fmb_integers at; /* [n][n] the factors; row and column k of step k, with the pivot between */
    fmb_integers y;  /* [n + 1] scratch */
} fmb_minors;

/* Is b so small that this is quicker than lifting? */
bool fmb_minors_suit(const fmb_sparse *b);

/* Both ask at each row whether to go on: where entries are long, a row may take long.
 *
 * Factor b, whose leading minors are not 0. An empty one is all zeros; what f held is gone, but its
 * memory is used again. Errors: MEMORY, LIMIT. In any case fmb_minors_clear it. */
fmb_status fmb_minors_factor(fmb_minors *f, const fmb_sparse *b, fmb_run *run);
void fmb_minors_clear(fmb_minors *f, fmb_mem *mem);

/* x[at[k]] / den = unknown k, in lowest terms together, den > 0, of B x = right, or where
 * `transposed` of B^T x = right, right[right_at[k]] in row k. Errors: LIMIT. */
fmb_status fmb_minors_solve(fmb_minors *f, fmb_run *run, bool transposed, mpz_t *right,
                            const int *right_at, const int *at, mpz_t *x, mpz_t den);

#endif
