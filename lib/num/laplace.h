/* laplace.h: minors of integer matrices modulo 2^64 (one word) or 2^128 (two words), in two's
 * complement. With one word the upper half is meaningless.
 */
#ifndef FMB_NUM_LAPLACE_H
#define FMB_NUM_LAPLACE_H

#include "num/int128.h"

#define FMB_WORDS_INLINE static inline __attribute__((always_inline, unused))

FMB_WORDS_INLINE bool fmb_words_are_zero(int words, fmb_u128 a)
{
    return (fmb_u128_low(a) | (words == 1 ? 0 : fmb_u128_high(a))) == 0;
}

FMB_WORDS_INLINE fmb_u128 fmb_words_plus(int words, fmb_u128 a, fmb_u128 b)
{
    return words == 1 ? fmb_u128_of(fmb_u128_low(a) + fmb_u128_low(b)) : fmb_u128_plus(a, b);
}

FMB_WORDS_INLINE fmb_u128 fmb_words_minus(int words, fmb_u128 a, fmb_u128 b)
{
    return words == 1 ? fmb_u128_of(fmb_u128_low(a) - fmb_u128_low(b)) : fmb_u128_minus(a, b);
}

FMB_WORDS_INLINE fmb_u128 fmb_words_times(int words, fmb_u128 a, fmb_u128 b)
{
    return words == 1 ? fmb_u128_of(fmb_u128_low(a) * fmb_u128_low(b)) : fmb_u128_times(a, b);
}

/* Laplace expansion: minor[set] for all sets of `rows` of the n columns become those of one row
 * more, `vector`, which is the last row. Are all the new minors 0? */
FMB_WORDS_INLINE bool fmb_words_take_vector(int words, int n, int rows, const fmb_u128 *vector,
                                            fmb_u128 *minor)
{
    bool any = false;
    for (unsigned set = (2U << rows) - 1; set < 1U << n;) {
        fmb_u128 sum[2] = {fmb_u128_of(0), fmb_u128_of(0)};
        unsigned left = set;
#pragma GCC unroll 8
        for (int i = rows; i >= 0; i--, left &= left - 1) {
            const int j = __builtin_ctz(left);
            const fmb_u128 less = minor[set & ~(1U << j)];
            sum[i % 2] = fmb_words_plus(words, sum[i % 2], fmb_words_times(words, vector[j], less));
        }
        minor[set] = fmb_words_minus(words, sum[0], sum[1]);
        any |= !fmb_words_are_zero(words, minor[set]);
        const unsigned low = set & -set, carry = set + low;
        set = carry | (set ^ carry) >> (2 + __builtin_ctz(low));
    }
    return !any;
}

#endif
