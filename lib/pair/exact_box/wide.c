/* wide.c: see wide.h. */
#define FMB_LANES 1
#include "pair/exact_box/wide.h"

#include <string.h>

#include "pair/kernels/lane/error_free.h"

/* a += b in magnitude */
static void add_magnitude(fmb_wide *a, const fmb_wide *b)
{
    uint64_t carry = 0;
    for (; a->n < b->n; a->n++)
        a->word[a->n] = 0;
    for (int i = 0; i < a->n && (i < b->n || carry != 0); i++) {
        fmb_u128 sum = fmb_u128_plus_word(fmb_u128_of(a->word[i]), i < b->n ? b->word[i] : 0);
        sum = fmb_u128_plus_word(sum, carry);
        a->word[i] = fmb_u128_low(sum);
        carry = fmb_u128_high(sum);
    }
    if (carry != 0) {
        assert(a->n < FMB_WIDE_WORDS);
        a->word[a->n++] = carry;
    }
}

/* a = large - small in magnitude; a may be either. */
static void subtract_magnitudes(fmb_wide *a, const fmb_wide *large, const fmb_wide *small)
{
    uint64_t borrow = 0;
    int n = small->n;
    for (int i = 0; i < n; i++) {
        uint64_t x = large->word[i], y = small->word[i], less = x - y;
        a->word[i] = less - borrow;
        borrow = (x < y) | (less < borrow);
    }
    for (int i = n; i < large->n; i++) {
        uint64_t x = large->word[i];
        a->word[i] = x - borrow;
        borrow = x < borrow;
    }
    a->n = large->n;
    fmb_wide_trim(a);
}

void fmb_wide_gather(fmb_wide *a, const fmb_wide *b, bool subtract)
{
    bool minus = b->minus != subtract;
    if (b->n == 0)
        return;
    if (a->n == 0) {
        fmb_wide_copy(a, b);
        a->minus = minus;
    } else if (a->minus == minus) {
        add_magnitude(a, b);
    } else if (fmb_wide_compare_magnitudes(a, b) >= 0) {
        subtract_magnitudes(a, a, b);
    } else {
        a->minus = minus;
        subtract_magnitudes(a, b, a);
    }
}

void fmb_wide_multiply(fmb_wide *out, const fmb_wide *a, const fmb_wide *b)
{
    out->n = 0;
    out->minus = false;
    if (a->n == 0 || b->n == 0)
        return;
    assert(a->n + b->n <= FMB_WIDE_WORDS);
    fmb_words_multiply(out->word, a->word, (size_t)a->n, b->word, (size_t)b->n);
    out->n = a->n + b->n;
    out->minus = a->minus != b->minus;
    fmb_wide_trim(out);
}

void fmb_wide_shift(fmb_wide *a, int bits)
{
    int words = bits / 64, rest = bits % 64;
    if (a->n == 0)
        return;
    assert(a->n + words < FMB_WIDE_WORDS);
    a->word[a->n] = 0;
    for (int i = a->n; i >= 0; i--) {
        uint64_t below = i > 0 && rest > 0 ? a->word[i - 1] >> (64 - rest) : 0;
        a->word[i + words] = (a->word[i] << rest) | below;
    }
    for (int i = 0; i < words; i++)
        a->word[i] = 0;
    a->n += words + 1;
    fmb_wide_trim(a);
}

/* The first nonzero word: long numbers often end in zeros, as rows mix large and small ones. */
static int first_word(const fmb_wide *a)
{
    int i = 0;
    while (a->word[i] == 0)
        i++;
    return i;
}

/* to += x b, n words; returns the carry out of the highest word. */
static uint64_t add_row_of_words(fmb_word *to, uint64_t x, const fmb_word *b, int n)
{
    uint64_t carry = 0;
    for (int j = 0; j < n; j++) {
        fmb_u128 sum = fmb_u128_plus_word(fmb_u128_product(x, b[j]), to[j]);
        sum = fmb_u128_plus_word(sum, carry);
        to[j] = fmb_u128_low(sum);
        carry = fmb_u128_high(sum);
    }
    return carry;
}

/* to += a b in magnitude, neither of them 0; there is room for carries. */
static void add_product_of_words(fmb_word *to, const fmb_wide *a, const fmb_wide *b)
{
    fmb_word product[FMB_WIDE_WORDS];
    int i = first_word(a), j = first_word(b), n = a->n - i, m = b->n - j, k = n + m;
    const fmb_word *x = a->word + i, *y = b->word + j;
    uint64_t carry;
    to += i + j;
    if (n == 1 || m == 1) {
        carry = n == 1 ? add_row_of_words(to, *x, y, m) : add_row_of_words(to, *y, x, n);
        k--;
    } else {
        fmb_words_multiply(product, x, (size_t)n, y, (size_t)m);
        carry = fmb_words_add_words(to, product, (size_t)k);
    }
    for (; carry != 0; k++) {
        to[k] += carry;
        carry = to[k] < carry;
    }
}

/* out = large - small, of n words. */
static void subtract_words(fmb_wide *out, const fmb_word *large, const fmb_word *small, int n)
{
    uint64_t borrow = 0;
    for (int i = 0; i < n; i++) {
        uint64_t less = large[i] - small[i];
        out->word[i] = less - borrow;
        borrow = (large[i] < small[i]) | (less < borrow);
    }
    out->n = n;
}

/* fmb_wide_dot if all factors have at most 61 bits: the sum of 16 products has at most 126. False:
 * they are longer. */
static bool dot_of_short_factors(fmb_wide *out, int n, const fmb_wide *const *a,
                                 const fmb_wide *const *b, unsigned minus)
{
    fmb_i128 sum = fmb_i128_of(0);
    for (int i = 0; i < n; i++) {
        uint64_t x = a[i]->n > 0 ? a[i]->word[0] : 0, y = b[i]->n > 0 ? b[i]->word[0] : 0;
        if ((a[i]->n > 1) | (b[i]->n > 1) | ((x | y) >> 61 > 0))
            return false;
        fmb_i128 product = fmb_i128_of_u128(fmb_u128_product(x, y));
        bool negative = (a[i]->minus != b[i]->minus) != (minus >> i & 1);
        sum = fmb_i128_plus(sum, negative ? fmb_i128_negative(product) : product);
    }
    fmb_u128 size = fmb_i128_size(sum);
    out->word[0] = fmb_u128_low(size);
    out->word[1] = fmb_u128_high(size);
    out->n = out->word[1] > 0 ? 2 : out->word[0] > 0;
    out->minus = fmb_i128_sign(sum) < 0;
    return true;
}

/* Products are summed by sign; in the end one sum is subtracted from the other. */
void fmb_wide_dot(fmb_wide *out, int n, const fmb_wide *const *a, const fmb_wide *const *b,
                  unsigned minus)
{
    fmb_word part[2][FMB_WIDE_WORDS + 1];
    int words = 0, top;
    assert(n <= 16);
    if (dot_of_short_factors(out, n, a, b, minus))
        return;
    for (int i = 0; i < n; i++)
        if (a[i]->n > 0 && b[i]->n > 0 && a[i]->n + b[i]->n > words)
            words = a[i]->n + b[i]->n;
    assert(words <= FMB_WIDE_WORDS);
    for (int i = 0; i <= words; i++)
        part[0][i] = part[1][i] = 0;
    for (int i = 0; i < n; i++)
        if (a[i]->n > 0 && b[i]->n > 0)
            add_product_of_words(part[(a[i]->minus != b[i]->minus) != (minus >> i & 1)], a[i],
                                 b[i]);
    for (top = words; top >= 0 && part[0][top] == part[1][top]; top--)
        ;
    assert(top < FMB_WIDE_WORDS);
    out->minus = top >= 0 && part[0][top] < part[1][top];
    subtract_words(out, part[out->minus], part[!out->minus], top + 1);
    fmb_wide_trim(out);
}

/* a /= 2^bits, which divides a. */
static void shift_down(fmb_wide *a, int bits)
{
    int words = bits / 64, rest = bits % 64;
    for (int i = words; i < a->n; i++) {
        uint64_t above = i + 1 < a->n && rest > 0 ? a->word[i + 1] << (64 - rest) : 0;
        a->word[i - words] = a->word[i] >> rest | above;
    }
    a->n = a->n > words ? a->n - words : 0;
    fmb_wide_trim(a);
}

/* The inverse of an odd word modulo 2^64 by Newton's method: correct bits, at first 3, double. */
static uint64_t inverse_of_word(uint64_t d)
{
    uint64_t x = d;
    for (int bits = 3; bits < 64; bits *= 2)
        x *= 2 - d * x;
    return x;
}

/* Jebelean 1993, An algorithm for exact division: from the lowest word on, each word of the
 * quotient is that of the remainder times the inverse of the lowest word of an odd divisor. */
void fmb_wide_divide_exactly(fmb_wide *a, const fmb_wide *d)
{
    fmb_wide odd;
    int zeros = 0;
    a->minus = a->n > 0 && a->minus != d->minus;
    if (a->n == 0 || (d->n == 1 && d->word[0] == 1))
        return;
    while (d->word[zeros] == 0)
        zeros++;
    zeros = 64 * zeros + __builtin_ctzll(d->word[zeros]);
    fmb_wide_copy(&odd, d);
    shift_down(&odd, zeros);
    shift_down(a, zeros);
    uint64_t inverse = inverse_of_word(odd.word[0]);
    int words = a->n - odd.n + 1;
    for (int i = 0; i < words; i++) {
        uint64_t q = a->word[i] * inverse, carry = 0;
        if (q == 0)
            continue;
        for (int j = 0; j < odd.n && i + j < words; j++) {
            fmb_u128 product = fmb_u128_plus_word(fmb_u128_product(q, odd.word[j]), carry);
            carry = fmb_u128_high(product) + (a->word[i + j] < fmb_u128_low(product));
            a->word[i + j] -= fmb_u128_low(product);
        }
        for (int j = i + odd.n; j < words && carry > 0; j++) {
            uint64_t before = a->word[j];
            a->word[j] -= carry;
            carry = before < carry;
        }
        a->word[i] = q;
    }
    a->n = words;
    fmb_wide_trim(a);
}

/* 2^e, -1023 < e < 1024 */
static double power_of_two(int e)
{
    uint64_t bits = (uint64_t)(e + 1023) << 52;
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* A word exactly, as the upper 53 bits and the others. */
static lane2 split_word(uint64_t word)
{
    const uint64_t low = 0x7ff;
    return (lane2){(double)(word & ~low), (double)(word & low)};
}

/* The two upper words exactly; the third is less than 2^-64 of all, what is below it 2^-128.
 * 2^-102 of what is at least 2^-964 is more than the least double. */
double fmb_wide_to_doubles(const fmb_wide *a, int scale, double *rest)
{
    int n = a->n, exponent = 64 * (n - 1) - scale;
    *rest = 0;
    if (n == 0)
        return 0;
    if (exponent < -964 || exponent > 900)
        return copysign(exponent < 0 ? FMB_WIDE_LEAST : INFINITY, a->minus ? -1 : 1);
    double unit = copysign(power_of_two(exponent), a->minus ? -1 : 1);
    if (n == 1 && a->word[0] >> 53 == 0)
        return (double)(int64_t)a->word[0] * unit;
    lane2 x = split_word(a->word[n - 1]), sum = two_sum(x.hi, x.lo);
    if (n > 1) {
        lane2 y = split_word(a->word[n - 2]), middle = two_sum(x.lo, y.hi * 0x1p-64);
        double third = n > 2 ? (double)a->word[n - 3] * 0x1p-64 : 0;
        sum = two_sum(x.hi, middle.hi);
        sum = two_sum(sum.hi, sum.lo + (middle.lo + (y.lo + third) * 0x1p-64));
    }
    *rest = sum.lo * unit;
    return sum.hi * unit;
}
