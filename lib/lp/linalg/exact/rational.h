/* rational.h: rational reconstruction from residues.
 *
 * Sources: Wang 1981, A p-adic algorithm for univariate partial fractions; Lehmer 1938, Euclid's
 * algorithm for large numbers.
 */
#ifndef FMB_LP_RATIONAL_H
#define FMB_LP_RATIONAL_H

#include <gmp.h>
#include <stdbool.h>

#include "base/poll.h"

typedef struct fmb_rational {
    mpz_t r, s, x, y, t, u; /* scratch */
} fmb_rational;

void fmb_rational_init(fmb_rational *w);
void fmb_rational_clear(fmb_rational *w);

/* a / b = y modulo m, 0 <= y < m, in lowest terms with |a| < 2^a_bits and 0 < b < 2^b_bits; there
 * is at most one if a_bits + b_bits < the bits of m - 1. poll, unless NULL, is asked meanwhile.
 * False: there is none, or poll has ended the search. */
bool fmb_rational_find(fmb_rational *w, const mpz_t y, const mpz_t m, size_t a_bits, size_t b_bits,
                       mpz_t a, mpz_t b, const fmb_poll *poll);

#endif
