/* int128.c: num/int128.h and num/word.h against GMP. Built twice: like the library, and with the
 * replacements for compilers without such numbers, or with short longs and limbs of GMP. */
#include <criterion/criterion.h>

#include "num/word.h"
#include "support/support.h"

enum { ROUNDS = 20000 };

/* ---- numbers --------------------------------------------------------------------------------- */

/* Often at an end of what fits, or next to it. */
static uint64_t draw_word(support_rng *g)
{
    static const uint64_t edge[] = {0,          1,          2,         0x7fffffff,       0x80000000,
                                    0xffffffff, UINT64_MAX, INT64_MAX, (uint64_t)1 << 32};
    uint64_t any = support_next(g) >> support_between(g, 0, 63);
    uint64_t near = edge[support_between(g, 0, 8)] + (uint64_t)support_between(g, 0, 2) - 1;
    return support_chance(g, 50) ? any : near;
}

static void set_words(mpz_t out, uint64_t high, uint64_t low)
{
    const uint64_t word[] = {low, high};
    mpz_import(out, 2, -1, sizeof *word, 0, 0, word);
}

static void set_u128(mpz_t out, fmb_u128 a)
{
    set_words(out, fmb_u128_high(a), fmb_u128_low(a));
}

static void set_i128(mpz_t out, fmb_i128 a)
{
    set_u128(out, fmb_u128_of_i128(a));
    if (mpz_tstbit(out, 127)) {
        mpz_t all;
        mpz_init_set_ui(all, 1);
        mpz_mul_2exp(all, all, 128);
        mpz_sub(out, out, all);
        mpz_clear(all);
    }
}

static void set_i64(mpz_t out, int64_t a)
{
    set_words(out, 0, a < 0 ? 0 - (uint64_t)a : (uint64_t)a);
    if (a < 0)
        mpz_neg(out, out);
}

/* Are these equal modulo 2^128? */
static bool agree(fmb_u128 a, const mpz_t b)
{
    mpz_t x, y;
    mpz_inits(x, y, NULL);
    set_u128(x, a);
    mpz_fdiv_r_2exp(y, b, 128);
    bool same = mpz_cmp(x, y) == 0;
    mpz_clears(x, y, NULL);
    return same;
}

static int sign_of(int order)
{
    return (order > 0) - (order < 0);
}

/* ---- 128 bits -------------------------------------------------------------------------------- */

Test(int128, without_sign)
{
    support_rng g = {1};
    mpz_t x, y, t;
    mpz_inits(x, y, t, NULL);
    for (int i = 0; i < ROUNDS; i++) {
        uint64_t p = draw_word(&g), q = draw_word(&g), r = draw_word(&g);
        fmb_u128 a = fmb_u128_join(draw_word(&g), p), b = fmb_u128_join(draw_word(&g), q);
        if (i % 5 == 0)
            b = fmb_u128_of(q);
        if (i % 7 == 0)
            b = a;
        set_u128(x, a);
        set_u128(y, b);
        cr_assert_eq(fmb_u128_compare(a, b), sign_of(mpz_cmp(x, y)));
        cr_assert_eq(fmb_u128_are_equal(a, b), mpz_cmp(x, y) == 0);
        cr_assert_eq(fmb_u128_is_less(a, b), mpz_cmp(x, y) < 0);
        cr_assert_eq(fmb_u128_is_zero(a), mpz_sgn(x) == 0);
        cr_assert_eq(fmb_u128_bits(a), mpz_sgn(x) == 0 ? 0 : (int)mpz_sizeinbase(x, 2));
        cr_assert(mpz_sgn(x) == 0 || fmb_u128_trailing_zeros(a) == (int)mpz_scan1(x, 0));
        mpz_add(t, x, y);
        cr_assert(agree(fmb_u128_plus(a, b), t));
        mpz_sub(t, x, y);
        cr_assert(agree(fmb_u128_minus(a, b), t));
        mpz_mul(t, x, y);
        cr_assert(agree(fmb_u128_times(a, b), t));
        mpz_and(t, x, y);
        cr_assert(agree(fmb_u128_and(a, b), t));
        mpz_ior(t, x, y);
        cr_assert(agree(fmb_u128_or(a, b), t));
        int n = support_between(&g, 0, 127);
        mpz_mul_2exp(t, x, (mp_bitcnt_t)n);
        cr_assert(agree(fmb_u128_left(a, n), t));
        mpz_fdiv_q_2exp(t, x, (mp_bitcnt_t)n);
        cr_assert(agree(fmb_u128_right(a, n), t));
        if (mpz_sgn(y) != 0) {
            fmb_u128 rest, quotient = fmb_u128_divide(a, b, &rest);
            mpz_fdiv_qr(t, x, x, y);
            cr_assert(agree(quotient, t) && agree(rest, x));
        }
        set_words(x, 0, p);
        set_words(y, 0, q);
        mpz_mul(t, x, y);
        cr_assert(agree(fmb_u128_product(p, q), t));
        set_words(x, 0, r);
        mpz_add(t, t, x);
        cr_assert(agree(fmb_u128_plus_product(fmb_u128_of(r), p, q), t));
        cr_assert(agree(fmb_u128_plus_word(fmb_u128_product(p, q), r), t));
    }
    mpz_clears(x, y, t, NULL);
}

Test(int128, signed_numbers)
{
    support_rng g = {2};
    mpz_t x, y, t;
    mpz_inits(x, y, t, NULL);
    for (int i = 0; i < ROUNDS; i++) {
        int64_t p = (int64_t)draw_word(&g), q = (int64_t)draw_word(&g);
        fmb_i128 a = fmb_i128_of_u128(fmb_u128_join(draw_word(&g), (uint64_t)p)),
                 b = fmb_i128_of(q);
        if (i % 3 == 0)
            b = fmb_i128_of_u128(fmb_u128_join(draw_word(&g), (uint64_t)q));
        if (i % 7 == 0)
            a = b;
        if (i % 11 == 0)
            a = fmb_i128_of(p);
        set_i128(x, a);
        set_i128(y, b);
        cr_assert_eq(fmb_i128_sign(a), mpz_sgn(x));
        cr_assert_eq(fmb_i128_compare(a, b), sign_of(mpz_cmp(x, y)));
        set_i64(t, fmb_i128_low(a));
        cr_assert_eq(fmb_i128_is_word(a), mpz_cmp(x, t) == 0);
        mpz_abs(t, x);
        cr_assert(agree(fmb_i128_size(a), t));
        mpz_neg(t, x);
        cr_assert(agree(fmb_u128_of_i128(fmb_i128_negative(a)), t));
        mpz_add(t, x, y);
        cr_assert(agree(fmb_u128_of_i128(fmb_i128_plus(a, b)), t));
        mpz_sub(t, x, y);
        cr_assert(agree(fmb_u128_of_i128(fmb_i128_minus(a, b)), t));
        mpz_mul(t, x, y);
        cr_assert(agree(fmb_u128_of_i128(fmb_i128_times(a, b)), t));
        if (mpz_sgn(y) != 0) {
            mpz_tdiv_q(t, x, y);
            cr_assert(agree(fmb_u128_of_i128(fmb_i128_quotient(a, b)), t));
        }
        fmb_integer_set_128(t, a);
        cr_assert(mpz_cmp(t, x) == 0);
        set_i64(x, p);
        set_i64(y, q);
        mpz_mul(t, x, y);
        cr_assert(agree(fmb_u128_of_i128(fmb_i128_product(p, q)), t));
        set_i128(x, a);
        mpz_add(y, x, t);
        cr_assert(agree(fmb_u128_of_i128(fmb_i128_plus_product(a, p, q)), y));
        mpz_sub(y, x, t);
        cr_assert(agree(fmb_u128_of_i128(fmb_i128_minus_product(a, p, q)), y));
    }
    mpz_clears(x, y, t, NULL);
}

/* ---- words and integers ---------------------------------------------------------------------- */

/* Of up to 200 bits, and either sign. */
static void draw_integer(support_rng *g, mpz_t out)
{
    uint64_t word[4] = {draw_word(g), draw_word(g), draw_word(g), draw_word(g) >> 56};
    mpz_import(out, (size_t)support_between(g, 0, 4), -1, sizeof *word, 0, 0, word);
    if (support_chance(g, 50))
        mpz_neg(out, out);
}

Test(word, in_integers)
{
    support_rng g = {3};
    mpz_t a, b, x, y, t;
    mpz_inits(a, b, x, y, t, NULL);
    for (int i = 0; i < ROUNDS; i++) {
        uint64_t p = draw_word(&g);
        int64_t q = (int64_t)draw_word(&g);
        draw_integer(&g, a);
        set_words(x, 0, p);
        set_i64(y, q);
        fmb_integer_set_u64(t, p);
        cr_assert(mpz_cmp(t, x) == 0);
        fmb_integer_set_i64(t, q);
        cr_assert(mpz_cmp(t, y) == 0);
        cr_assert(fmb_integer_is_i64(t) && fmb_integer_get_i64(t) == q);
        cr_assert_eq(sign_of(fmb_integer_compare_i64(a, q)), sign_of(mpz_cmp(a, y)));
        cr_assert_eq(fmb_integer_compare_i64(y, q), 0);
        set_i64(t, fmb_integer_get_i64(a));
        cr_assert_eq(fmb_integer_is_i64(a), mpz_cmp(a, t) == 0);
        mpz_tdiv_r_2exp(t, a, 64);
        set_words(b, 0, fmb_integer_low(a));
        cr_assert(mpz_cmpabs(b, t) == 0);
        mpz_add(t, a, x);
        fmb_integer_plus_u64(b, a, p);
        cr_assert(mpz_cmp(b, t) == 0);
        mpz_mul(t, a, x);
        fmb_integer_times_u64(b, a, p);
        cr_assert(mpz_cmp(b, t) == 0);
        if (p > 0) {
            fmb_integer_divide_exactly_u64(b, t, p);
            cr_assert(mpz_cmp(b, a) == 0);
            mpz_tdiv_qr(t, b, a, x);
            fmb_integer_set_u64(y, fmb_integer_divide_u64(x, a, p));
            cr_assert(mpz_cmp(x, t) == 0 && mpz_cmpabs(y, b) == 0);
            set_words(x, 0, p);
            mpz_fdiv_r(t, a, x);
            fmb_integer_set_u64(b, fmb_integer_modulo_u64(a, p));
            cr_assert(mpz_cmp(b, t) == 0);
        }
        set_i64(y, q);
        mpz_mul(t, a, y);
        fmb_integer_times_i64(b, a, q);
        cr_assert(mpz_cmp(b, t) == 0);
        draw_integer(&g, b);
        mpz_add(t, b, t);
        mpz_set(y, b);
        fmb_integer_add_product_i64(y, a, q);
        cr_assert(mpz_cmp(y, t) == 0);
        mpz_set(t, b);
        mpz_addmul(t, a, x);
        mpz_set(y, b);
        fmb_integer_add_product_u64(y, a, p);
        cr_assert(mpz_cmp(y, t) == 0);
        fmb_integer_subtract_product_u64(y, a, p);
        cr_assert(mpz_cmp(y, b) == 0);
    }
    mpz_clears(a, b, x, y, t, NULL);
}

/* ---- words in a row -------------------------------------------------------------------------- */

enum { WORDS = 5 };

/* Modulo 2^(64 n). */
static bool have_words(const fmb_word *w, size_t n, const mpz_t value)
{
    mpz_t x, y;
    mpz_inits(x, y, NULL);
    mpz_import(x, n, -1, sizeof *w, 0, 0, w);
    mpz_fdiv_r_2exp(y, value, 64 * n);
    bool same = mpz_cmp(x, y) == 0;
    mpz_clears(x, y, NULL);
    return same;
}

Test(word, in_a_row)
{
    support_rng g = {4};
    mpz_t a, x, t, f;
    mpz_inits(a, x, t, f, NULL);
    for (int i = 0; i < ROUNDS; i++) {
        fmb_word w[WORDS];
        uint64_t p = draw_word(&g);
        for (int k = 0; k < WORDS; k++)
            w[k] = draw_word(&g);
        draw_integer(&g, a);
        size_t n = fmb_integer_words(a);
        cr_assert_eq(n, (mpz_sgn(a) == 0 ? 0 : mpz_sizeinbase(a, 2) + 63) / 64);
        mpz_set_ui(t, 0);
        for (size_t k = n; k-- > 0;) {
            mpz_mul_2exp(t, t, 64);
            set_words(x, 0, fmb_integer_word(a, k));
            mpz_add(t, t, x);
        }
        cr_assert(mpz_cmpabs(t, a) == 0);
        set_words(f, 0, p);
        mpz_import(x, WORDS, -1, sizeof *w, 0, 0, w);
        mpz_add(t, x, f);
        fmb_words_add(w, WORDS, p);
        cr_assert(have_words(w, WORDS, t));
        fmb_words_subtract(w, WORDS, p);
        cr_assert(have_words(w, WORDS, x));
        fmb_words_subtract(w, WORDS, p);
        mpz_sub(t, x, f);
        cr_assert(have_words(w, WORDS, t));
        fmb_words_add(w, WORDS, p);
        if (n == 0)
            continue;
        mpz_abs(a, a);
        fmb_words_add(w + n, WORDS - n, fmb_words_add_product(w, a, p));
        mpz_set(t, x);
        mpz_addmul(t, a, f);
        cr_assert(have_words(w, WORDS, t));
        fmb_words_subtract(w + n, WORDS - n, fmb_words_subtract_product(w, a, p));
        cr_assert(have_words(w, WORDS, x));
        uint64_t q = fmb_integer_word(a, 0);
        set_words(a, 0, q);
        fmb_words_subtract(w + 1, WORDS - 1, fmb_word_subtract_product(w, q, p));
        mpz_submul(x, a, f);
        cr_assert(have_words(w, WORDS, x));
        fmb_words_add(w + 1, WORDS - 1, fmb_word_add_product(w, q, p));
        mpz_addmul(x, a, f);
        cr_assert(have_words(w, WORDS, x));
    }
    mpz_clears(a, x, t, f, NULL);
}

Test(word, sums_and_products_of_rows)
{
    support_rng g = {5};
    mpz_t x, y;
    mpz_inits(x, y, NULL);
    for (int i = 0; i < ROUNDS; i++) {
        const size_t n = 1 + (size_t)i % WORDS, m = 1 + (size_t)i / WORDS % WORDS;
        fmb_word a[WORDS], b[WORDS], product[2 * WORDS], w[WORDS + 1];
        for (int k = 0; k < WORDS; k++) {
            a[k] = draw_word(&g);
            b[k] = w[k] = draw_word(&g);
        }
        mpz_import(x, n, -1, sizeof *a, 0, 0, a);
        mpz_import(y, n, -1, sizeof *b, 0, 0, b);
        mpz_add(y, y, x);
        w[n] = fmb_words_add_words(w, a, n);
        cr_assert(have_words(w, n + 1, y));
        mpz_import(y, m, -1, sizeof *b, 0, 0, b);
        mpz_mul(x, x, y);
        fmb_words_multiply(product, a, n, b, m);
        cr_assert(have_words(product, n + m, x));
    }
    mpz_clears(x, y, NULL);
}
