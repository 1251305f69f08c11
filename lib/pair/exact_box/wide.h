/* wide.h: integers of a few words, on the stack: sums and products that need no memory.
 *
 * A sign and a magnitude of n words, the last of them not 0; 0 has none. Callers ensure that
 * results have at most FMB_WIDE_BITS bits.
 *
 * All of pair/exact_box is compiled twice: with numbers of a few words, and (FMB_WIDE_LONG) with as
 * many as frames of any doubles in eight dimensions need, under the names defined here.
 */
#ifndef FMB_PAIR_WIDE_H
#define FMB_PAIR_WIDE_H

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "num/word.h"

#ifdef FMB_WIDE_LONG
#define fmb_exact_boxer_new            fmb_long_boxer_new
#define fmb_exact_boxer_free           fmb_long_boxer_free
#define fmb_exact_box_decide           fmb_long_box_decide
#define fmb_exact_box_answer           fmb_long_box_answer
#define fmb_exact_box_answer_q         fmb_long_box_answer_q
#define fmb_exact_box_are_apart        fmb_long_box_are_apart
#define fmb_exact_box_is_farthest      fmb_long_box_is_farthest
#define fmb_exact_box_find_prices      fmb_long_box_find_prices
#define fmb_exact_box_find_loss        fmb_long_box_find_loss
#define fmb_exact_box_load_q           fmb_long_box_load_q
#define fmb_exact_box_load             fmb_long_box_load
#define fmb_exact_box_list_costs       fmb_long_box_list_costs
#define fmb_exact_box_value            fmb_long_box_value
#define fmb_exact_box_value_roughly    fmb_long_box_value_roughly
#define fmb_exact_box_value_outward    fmb_long_box_value_outward
#define fmb_exact_box_walk_exactly     fmb_long_box_walk_exactly
#define fmb_exact_box_round_outward    fmb_long_box_round_outward
#define fmb_exact_box_state            fmb_long_box_state
#define fmb_exact_box_is_off_end       fmb_long_box_is_off_end
#define fmb_exact_box_near_values      fmb_long_box_near_values
#define fmb_exact_box_take_basis       fmb_long_box_take_basis
#define fmb_exact_box_bound_way        fmb_long_box_bound_way
#define fmb_exact_box_need_adjugate    fmb_long_box_need_adjugate
#define fmb_exact_box_need_whole       fmb_long_box_need_whole
#define fmb_exact_box_need_low         fmb_long_box_need_low
#define fmb_exact_box_find_low         fmb_long_box_find_low
#define fmb_exact_box_solve_transposed fmb_long_box_solve_transposed
#define fmb_exact_box_remainder        fmb_long_box_remainder
#define fmb_exact_box_list_column      fmb_long_box_list_column
#define fmb_exact_box_walk_start       fmb_long_box_walk_start
#define fmb_exact_box_walk_to          fmb_long_box_walk_to
#define fmb_wide_gather                fmb_long_number_gather
#define fmb_wide_multiply              fmb_long_number_multiply
#define fmb_wide_shift                 fmb_long_number_shift
#define fmb_wide_dot                   fmb_long_number_dot
#define fmb_wide_divide_exactly        fmb_long_number_divide_exactly
#define fmb_wide_to_doubles            fmb_long_number_to_doubles
enum { FMB_WIDE_WORDS = 568, FMB_WIDE_IS_LONG = true };
#else
enum { FMB_WIDE_WORDS = 20, FMB_WIDE_IS_LONG = false };
#endif
enum { FMB_WIDE_BITS = 64 * (FMB_WIDE_WORDS - 1) };

typedef struct fmb_wide {
    int n;
    bool minus;
    fmb_word word[FMB_WIDE_WORDS];
} fmb_wide;

static inline int fmb_wide_sign(const fmb_wide *a)
{
    return a->n == 0 ? 0 : a->minus ? -1 : 1;
}

static inline void fmb_wide_set_word(fmb_wide *out, uint64_t x)
{
    out->n = x != 0;
    out->minus = false;
    out->word[0] = x;
}

static inline void fmb_wide_copy(fmb_wide *out, const fmb_wide *a)
{
    out->n = a->n;
    out->minus = a->minus;
    for (int i = 0; i < a->n; i++)
        out->word[i] = a->word[i];
}

static inline void fmb_wide_swap(fmb_wide *a, fmb_wide *b)
{
    fmb_wide c;
    fmb_wide_copy(&c, a);
    fmb_wide_copy(a, b);
    fmb_wide_copy(b, &c);
}

static inline void fmb_wide_negate(fmb_wide *a)
{
    a->minus = !a->minus && a->n > 0;
}

static inline void fmb_wide_trim(fmb_wide *a)
{
    while (a->n > 0 && a->word[a->n - 1] == 0)
        a->n--;
    a->minus = a->minus && a->n > 0;
}

static inline int fmb_wide_compare_magnitudes(const fmb_wide *a, const fmb_wide *b)
{
    if (a->n != b->n)
        return a->n < b->n ? -1 : 1;
    for (int i = a->n - 1; i >= 0; i--)
        if (a->word[i] != b->word[i])
            return a->word[i] < b->word[i] ? -1 : 1;
    return 0;
}

static inline int fmb_wide_compare(const fmb_wide *a, const fmb_wide *b)
{
    int sign = fmb_wide_sign(a);
    if (sign != fmb_wide_sign(b))
        return sign < fmb_wide_sign(b) ? -1 : 1;
    return sign * fmb_wide_compare_magnitudes(a, b);
}

/* a += b, or a -= b */
void fmb_wide_gather(fmb_wide *a, const fmb_wide *b, bool subtract);

static inline void fmb_wide_add(fmb_wide *a, const fmb_wide *b)
{
    fmb_wide_gather(a, b, false);
}

static inline void fmb_wide_subtract(fmb_wide *a, const fmb_wide *b)
{
    fmb_wide_gather(a, b, true);
}

/* out = a b; out must be neither a nor b. */
void fmb_wide_multiply(fmb_wide *out, const fmb_wide *a, const fmb_wide *b);

/* out = the sum of a[i] b[i], or of - a[i] b[i] where bit i of minus is set, 0 <= i < n <= 16. out
 * may be one of the factors. */
void fmb_wide_dot(fmb_wide *out, int n, const fmb_wide *const *a, const fmb_wide *const *b,
                  unsigned minus);

/* a *= 2^bits */
void fmb_wide_shift(fmb_wide *a, int bits);

/* a /= d, where d divides a. */
void fmb_wide_divide_exactly(fmb_wide *a, const fmb_wide *d);

/* a in units of its last word, 2^(64 (n - 1)), with a relative error of at most 2^-52: the words
 * below the upper two contribute less than 2^-64 of it, and there are two roundings. */
static inline double fmb_wide_to_double(const fmb_wide *a)
{
    double x = a->n > 0 ? (double)a->word[a->n - 1] : 0;
    if (a->n > 1)
        x += (double)a->word[a->n - 2] * 0x1p-64;
    return a->minus ? -x : x;
}

/* Bits of the magnitude. */
static inline int fmb_wide_length(const fmb_wide *a)
{
    return a->n == 0 ? 0 : 64 * a->n - __builtin_clzll(a->word[a->n - 1]);
}

/* The absolute error of numbers that are about as small as this in doubles. */
#define FMB_WIDE_LEAST 0x1p-900

/* a 2^-scale as a double plus *rest, with a relative error of at most 2^-102. A number below
 * FMB_WIDE_LEAST may become FMB_WIDE_LEAST, with its sign; a very large one becomes infinity. */
double fmb_wide_to_doubles(const fmb_wide *a, int scale, double *rest);

#endif
