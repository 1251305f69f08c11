/* wide.c: integers of a few words against GMP's: sums of products of short and of long numbers. */
#include <criterion/criterion.h>
#include <gmp.h>

#include "pair/exact_box/wide.h"

enum { MOST_TERMS = 16, MOST_WORDS = 5, ROUNDS = 20000 };

static uint64_t state = 1;

static uint64_t draw(void)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return state >> 11;
}

/* All ones, a power of two or any bits, up to that many. */
static fmb_wide some_number(int most_bits)
{
    int bits = (int)(draw() % (uint64_t)(most_bits + 1)), kind = (int)(draw() % 3);
    fmb_wide x = {.n = (bits + 63) / 64};
    for (int i = 0; i < x.n; i++) {
        int left = bits - 64 * i;
        uint64_t mask = left >= 64 ? UINT64_MAX : (UINT64_C(1) << left) - 1;
        x.word[i] = kind == 0 ? mask : kind == 1 ? mask & ~(mask >> 1) : draw() << 20 ^ draw();
        x.word[i] = i + 1 < x.n && kind == 1 ? 0 : x.word[i] & mask;
    }
    x.minus = draw() % 2;
    fmb_wide_trim(&x);
    return x;
}

static void as_gmp(const fmb_wide *x, mpz_t out)
{
    mpz_import(out, (size_t)x->n, -1, sizeof *x->word, 0, 0, x->word);
    if (x->minus)
        mpz_neg(out, out);
}

/* sum of a_i b_i, the bits of minus tell those that are taken away. */
static void expect_dot(int n, const fmb_wide *a, const fmb_wide *b, unsigned minus)
{
    const fmb_wide *left[MOST_TERMS], *right[MOST_TERMS];
    mpz_t sum, x, y;
    fmb_wide out;
    mpz_inits(sum, x, y, NULL);
    for (int i = 0; i < n; i++) {
        left[i] = &a[i];
        right[i] = &b[i];
        as_gmp(&a[i], x);
        as_gmp(&b[i], y);
        if (minus >> i & 1)
            mpz_submul(sum, x, y);
        else
            mpz_addmul(sum, x, y);
    }
    fmb_wide_dot(&out, n, left, right, minus);
    as_gmp(&out, x);
    cr_assert(mpz_cmp(sum, x) == 0 && (out.n == 0 || out.word[out.n - 1] != 0));
    cr_assert(out.n > 0 || !out.minus);
    mpz_clears(sum, x, y, NULL);
}

Test(wide, sums_of_products)
{
    const int most_bits[] = {8, 61, 62, 63, 64, 128, 64 * MOST_WORDS};
    for (int round = 0; round < ROUNDS; round++) {
        fmb_wide a[MOST_TERMS], b[MOST_TERMS];
        int n = 1 + (int)(draw() % MOST_TERMS);
        int most = most_bits[draw() % (sizeof most_bits / sizeof *most_bits)];
        for (int i = 0; i < n; i++) {
            a[i] = some_number(most);
            b[i] = some_number(most);
        }
        if (n > 1 && draw() % 4 == 0) { /* something cancels */
            a[1] = a[0];
            b[1] = b[0];
        }
        expect_dot(n, a, b, (unsigned)draw());
    }
}

Test(wide, largest_short_products)
{
    fmb_wide x = {.n = 1, .word = {(UINT64_C(1) << 61) - 1}}, a[MOST_TERMS];
    for (int i = 0; i < MOST_TERMS; i++)
        a[i] = x;
    for (unsigned minus = 0; minus < 1U << MOST_TERMS; minus += 257)
        expect_dot(MOST_TERMS, a, a, minus);
}

/* A product is divided by a factor again, odd or with many zeros below, of either sign. */
Test(wide, quotients_without_rest)
{
    for (int round = 0; round < ROUNDS; round++) {
        fmb_wide a = some_number(64 * MOST_WORDS), d = some_number(64 * MOST_WORDS), product;
        if (d.n == 0)
            continue;
        fmb_wide_multiply(&product, &a, &d);
        fmb_wide_divide_exactly(&product, &d);
        cr_assert(fmb_wide_compare(&product, &a) == 0, "round %d", round);
        cr_assert(product.n > 0 || !product.minus);
    }
}
