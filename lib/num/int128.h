/* int128.h: signed and unsigned integers of 128 bits, as functions. Where the compiler has such
 * types the functions are its operators; elsewhere (32-bit targets) a number is two words. A test
 * defines FMB_INT128_PLAIN to get these. All results are modulo 2^128, so an intermediate sum may
 * wrap if the final one fits. This file includes no room: rules and programs include it, too.
 */
#ifndef FMB_NUM_INT128_H
#define FMB_NUM_INT128_H

#include <stdbool.h>
#include <stdint.h>

#if defined __SIZEOF_INT128__ && !defined FMB_INT128_PLAIN

__extension__ typedef __int128 fmb_i128;
__extension__ typedef unsigned __int128 fmb_u128;

static inline fmb_u128 fmb_u128_of(uint64_t low)
{
    return low;
}
static inline fmb_u128 fmb_u128_join(uint64_t high, uint64_t low)
{
    return (fmb_u128)high << 64 | low;
}
static inline uint64_t fmb_u128_high(fmb_u128 a)
{
    return (uint64_t)(a >> 64);
}
static inline uint64_t fmb_u128_low(fmb_u128 a)
{
    return (uint64_t)a;
}
static inline fmb_u128 fmb_u128_product(uint64_t a, uint64_t b)
{
    return (fmb_u128)a * b;
}
static inline fmb_u128 fmb_u128_plus(fmb_u128 a, fmb_u128 b)
{
    return a + b;
}
static inline fmb_u128 fmb_u128_minus(fmb_u128 a, fmb_u128 b)
{
    return a - b;
}
static inline fmb_u128 fmb_u128_times(fmb_u128 a, fmb_u128 b)
{
    return a * b;
}
/* 0 <= n < 128 */
static inline fmb_u128 fmb_u128_left(fmb_u128 a, int n)
{
    return a << n;
}
static inline fmb_u128 fmb_u128_right(fmb_u128 a, int n)
{
    return a >> n;
}
static inline bool fmb_u128_is_less(fmb_u128 a, fmb_u128 b)
{
    return a < b;
}
/* a / b rounded down, b not 0. */
static inline fmb_u128 fmb_u128_quotient(fmb_u128 a, fmb_u128 b)
{
    return a / b;
}
/* The same number modulo 2^128, signed. */
static inline fmb_i128 fmb_i128_of_u128(fmb_u128 a)
{
    return (fmb_i128)a;
}
static inline fmb_u128 fmb_u128_of_i128(fmb_i128 a)
{
    return (fmb_u128)a;
}
static inline fmb_i128 fmb_i128_of(int64_t a)
{
    return a;
}
static inline fmb_i128 fmb_i128_product(int64_t a, int64_t b)
{
    return (fmb_i128)a * b;
}
static inline int fmb_i128_sign(fmb_i128 a)
{
    return (a > 0) - (a < 0);
}
/* -1, 0 or 1 */
static inline int fmb_i128_compare(fmb_i128 a, fmb_i128 b)
{
    return (a > b) - (a < b);
}
/* |a|, also right for the least number, -2^127. */
static inline fmb_u128 fmb_i128_size(fmb_i128 a)
{
    return a < 0 ? 0 - (fmb_u128)a : (fmb_u128)a;
}
/* a / b rounded towards 0, b not 0. */
static inline fmb_i128 fmb_i128_quotient(fmb_i128 a, fmb_i128 b)
{
    return a / b;
}

#else

/* Both are two's complement; high has the sign. */
typedef struct fmb_u128 {
    uint64_t low, high;
} fmb_u128;
typedef struct fmb_i128 {
    uint64_t low, high;
} fmb_i128;

static inline fmb_u128 fmb_u128_of(uint64_t low)
{
    return (fmb_u128){low, 0};
}
static inline fmb_u128 fmb_u128_join(uint64_t high, uint64_t low)
{
    return (fmb_u128){low, high};
}
static inline uint64_t fmb_u128_high(fmb_u128 a)
{
    return a.high;
}
static inline uint64_t fmb_u128_low(fmb_u128 a)
{
    return a.low;
}
/* By halves of words; `middle` is at most (2^32 - 1)^2 + 2 (2^32 - 1) = 2^64 - 1. */
static inline fmb_u128 fmb_u128_product(uint64_t a, uint64_t b)
{
    const uint64_t half = 0xffffffff;
    uint64_t low = (a & half) * (b & half), cross = (a >> 32) * (b & half);
    uint64_t middle = (a & half) * (b >> 32) + (low >> 32) + (cross & half);
    return (fmb_u128){middle << 32 | (low & half),
                      (a >> 32) * (b >> 32) + (cross >> 32) + (middle >> 32)};
}
static inline fmb_u128 fmb_u128_plus(fmb_u128 a, fmb_u128 b)
{
    uint64_t low = a.low + b.low;
    return (fmb_u128){low, a.high + b.high + (low < a.low)};
}
static inline fmb_u128 fmb_u128_minus(fmb_u128 a, fmb_u128 b)
{
    return (fmb_u128){a.low - b.low, a.high - b.high - (a.low < b.low)};
}
static inline fmb_u128 fmb_u128_times(fmb_u128 a, fmb_u128 b)
{
    fmb_u128 t = fmb_u128_product(a.low, b.low);
    return (fmb_u128){t.low, t.high + a.low * b.high + a.high * b.low};
}
/* 0 <= n < 128 */
static inline fmb_u128 fmb_u128_left(fmb_u128 a, int n)
{
    if (n >= 64)
        return (fmb_u128){0, a.low << (n - 64)};
    return n == 0 ? a : (fmb_u128){a.low << n, a.high << n | a.low >> (64 - n)};
}
static inline fmb_u128 fmb_u128_right(fmb_u128 a, int n)
{
    if (n >= 64)
        return (fmb_u128){a.high >> (n - 64), 0};
    return n == 0 ? a : (fmb_u128){a.low >> n | a.high << (64 - n), a.high >> n};
}
static inline bool fmb_u128_is_less(fmb_u128 a, fmb_u128 b)
{
    return a.high < b.high || (a.high == b.high && a.low < b.low);
}
/* a / b rounded down, b not 0, bit by bit. The remainder `left` is less than b, so doubling it can
 * lose a bit only if b has bit 127 set; `over` is that lost bit. */
static inline fmb_u128 fmb_u128_quotient(fmb_u128 a, fmb_u128 b)
{
    fmb_u128 left = {0, 0}, quotient = {0, 0};
    for (int bit = 127; bit >= 0; bit--) {
        bool over = left.high >> 63;
        left = fmb_u128_left(left, 1);
        left.low |= fmb_u128_right(a, bit).low & 1;
        quotient = fmb_u128_left(quotient, 1);
        if (over || !fmb_u128_is_less(left, b)) {
            left = fmb_u128_minus(left, b);
            quotient.low |= 1;
        }
    }
    return quotient;
}
/* The same number modulo 2^128, signed. */
static inline fmb_i128 fmb_i128_of_u128(fmb_u128 a)
{
    return (fmb_i128){a.low, a.high};
}
static inline fmb_u128 fmb_u128_of_i128(fmb_i128 a)
{
    return (fmb_u128){a.low, a.high};
}
static inline fmb_i128 fmb_i128_of(int64_t a)
{
    return (fmb_i128){(uint64_t)a, a < 0 ? UINT64_MAX : 0};
}
/* In two's complement: as an unsigned word, a negative number is 2^64 larger. */
static inline fmb_i128 fmb_i128_product(int64_t a, int64_t b)
{
    fmb_u128 t = fmb_u128_product((uint64_t)a, (uint64_t)b);
    return (fmb_i128){t.low, t.high - (a < 0 ? (uint64_t)b : 0) - (b < 0 ? (uint64_t)a : 0)};
}
static inline int fmb_i128_sign(fmb_i128 a)
{
    return a.high >> 63 ? -1 : (a.high | a.low) != 0;
}
/* -1, 0 or 1 */
static inline int fmb_i128_compare(fmb_i128 a, fmb_i128 b)
{
    const uint64_t sign = (uint64_t)1 << 63;
    fmb_u128 x = {a.low, a.high ^ sign}, y = {b.low, b.high ^ sign};
    return fmb_u128_is_less(y, x) - fmb_u128_is_less(x, y);
}

/* |a|, also right for the least number, -2^127. */
static inline fmb_u128 fmb_i128_size(fmb_i128 a)
{
    fmb_u128 size = {a.low, a.high};
    return a.high >> 63 ? fmb_u128_minus((fmb_u128){0, 0}, size) : size;
}
/* a / b rounded towards 0, b not 0. */
static inline fmb_i128 fmb_i128_quotient(fmb_i128 a, fmb_i128 b)
{
    fmb_u128 size = fmb_u128_quotient(fmb_i128_size(a), fmb_i128_size(b));
    return fmb_i128_of_u128((a.high ^ b.high) >> 63 ? fmb_u128_minus((fmb_u128){0, 0}, size)
                                                    : size);
}

#endif

/* ---- made of the functions above ------------------------------------------------------------- */

static inline bool fmb_u128_is_zero(fmb_u128 a)
{
    return (fmb_u128_high(a) | fmb_u128_low(a)) == 0;
}
static inline bool fmb_u128_are_equal(fmb_u128 a, fmb_u128 b)
{
    return ((fmb_u128_high(a) ^ fmb_u128_high(b)) | (fmb_u128_low(a) ^ fmb_u128_low(b))) == 0;
}
/* -1, 0 or 1 */
static inline int fmb_u128_compare(fmb_u128 a, fmb_u128 b)
{
    return fmb_u128_is_less(b, a) - fmb_u128_is_less(a, b);
}
static inline fmb_u128 fmb_u128_or(fmb_u128 a, fmb_u128 b)
{
    return fmb_u128_join(fmb_u128_high(a) | fmb_u128_high(b), fmb_u128_low(a) | fmb_u128_low(b));
}
static inline fmb_u128 fmb_u128_and(fmb_u128 a, fmb_u128 b)
{
    return fmb_u128_join(fmb_u128_high(a) & fmb_u128_high(b), fmb_u128_low(a) & fmb_u128_low(b));
}
/* sum + a b */
static inline fmb_u128 fmb_u128_plus_product(fmb_u128 sum, uint64_t a, uint64_t b)
{
    return fmb_u128_plus(sum, fmb_u128_product(a, b));
}
/* sum + a */
static inline fmb_u128 fmb_u128_plus_word(fmb_u128 sum, uint64_t a)
{
    return fmb_u128_plus(sum, fmb_u128_of(a));
}
/* a / b rounded down, b not 0; *rest is the remainder. */
static inline fmb_u128 fmb_u128_divide(fmb_u128 a, fmb_u128 b, fmb_u128 *rest)
{
    fmb_u128 quotient = fmb_u128_quotient(a, b);
    *rest = fmb_u128_minus(a, fmb_u128_times(quotient, b));
    return quotient;
}
/* The number of bits of a; 0 if a = 0. */
static inline int fmb_u128_bits(fmb_u128 a)
{
    uint64_t high = fmb_u128_high(a), low = fmb_u128_low(a);
    return high != 0 ? 128 - __builtin_clzll(high) : low != 0 ? 64 - __builtin_clzll(low) : 0;
}
/* a is not 0. */
static inline int fmb_u128_trailing_zeros(fmb_u128 a)
{
    uint64_t low = fmb_u128_low(a);
    return low != 0 ? __builtin_ctzll(low) : 64 + __builtin_ctzll(fmb_u128_high(a));
}

static inline fmb_i128 fmb_i128_plus(fmb_i128 a, fmb_i128 b)
{
    return fmb_i128_of_u128(fmb_u128_plus(fmb_u128_of_i128(a), fmb_u128_of_i128(b)));
}
static inline fmb_i128 fmb_i128_minus(fmb_i128 a, fmb_i128 b)
{
    return fmb_i128_of_u128(fmb_u128_minus(fmb_u128_of_i128(a), fmb_u128_of_i128(b)));
}
static inline fmb_i128 fmb_i128_times(fmb_i128 a, fmb_i128 b)
{
    return fmb_i128_of_u128(fmb_u128_times(fmb_u128_of_i128(a), fmb_u128_of_i128(b)));
}
static inline fmb_i128 fmb_i128_negative(fmb_i128 a)
{
    return fmb_i128_minus(fmb_i128_of(0), a);
}
/* sum + a b, sum - a b */
static inline fmb_i128 fmb_i128_plus_product(fmb_i128 sum, int64_t a, int64_t b)
{
    return fmb_i128_plus(sum, fmb_i128_product(a, b));
}
static inline fmb_i128 fmb_i128_minus_product(fmb_i128 sum, int64_t a, int64_t b)
{
    return fmb_i128_minus(sum, fmb_i128_product(a, b));
}
/* The lower word of a; it equals a if fmb_i128_is_word. */
static inline int64_t fmb_i128_low(fmb_i128 a)
{
    return (int64_t)fmb_u128_low(fmb_u128_of_i128(a));
}
static inline bool fmb_i128_is_word(fmb_i128 a)
{
    return fmb_i128_compare(a, fmb_i128_of(fmb_i128_low(a))) == 0;
}
#endif
