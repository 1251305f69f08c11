/* minors.h: small square matrices of integers, factored once without fractions.
 *
 * All numbers of the factors and of a solution are minors of the matrix: they are no longer than by
 * Cramer's rule, while lifting modulo a prime needs the digits of numerator and denominator
 * together. All right sides, and the transposed matrix, share the factors.
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
    fmb_integers at; /* [n][n] the factors; row and column k of step k, and the pivot */
    fmb_integers y;  /* [n + 1] scratch */
} fmb_minors;

/* Is b so small that minors are faster than lifting? */
bool fmb_minors_suit(const fmb_sparse *b);

/* Both functions poll after each row: with long entries a row may take long.
 *
 * Factor b, whose leading minors are not 0. The old factors are lost, but their memory is reused.
 * Errors: MEMORY, LIMIT. f may be all zeros; call fmb_minors_clear even after an error. */
fmb_status fmb_minors_factor(fmb_minors *f, const fmb_sparse *b, fmb_run *run);
void fmb_minors_clear(fmb_minors *f, fmb_mem *mem);

/* Solve B x = right, or B^T x = right if `transposed`, with right[right_at[k]] in row k: unknown k
 * is x[at[k]] / den, in lowest terms together, den > 0. Errors: LIMIT. */
fmb_status fmb_minors_solve(fmb_minors *f, fmb_run *run, bool transposed, mpz_t *right,
                            const int *right_at, const int *at, mpz_t *x, mpz_t den);

#endif
