/* long_gcd.h: greatest common divisors that somebody may wait for. */
#ifndef FMB_NUM_LONG_GCD_H
#define FMB_NUM_LONG_GCD_H

#include <gmp.h>

#include "base/poll.h"

/* From so many bits of both numbers on whether to go on is asked on the way, every few hundredths
 * of a second; up to here mpz_gcd takes no longer. */
#define FMB_LONG_BITS ((size_t)1 << 19)

/* out = gcd(a, b), which may be the same. Errors: what poll says; then out is as it was. */
fmb_status fmb_long_gcd(mpz_t out, const mpz_t a, const mpz_t b, const fmb_poll *poll);
/* x = x / by in lowest terms; by is not 0. Errors: what poll says; then x is as it was. */
fmb_status fmb_long_divide(mpq_t x, const mpz_t by, const fmb_poll *poll);

#endif
