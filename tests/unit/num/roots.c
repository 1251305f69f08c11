/* roots.c: doubles nearest to the roots of rationals, against exact comparisons. */
#include <criterion/criterion.h>
#include <math.h>

#include "num/rationals.h"
#include "support/support.h"

/* x = ((a + b) / 2)^2 for neighbouring doubles. */
static void square_middle(mpq_t x, double a, double b)
{
    mpq_t y;
    mpq_init(y);
    mpq_set_d(x, a);
    mpq_set_d(y, b);
    mpq_add(x, x, y);
    mpq_div_2exp(x, x, 1);
    mpq_mul(x, x, x);
    mpq_clear(y);
}

/* The root lies between the middles of r and its neighbours. */
static bool is_nearest_root(mpq_srcptr q, double r)
{
    mpq_t lower, upper;
    mpq_inits(lower, upper, NULL);
    square_middle(upper, r, nextafter(r, INFINITY));
    if (r > 0)
        square_middle(lower, nextafter(r, 0), r);
    bool good = mpq_cmp(lower, q) <= 0 && mpq_cmp(q, upper) <= 0;
    mpq_clears(lower, upper, NULL);
    return good;
}

Test(roots, nearest_roots)
{
    mpq_t q;
    mpq_init(q);
    cr_expect(fmb_nearest_root(q) == 0);
    support_rng g = {5};
    for (int i = 0; i < 4000; i++) {
        int power = support_between(&g, -2160, 2000);
        mpq_set_ui(q, support_next(&g) >> support_between(&g, 0, 63) | 1,
                   i % 2 ? 1 : support_next(&g) >> support_between(&g, 0, 63) | 1);
        mpq_canonicalize(q);
        if (power >= 0)
            mpq_mul_2exp(q, q, (mp_bitcnt_t)power);
        else
            mpq_div_2exp(q, q, (mp_bitcnt_t)-power);
        double r = fmb_nearest_root(q);
        if (isfinite(nextafter(r, INFINITY)))
            cr_assert(is_nearest_root(q, r), "case %d, 2^%d: %a", i, power, r);
    }
    mpq_clear(q);
}

/* Beside a middle of two doubles, however little. */
Test(roots, roots_at_middles)
{
    static const double at[] = {1, 0x1p-1022, 0x1p-1074, 0x1p-1050, 0x1p1000, 0x1p-300};
    mpq_t q, little;
    mpq_inits(q, little, NULL);
    mpq_set_ui(little, 1, 1);
    mpq_div_2exp(little, little, 5000);
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        double next = nextafter(at[i], INFINITY);
        square_middle(q, at[i], next);
        mpq_add(q, q, little);
        cr_expect(fmb_nearest_root(q) == next, "%a", at[i]);
        mpq_sub(q, q, little);
        mpq_sub(q, q, little);
        cr_expect(fmb_nearest_root(q) == at[i], "%a", at[i]);
    }
    mpq_clears(q, little, NULL);
}

static void expect_nearest(mpq_t q, double is)
{
    cr_expect(fmb_nearest_double(q) == is, "%a", is);
    mpq_neg(q, q);
    cr_expect(fmb_nearest_double(q) == -is, "-%a", is);
    mpq_neg(q, q);
}

/* At the middle of two doubles the even one; beside it, however little, the nearer one. */
Test(roots, doubles_nearest_to_middles)
{
    static const double at[] = {1, 0, 0x1p-1022, 0x1p-1074, 0x1p-1050, 0x1p1000, 0x1p-300, 0x1.8p7};
    mpq_t q, little;
    mpq_inits(q, little, NULL);
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        double next = nextafter(at[i], INFINITY), after = nextafter(next, INFINITY);
        bool even = at[i] != 0x1p-1074;
        mpq_set_d(q, at[i]);
        expect_nearest(q, at[i]);
        mpq_set_d(little, next);
        mpq_add(q, q, little);
        mpq_div_2exp(q, q, 1);
        expect_nearest(q, even ? at[i] : next);
        mpq_set_ui(little, 1, 3);
        mpq_div_2exp(little, little, 5000);
        mpq_add(q, q, little);
        expect_nearest(q, next);
        mpq_sub(q, q, little);
        mpq_sub(q, q, little);
        expect_nearest(q, at[i]);
        mpq_set_d(q, next);
        mpq_set_d(little, after);
        mpq_add(q, q, little);
        mpq_div_2exp(q, q, 1);
        expect_nearest(q, even ? after : next);
    }
    mpq_set_ui(q, 1, 1);
    mpq_mul_2exp(q, q, 1024);
    mpq_set_ui(little, 1, 3);
    mpq_sub(q, q, little);
    expect_nearest(q, 0x1.fffffffffffffp1023);
    mpq_clears(q, little, NULL);
}
