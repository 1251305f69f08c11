/* gcd.h: greatest common divisors of machine integers, by shifts and subtractions (Stein 1967). */
#ifndef FMB_NUM_GCD_H
#define FMB_NUM_GCD_H

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

#endif
