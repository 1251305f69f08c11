/* prime.h: arithmetic modulo a prime p = 2^61 - c, c small.
 *
 * As 2^61 = c modulo p, and 2^64 = 8c, a number of 128 bits is reduced by two short products: no
 * number is ever brought into another form, and up to FMB_PRIME_TERMS products may be added before
 * one is reduced.
 */
#ifndef FMB_NUM_PRIME_H
#define FMB_NUM_PRIME_H

#include "num/vec.h"

#define FMB_PRIME_BITS  61
#define FMB_PRIME_TERMS 64 /* products of two residues that fit into 128 bits together */

typedef struct fmb_prime {
    uint64_t p, c;
    uint64_t inverse; /* of p modulo 2^64 */
} fmb_prime;

/* x^-1 modulo 2^64, x odd: each step of Newton's method doubles the number of correct bits. */
static inline uint64_t fmb_prime_inverse_of_odd(uint64_t x)
{
    uint64_t y = 3 * x ^ 2; /* 5 bits */
    for (int k = 0; k < 4; k++)
        y *= 2 - x * y;
    return y;
}

#define FMB_PRIMES 4

/* Prime number k < FMB_PRIMES. */
static inline fmb_prime fmb_prime_number(int k)
{
    static const uint64_t c[FMB_PRIMES] = {1, 31, 45, 229};
    uint64_t p = ((uint64_t)1 << FMB_PRIME_BITS) - c[k];
    return (fmb_prime){p, c[k], fmb_prime_inverse_of_odd(p)};
}

/* x modulo p. */
static inline uint64_t fmb_prime_fold(const fmb_prime *q, fmb_u128 x)
{
    const uint64_t mask = ((uint64_t)1 << FMB_PRIME_BITS) - 1;
    fmb_u128 y = fmb_u128_product(fmb_u128_high(x), 8 * q->c);
    y = fmb_u128_plus_word(y, fmb_u128_low(x)); /* < 2^76 */
    uint64_t z = (fmb_u128_low(y) & mask) + q->c * fmb_u128_low(fmb_u128_right(y, FMB_PRIME_BITS));
    return z >= q->p ? z - q->p : z;
}

static inline uint64_t fmb_prime_times(const fmb_prime *q, uint64_t a, uint64_t b)
{
    return fmb_prime_fold(q, fmb_u128_product(a, b));
}

static inline uint64_t fmb_prime_minus(const fmb_prime *q, uint64_t a, uint64_t b)
{
    return a >= b ? a - b : a + q->p - b;
}

/* x modulo p, |x| < 2^63 - 4 c. */
static inline uint64_t fmb_prime_of_signed(const fmb_prime *q, int64_t x)
{
    const uint64_t mask = ((uint64_t)1 << FMB_PRIME_BITS) - 1;
    uint64_t y = (uint64_t)x + 4 * q->p;
    uint64_t z = (y & mask) + q->c * (y >> FMB_PRIME_BITS);
    return z >= q->p ? z - q->p : z;
}

static inline uint64_t fmb_prime_of_integer(const fmb_prime *q, mpz_srcptr x)
{
    return fmb_integer_modulo_u64(x, q->p);
}

/* Entry j of v modulo p. */
static inline uint64_t fmb_prime_of_entry(const fmb_prime *q, const fmb_vec *v, size_t j)
{
    return v->z ? fmb_prime_of_integer(q, v->z[j]) : fmb_prime_of_signed(q, v->s[j]);
}

/* a^-1 modulo p by Euclid's algorithm; a is not 0. */
static inline uint64_t fmb_prime_inverse(const fmb_prime *q, uint64_t a)
{
    uint64_t r = q->p, s = a;
    int64_t x = 0, y = 1; /* r = x a and s = y a, modulo p; |x|, |y| <= p */
    while (s > 1) {
        uint64_t quotient = r / s, rest = r % s;
        int64_t next = x - (int64_t)quotient * y;
        r = s;
        s = rest;
        x = y;
        y = next;
    }
    return y < 0 ? (uint64_t)y + q->p : (uint64_t)y;
}

/* sum - (the sum of a[t] b[index[t]], t < n), modulo p; index NULL: of a[t] b[t]. */
static inline uint64_t fmb_prime_minus_dot(const fmb_prime *q, uint64_t sum, const uint64_t *a,
                                           const uint64_t *b, const int *index, size_t n)
{
    uint64_t total = 0;
    while (n > 0) {
        size_t part = n < FMB_PRIME_TERMS - 1 ? n : FMB_PRIME_TERMS - 1;
        fmb_u128 x = fmb_u128_of(total);
        for (size_t t = 0; t < part; t++)
            x = fmb_u128_plus_product(x, a[t], b[index ? (size_t)index[t] : t]);
        total = fmb_prime_fold(q, x);
        a += part;
        if (index)
            index += part;
        else
            b += part;
        n -= part;
    }
    return fmb_prime_minus(q, sum, total);
}

#endif
