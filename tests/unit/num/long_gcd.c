/* long_gcd.c: greatest common divisors of long numbers are those of GMP, and can be interrupted. */
#include "num/gcd.h"

#include <criterion/criterion.h>
#include <stdint.h>

#include "num/vec.h"

/* Says no at call `limit`. */
typedef struct waiting {
    size_t asked, limit;
} waiting;

static fmb_status ask(void *self)
{
    waiting *w = self;
    return ++w->asked < w->limit ? FMB_OK : FMB_ERR_IO;
}

static mpz_t a, b, c;
static gmp_randstate_t draw;

static void open_numbers(void)
{
    mpz_inits(a, b, c, NULL);
    gmp_randinit_default(draw);
    gmp_randseed_ui(draw, 1);
}

static void close_numbers(void)
{
    mpz_clears(a, b, c, NULL);
    gmp_randclear(draw);
}

TestSuite(long_gcd, .init = open_numbers, .fini = close_numbers);

/* Of a and b, in both orders and into each of them; how often it asked. */
static size_t check_pair(void)
{
    waiting w = {.limit = SIZE_MAX};
    const fmb_poll poll = {ask, &w};
    mpz_t truth, x;
    mpz_inits(truth, x, NULL);
    mpz_gcd(truth, a, b);
    cr_assert_eq(fmb_long_gcd(c, a, b, &poll), FMB_OK);
    cr_expect_eq(mpz_cmp(c, truth), 0);
    size_t asked = w.asked;
    mpz_set(x, b);
    cr_assert_eq(fmb_long_gcd(x, x, a, NULL), FMB_OK);
    cr_expect_eq(mpz_cmp(x, truth), 0);
    mpz_set(x, b);
    cr_assert_eq(fmb_long_gcd(x, a, x, &poll), FMB_OK);
    cr_expect_eq(mpz_cmp(x, truth), 0);
    mpz_clears(truth, x, NULL);
    return asked;
}

Test(long_gcd, random_numbers)
{
    static const struct {
        size_t a, b, common;
    } bits[] = {
        {1, 0, 1},           {1, 64, 100},        {300000, 300000, 7},  {524288, 524289, 0},
        {524290, 524300, 1}, {800000, 700000, 0}, {600000, 2000000, 3}, {400000, 400000, 400000},
        {10, 600000, 900000}};
    for (size_t k = 0; k < sizeof bits / sizeof *bits; k++) {
        mpz_urandomb(c, draw, bits[k].common);
        mpz_add_ui(c, c, 1);
        mpz_urandomb(a, draw, bits[k].a);
        mpz_mul(a, a, c);
        mpz_urandomb(b, draw, bits[k].b);
        mpz_mul(b, b, c);
        if (k % 2)
            mpz_neg(a, a);
        if (k % 3 == 2)
            mpz_neg(b, b);
        (void)check_pair();
    }
}

/* Numbers whose quotients are not like those of random ones: of 1 alone, one that divides the
 * other, ones with long quotients in between, and many of thousands of bits. */
Test(long_gcd, odd_quotients)
{
    mpz_fib2_ui(a, b, 1200000);
    (void)check_pair();
    mpz_mul(a, b, b);
    (void)check_pair();
    mpz_ui_pow_ui(a, 10, 200000);
    mpz_ui_pow_ui(b, 10, 180000);
    mpz_add_ui(b, b, 1);
    (void)check_pair();
    mpz_set_ui(a, 0);
    mpz_setbit(a, 700000);
    mpz_set(b, a);
    mpz_setbit(b, 350000);
    mpz_setbit(b, 3);
    (void)check_pair();
    mpz_set_ui(a, 1);
    mpz_set_ui(b, 0);
    for (int k = 0; k < 300; k++) {
        mpz_urandomb(c, draw, k % 7 ? 2000 : 9000);
        mpz_addmul(b, a, c);
        mpz_swap(a, b);
    }
    (void)check_pair();
}

/* mpz_gcd takes a tenth of a second and more: so twenty calls are one every few hundredths.
 * Wherever it is broken off, nothing is written. */
Test(long_gcd, asks_and_ends)
{
    mpz_urandomb(a, draw, 1661000);
    mpz_urandomb(b, draw, 1661000);
    size_t asked = check_pair();
    cr_expect_geq(asked, 20, "%zu calls", asked);
    mpz_set_ui(c, 17);
    for (size_t limit = 1; limit <= asked; limit += limit < 3 ? 1 : asked / 4) {
        waiting w = {.limit = limit};
        const fmb_poll poll = {ask, &w};
        cr_expect_eq(fmb_long_gcd(c, a, b, &poll), FMB_ERR_IO);
        cr_expect_eq(w.asked, limit);
        cr_expect_eq(mpz_cmp_ui(c, 17), 0);
    }
}

/* As GMP divides, short and long, of all signs. */
Test(long_gcd, divides)
{
    mpq_t x, truth, by;
    mpq_inits(x, truth, by, NULL);
    for (int k = 0; k < 60; k++) {
        size_t bits = k == 59 ? 600000 : (size_t)k * 3;
        mpz_urandomb(mpq_numref(x), draw, bits);
        mpz_urandomb(mpq_denref(x), draw, 40);
        mpz_add_ui(mpq_denref(x), mpq_denref(x), 1);
        mpz_urandomb(mpq_numref(by), draw, bits);
        mpz_add_ui(mpq_numref(by), mpq_numref(by), 1);
        if (k % 2)
            mpz_neg(mpq_numref(x), mpq_numref(x));
        if (k % 3)
            mpz_neg(mpq_numref(by), mpq_numref(by));
        mpq_canonicalize(x);
        mpq_div(truth, x, by);
        cr_assert_eq(fmb_long_divide(x, mpq_numref(by), NULL), FMB_OK);
        cr_expect(mpq_equal(x, truth), "%d", k);
    }
    mpq_clears(x, truth, by, NULL);
}

/* A combination of rows of long numbers is broken off at each call; then the row that it was for is
 * as it was, unless all that is missing is to divide it by its content. */
Test(long_gcd, rows_are_broken_off)
{
    enum { N = 3 };
    fmb_mem mem;
    fmb_num num;
    int64_t words[2][N] = {{0}, {0}};
    fmb_vec row[2] = {{.s = words[0]}, {.s = words[1]}};
    mpz_t entry[N];
    fmb_status st = FMB_ERR_IO;
    size_t limit = 1;
    fmb_mem_init(&mem, NULL, 0);
    cr_assert_eq(fmb_num_init(&num, &mem, N, false), FMB_OK);
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < N; j++) {
            mpz_init(entry[j]);
            mpz_urandomb(entry[j], draw, 600000);
            mpz_setbit(entry[j], 600000);
        }
        cr_assert_eq(fmb_vec_set_z(&row[i], N, entry, &mem), FMB_OK);
        for (int j = 0; j < N; j++)
            mpz_clear(entry[j]);
    }
    mpz_set(a, row[0].z[0]);
    for (bool kept = true; kept; limit++) {
        waiting w = {.limit = limit};
        num.poll = (fmb_poll){ask, &w};
        st = fmb_vec_cancel(&row[0], &row[0], &row[1], N, 0, &num);
        kept = fmb_vec_sgn(&row[0], 0) != 0 && mpz_cmp(row[0].z[0], a) == 0;
        cr_assert(!kept || st == FMB_ERR_IO);
    }
    cr_expect_geq(limit, 8, "%zu calls", limit);
    cr_expect_eq(fmb_vec_sgn(&row[0], 0), 0);
    num.poll = (fmb_poll){0};
    cr_assert_eq(fmb_vec_reduce(&row[0], N, &num), FMB_OK);
    cr_expect_eq(fmb_vec_sgn(&row[0], 0), 0);
    fmb_vec_clear(&row[0], N, &mem);
    fmb_vec_clear(&row[1], N, &mem);
    fmb_num_clear(&num);
    cr_expect_eq(mem.used, 0);
}

/* Division of a row by its content, which is long, is broken off between any two entries: then the
 * row is as it was. */
Test(long_gcd, division_is_broken_off)
{
    enum { N = 3 };
    fmb_mem mem;
    fmb_num num;
    int64_t words[N] = {0};
    fmb_vec row = {.s = words};
    mpz_t entry[N];
    waiting all = {.limit = SIZE_MAX};
    fmb_mem_init(&mem, NULL, 0);
    cr_assert_eq(fmb_num_init(&num, &mem, N, false), FMB_OK);
    mpz_urandomb(a, draw, 600000);
    mpz_setbit(a, 600000);
    for (int j = 0; j < N; j++) {
        mpz_init(entry[j]);
        mpz_urandomb(b, draw, 100);
        mpz_mul(entry[j], a, b);
    }
    cr_assert_eq(fmb_vec_set_z(&row, N, entry, &mem), FMB_OK);
    num.poll = (fmb_poll){ask, &all};
    cr_assert_eq(fmb_vec_reduce(&row, N, &num), FMB_OK);
    cr_assert_gt(all.asked, N);
    for (size_t back = 0; back < N; back++) {
        waiting w = {.limit = all.asked - back};
        cr_assert_eq(fmb_vec_set_z(&row, N, entry, &mem), FMB_OK);
        num.poll = (fmb_poll){ask, &w};
        cr_expect_eq(fmb_vec_reduce(&row, N, &num), FMB_ERR_IO);
        for (int j = 0; j < N; j++)
            cr_expect_eq(mpz_cmp(row.z[j], entry[j]), 0, "%zu, %d", back, j);
    }
    for (int j = 0; j < N; j++)
        mpz_clear(entry[j]);
    fmb_vec_clear(&row, N, &mem);
    fmb_num_clear(&num);
    cr_expect_eq(mem.used, 0);
}
