/* word.h: GMP integers combined with words of 64 bits. GMP's own functions take a long and return
 * limbs, both of 32 bits on some targets; there a word is converted to an integer first. This file
 * includes no room: rules include it, too.
 */
#ifndef FMB_NUM_WORD_H
#define FMB_NUM_WORD_H

#include <gmp.h>
#include <limits.h>
#include <stdbool.h>
#include <stdint.h>

#include "num/int128.h"

#if ULONG_MAX >= UINT64_MAX && GMP_NUMB_BITS == 64 && !defined FMB_WORD_PLAIN
#define FMB_WORD_IS_LONG
typedef mp_limb_t fmb_word; /* a uint64_t, perhaps another type of that size */
#else
typedef uint64_t fmb_word;
#endif

#ifdef FMB_WORD_IS_LONG

static inline void fmb_integer_set_i64(mpz_t out, int64_t x)
{
    mpz_set_si(out, x);
}
static inline void fmb_integer_set_u64(mpz_t out, uint64_t x)
{
    mpz_set_ui(out, x);
}
/* |x| modulo 2^64. */
static inline uint64_t fmb_integer_low(mpz_srcptr x)
{
    return mpz_get_ui(x);
}
static inline bool fmb_integer_is_i64(mpz_srcptr x)
{
    return mpz_fits_slong_p(x) != 0;
}
/* Sign of a - b. */
static inline int fmb_integer_compare_i64(mpz_srcptr a, int64_t b)
{
    return mpz_cmp_si(a, b);
}
static inline void fmb_integer_plus_u64(mpz_t out, mpz_srcptr a, uint64_t b)
{
    mpz_add_ui(out, a, b);
}
static inline void fmb_integer_times_u64(mpz_t out, mpz_srcptr a, uint64_t b)
{
    mpz_mul_ui(out, a, b);
}
/* sum += a b, sum -= a b */
static inline void fmb_integer_add_product_u64(mpz_t sum, mpz_srcptr a, uint64_t b)
{
    mpz_addmul_ui(sum, a, b);
}
static inline void fmb_integer_subtract_product_u64(mpz_t sum, mpz_srcptr a, uint64_t b)
{
    mpz_submul_ui(sum, a, b);
}
/* a modulo m: from 0 to m - 1. */
static inline uint64_t fmb_integer_modulo_u64(mpz_srcptr a, uint64_t m)
{
    return mpz_fdiv_ui(a, m);
}
/* out = a / b, rounded towards 0; returns the absolute value of the remainder. */
static inline uint64_t fmb_integer_divide_u64(mpz_t out, mpz_srcptr a, uint64_t b)
{
    return mpz_tdiv_q_ui(out, a, b);
}
/* out = a / b, which is known to be an integer. */
static inline void fmb_integer_divide_exactly_u64(mpz_t out, mpz_srcptr a, uint64_t b)
{
    mpz_divexact_ui(out, a, b);
}

#else

enum { FMB_LIMBS_OF_WORD = 64 / GMP_NUMB_BITS };

/* A word as a read-only integer. */
typedef struct fmb_word_integer {
    mpz_t z;
    mp_limb_t limb[FMB_LIMBS_OF_WORD];
} fmb_word_integer;

static inline mpz_srcptr fmb_word_as_integer(fmb_word_integer *room, uint64_t size, bool minus)
{
    for (int k = 0; k < FMB_LIMBS_OF_WORD; k++)
        room->limb[k] = (mp_limb_t)(size >> GMP_NUMB_BITS % 64 * k);
    return mpz_roinit_n(room->z, room->limb, minus ? -FMB_LIMBS_OF_WORD : FMB_LIMBS_OF_WORD);
}
static inline mpz_srcptr fmb_signed_word_as_integer(fmb_word_integer *room, int64_t x)
{
    return fmb_word_as_integer(room, x < 0 ? 0 - (uint64_t)x : (uint64_t)x, x < 0);
}
static inline void fmb_integer_set_i64(mpz_t out, int64_t x)
{
    fmb_word_integer room;
    mpz_set(out, fmb_signed_word_as_integer(&room, x));
}
static inline void fmb_integer_set_u64(mpz_t out, uint64_t x)
{
    fmb_word_integer room;
    mpz_set(out, fmb_word_as_integer(&room, x, false));
}
/* |x| modulo 2^64. */
static inline uint64_t fmb_integer_low(mpz_srcptr x)
{
    uint64_t low = 0;
    for (int k = 0; k < FMB_LIMBS_OF_WORD; k++)
        low |= (uint64_t)mpz_getlimbn(x, k) << GMP_NUMB_BITS % 64 * k;
    return low;
}
/* Sign of a - b. */
static inline int fmb_integer_compare_i64(mpz_srcptr a, int64_t b)
{
    fmb_word_integer room;
    return mpz_cmp(a, fmb_signed_word_as_integer(&room, b));
}
static inline bool fmb_integer_is_i64(mpz_srcptr x)
{
    return fmb_integer_compare_i64(x, INT64_MIN) >= 0 && fmb_integer_compare_i64(x, INT64_MAX) <= 0;
}
static inline void fmb_integer_plus_u64(mpz_t out, mpz_srcptr a, uint64_t b)
{
    fmb_word_integer room;
    mpz_add(out, a, fmb_word_as_integer(&room, b, false));
}
static inline void fmb_integer_times_u64(mpz_t out, mpz_srcptr a, uint64_t b)
{
    fmb_word_integer room;
    mpz_mul(out, a, fmb_word_as_integer(&room, b, false));
}
/* sum += a b, sum -= a b */
static inline void fmb_integer_add_product_u64(mpz_t sum, mpz_srcptr a, uint64_t b)
{
    fmb_word_integer room;
    mpz_addmul(sum, a, fmb_word_as_integer(&room, b, false));
}
static inline void fmb_integer_subtract_product_u64(mpz_t sum, mpz_srcptr a, uint64_t b)
{
    fmb_word_integer room;
    mpz_submul(sum, a, fmb_word_as_integer(&room, b, false));
}
/* a modulo m: from 0 to m - 1. */
static inline uint64_t fmb_integer_modulo_u64(mpz_srcptr a, uint64_t m)
{
    fmb_word_integer room;
    mpz_t rest;
    mpz_init(rest);
    mpz_fdiv_r(rest, a, fmb_word_as_integer(&room, m, false));
    uint64_t low = fmb_integer_low(rest);
    mpz_clear(rest);
    return low;
}
/* out = a / b, rounded towards 0; returns the absolute value of the remainder. */
static inline uint64_t fmb_integer_divide_u64(mpz_t out, mpz_srcptr a, uint64_t b)
{
    fmb_word_integer room;
    mpz_t rest;
    mpz_init(rest);
    mpz_tdiv_qr(out, rest, a, fmb_word_as_integer(&room, b, false));
    uint64_t low = fmb_integer_low(rest);
    mpz_clear(rest);
    return low;
}
/* out = a / b, which is known to be an integer. */
static inline void fmb_integer_divide_exactly_u64(mpz_t out, mpz_srcptr a, uint64_t b)
{
    fmb_word_integer room;
    mpz_divexact(out, a, fmb_word_as_integer(&room, b, false));
}

#endif

/* ---- made of the functions above ------------------------------------------------------------- */

/* x as an int64_t; only if fmb_integer_is_i64. */
static inline int64_t fmb_integer_get_i64(mpz_srcptr x)
{
    uint64_t size = fmb_integer_low(x);
    return (int64_t)(mpz_sgn(x) < 0 ? 0 - size : size);
}
static inline void fmb_integer_times_i64(mpz_t out, mpz_srcptr a, int64_t b)
{
    fmb_integer_times_u64(out, a, b < 0 ? 0 - (uint64_t)b : (uint64_t)b);
    if (b < 0)
        mpz_neg(out, out);
}
/* sum += a b */
static inline void fmb_integer_add_product_i64(mpz_t sum, mpz_srcptr a, int64_t b)
{
    if (b < 0)
        fmb_integer_subtract_product_u64(sum, a, 0 - (uint64_t)b);
    else
        fmb_integer_add_product_u64(sum, a, (uint64_t)b);
}
static inline void fmb_integer_set_128(mpz_t out, fmb_i128 x)
{
    fmb_u128 size = fmb_i128_size(x);
    fmb_integer_set_u64(out, fmb_u128_high(size));
    mpz_mul_2exp(out, out, 64);
    fmb_integer_plus_u64(out, out, fmb_u128_low(size));
    if (fmb_i128_sign(x) < 0)
        mpz_neg(out, out);
}

/* ---- arrays of words, least significant first ------------------------------------------------ */

#ifdef FMB_WORD_IS_LONG

/* The number of words of |x|, and word k of them. */
static inline size_t fmb_integer_words(mpz_srcptr x)
{
    return mpz_size(x);
}
static inline uint64_t fmb_integer_word(mpz_srcptr x, size_t k)
{
    return mpz_getlimbn(x, (mp_size_t)k);
}
/* w += x, w -= x, modulo 2^64 to the power of n. */
static inline void fmb_words_add(fmb_word *w, size_t n, uint64_t x)
{
    mpn_add_1(w, w, (mp_size_t)n, x);
}
static inline void fmb_words_subtract(fmb_word *w, size_t n, uint64_t x)
{
    mpn_sub_1(w, w, (mp_size_t)n, x);
}
/* w += f |x| or w -= f |x| over the words of x; returns the carry out of the highest word. */
static inline uint64_t fmb_words_add_product(fmb_word *w, mpz_srcptr x, uint64_t f)
{
    return mpn_addmul_1(w, mpz_limbs_read(x), (mp_size_t)mpz_size(x), f);
}
static inline uint64_t fmb_words_subtract_product(fmb_word *w, mpz_srcptr x, uint64_t f)
{
    return mpn_submul_1(w, mpz_limbs_read(x), (mp_size_t)mpz_size(x), f);
}
/* to = a b, where a has n words, b has m, and `to` n + m. */
static inline void fmb_words_multiply(fmb_word *to, const fmb_word *a, size_t n, const fmb_word *b,
                                      size_t m)
{
    if (n >= m)
        mpn_mul(to, a, (mp_size_t)n, b, (mp_size_t)m);
    else
        mpn_mul(to, b, (mp_size_t)m, a, (mp_size_t)n);
}
/* w += x, both of n words; returns the carry out of the highest word. */
static inline uint64_t fmb_words_add_words(fmb_word *w, const fmb_word *x, size_t n)
{
    return mpn_add_n(w, w, x, (mp_size_t)n);
}
/* w += f x or w -= f x, all of one word; returns the carry (borrow). */
static inline uint64_t fmb_word_add_product(fmb_word *w, fmb_word x, uint64_t f)
{
    return mpn_addmul_1(w, &x, 1, f);
}
static inline uint64_t fmb_word_subtract_product(fmb_word *w, fmb_word x, uint64_t f)
{
    return mpn_submul_1(w, &x, 1, f);
}

#else

/* The number of words of |x|, and word k of them. */
static inline size_t fmb_integer_words(mpz_srcptr x)
{
    return (mpz_size(x) + FMB_LIMBS_OF_WORD - 1) / FMB_LIMBS_OF_WORD;
}
static inline uint64_t fmb_integer_word(mpz_srcptr x, size_t k)
{
    uint64_t word = 0;
    for (size_t i = 0; i < FMB_LIMBS_OF_WORD; i++)
        word |= (uint64_t)mpz_getlimbn(x, (mp_size_t)(k * FMB_LIMBS_OF_WORD + i))
                << GMP_NUMB_BITS % 64 * i;
    return word;
}
/* w += x, w -= x, modulo 2^64 to the power of n. */
static inline void fmb_words_add(fmb_word *w, size_t n, uint64_t x)
{
    for (size_t k = 0; k < n && x != 0; k++) {
        w[k] += x;
        x = w[k] < x;
    }
}
static inline void fmb_words_subtract(fmb_word *w, size_t n, uint64_t x)
{
    for (size_t k = 0; k < n && x != 0; k++) {
        uint64_t was = w[k];
        w[k] = was - x;
        x = was < x;
    }
}
/* w += f |x| or w -= f |x| over the words of x; returns the carry out of the highest word. */
static inline uint64_t fmb_words_add_product(fmb_word *w, mpz_srcptr x, uint64_t f)
{
    uint64_t carry = 0;
    for (size_t k = 0; k < fmb_integer_words(x); k++) {
        fmb_u128 sum = fmb_u128_plus_product(fmb_u128_of(w[k]), fmb_integer_word(x, k), f);
        sum = fmb_u128_plus_word(sum, carry);
        w[k] = fmb_u128_low(sum);
        carry = fmb_u128_high(sum);
    }
    return carry;
}
static inline uint64_t fmb_words_subtract_product(fmb_word *w, mpz_srcptr x, uint64_t f)
{
    uint64_t borrow = 0;
    for (size_t k = 0; k < fmb_integer_words(x); k++) {
        fmb_u128 less = fmb_u128_plus_product(fmb_u128_of(borrow), fmb_integer_word(x, k), f);
        borrow = fmb_u128_high(less) + (w[k] < fmb_u128_low(less));
        w[k] -= fmb_u128_low(less);
    }
    return borrow;
}
/* to = a b, where a has n words, b has m, and `to` n + m. */
static inline void fmb_words_multiply(fmb_word *to, const fmb_word *a, size_t n, const fmb_word *b,
                                      size_t m)
{
    for (size_t j = 0; j < m; j++)
        to[j] = 0;
    for (size_t i = 0; i < n; i++) {
        uint64_t carry = 0;
        for (size_t j = 0; j < m; j++) {
            fmb_u128 sum = fmb_u128_plus_product(fmb_u128_of(to[i + j]), a[i], b[j]);
            sum = fmb_u128_plus_word(sum, carry);
            to[i + j] = fmb_u128_low(sum);
            carry = fmb_u128_high(sum);
        }
        to[i + m] = carry;
    }
}
/* w += x, both of n words; returns the carry out of the highest word. */
static inline uint64_t fmb_words_add_words(fmb_word *w, const fmb_word *x, size_t n)
{
    uint64_t carry = 0;
    for (size_t k = 0; k < n; k++) {
        fmb_u128 sum = fmb_u128_plus_word(fmb_u128_plus_word(fmb_u128_of(w[k]), x[k]), carry);
        w[k] = fmb_u128_low(sum);
        carry = fmb_u128_high(sum);
    }
    return carry;
}
/* w += f x or w -= f x, all of one word; returns the carry (borrow). */
static inline uint64_t fmb_word_add_product(fmb_word *w, fmb_word x, uint64_t f)
{
    fmb_u128 sum = fmb_u128_plus_product(fmb_u128_of(*w), x, f);
    *w = fmb_u128_low(sum);
    return fmb_u128_high(sum);
}
static inline uint64_t fmb_word_subtract_product(fmb_word *w, fmb_word x, uint64_t f)
{
    fmb_u128 less = fmb_u128_product(x, f);
    uint64_t borrow = fmb_u128_high(less) + (*w < fmb_u128_low(less));
    *w -= fmb_u128_low(less);
    return borrow;
}

#endif

#endif
