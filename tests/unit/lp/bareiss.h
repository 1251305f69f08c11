/* bareiss.h: fraction-free elimination on dense matrices (Bareiss 1968), the ground truth for
 * sparse ones. */
#ifndef FMB_TEST_BAREISS_H
#define FMB_TEST_BAREISS_H

#include <gmp.h>

/* n numbers, 0; give them back. */
mpz_t *bareiss_numbers(size_t n);
void bareiss_free(mpz_t *z, size_t n);
/* Of a[n][n], which stays. */
size_t bareiss_rank(mpz_t *a, size_t n);
/* x / den with A x = den right, in lowest terms; A is regular. */
void bareiss_solve(mpz_t *a, size_t n, mpz_t *right, mpz_t *x, mpz_t den);

#endif
