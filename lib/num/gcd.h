/* gcd.h: greatest common divisors; of machine integers by shifts and subtractions (Stein 1967). */
#ifndef FMB_NUM_GCD_H
#define FMB_NUM_GCD_H

#include "base/poll.h"
#include <gmp.h>
#include <stdint.h>

/* gcd(a, b), with gcd(a, 0) = a. */
static inline uint64_t fmb_gcd64(uint64_t a, uint64_t b)
{
    if (a == 0 || b == 0)
        return a | b;
    int shift = __builtin_ctzll(a | b);
    a >>= __builtin_ctzll(a);
    do {
        b >>= __builtin_ctzll(b);
        uint64_t low = a < b ? a : b;
        b = a < b ? b - a : a - b;
        a = low;
    } while (b != 0);
    return a << shift;
}

/* Number of bits of v: the least k with v < 2^k. */
static inline int fmb_bits64(uint64_t v)
{
    return v == 0 ? 0 : 64 - __builtin_clzll(v);
}

/* |v| without overflow. */
static inline uint64_t fmb_abs64(int64_t v)
{
    return v < 0 ? 0 - (uint64_t)v : (uint64_t)v;
}

/* ---- of long integers, with a poll ----------------------------------------------------------- */

/* If both numbers have at least this many bits, the functions below poll every few hundredths of a
 * second; for shorter numbers one call of mpz_gcd takes no longer than that. */
#define FMB_LONG_BITS ((size_t)1 << 19)

/* out = gcd(a, b); out may be a or b. Errors: the status of poll; then out is unchanged. */
fmb_status fmb_long_gcd(mpz_t out, const mpz_t a, const mpz_t b, const fmb_poll *poll);
/* x = x / by in lowest terms; by is not 0. Errors: the status of poll; then x is unchanged. */
fmb_status fmb_long_divide(mpq_t x, const mpz_t by, const fmb_poll *poll);

#endif
