/* doubles.c: input doubles mean their exact binary values, output doubles are rounded outward. */
#include <criterion/criterion.h>
#include <float.h>
#include <math.h>

#include "property/random/rows.h"

static fmb_verdict verdict_of(const fmb_system *s)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solve(v, s, &r));
    fmb_solver_free(v);
    return r.verdict;
}

/* x = 0.1, y = 0.2, x + y = sum. The exact sum of the two doubles is no double: neither 0.3 nor the
 * rounded sum is it. */
Test(doubles, tenths)
{
    static const double ex[] = {1, 0}, ey[] = {0, 1}, both[] = {1, 1};
    static const double sums[] = {0.3, 0.1 + 0.2, 0.30000000000000001};
    for (int i = 0; i < 3; i++) {
        fmb_system *s = rows_none(2);
        must(fmb_system_add(s, ex, FMB_EQ, 0.1));
        must(fmb_system_add(s, ey, FMB_EQ, 0.2));
        must(fmb_system_add(s, both, FMB_EQ, sums[i]));
        cr_expect_eq(verdict_of(s), FMB_INFEASIBLE);
        fmb_system_free(s);
    }
    fmb_system *s = rows_none(2);
    must(fmb_system_add(s, ex, FMB_EQ, 0.1));
    must(fmb_system_add(s, ey, FMB_EQ, 0.2));
    must(fmb_system_add(s, both, FMB_LT, 0.1 + 0.2));
    cr_expect_eq(verdict_of(s), FMB_FEASIBLE, "the rounded sum lies above");
    fmb_system_free(s);
}

Test(doubles, exact_rationals)
{
    int var[] = {0, 1};
    mpq_t coef[2], b;
    mpq_inits(coef[0], coef[1], b, NULL);
    fmb_system *s = rows_none(2);
    mpq_set_ui(coef[0], 1, 1);
    mpq_set_ui(coef[1], 1, 1);
    mpq_set_ui(b, 1, 10);
    must(fmb_system_add_q(s, 1, var, coef, FMB_EQ, b));
    mpq_set_ui(b, 1, 5);
    must(fmb_system_add_q(s, 1, var + 1, coef, FMB_EQ, b));
    mpq_set_ui(b, 3, 10);
    must(fmb_system_add_q(s, 2, var, coef, FMB_EQ, b));
    cr_expect_eq(verdict_of(s), FMB_FEASIBLE);
    mpq_clears(coef[0], coef[1], b, NULL);
    fmb_system_free(s);
}

/* The interval of x in low <= x <= high. */
static void interval(const mpq_t low, const mpq_t high, fmb_end end[2])
{
    int var = 0;
    mpq_t coef[1];
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_box *box = NULL;
    fmb_result r = {.size = sizeof r};
    mpq_init(coef[0]);
    fmb_system *s = rows_none(1);
    mpq_set_si(coef[0], 1, 1);
    must(fmb_system_add_q(s, 1, &var, coef, FMB_LE, high));
    mpq_set_si(coef[0], -1, 1);
    mpq_t minus;
    mpq_init(minus);
    mpq_neg(minus, low);
    must(fmb_system_add_q(s, 1, &var, coef, FMB_LE, minus));
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_bound(v, s, NULL, 0, &box, &r));
    cr_assert_not_null(box);
    for (int side = 0; side < 2; side++) {
        end[side] = fmb_box_end(box, 0, (fmb_side)side);
        cr_assert(fmb_box_end_q(box, 0, (fmb_side)side, coef[0]));
        cr_assert(mpq_equal(coef[0], side == FMB_LOWER ? low : high));
        cr_assert(end[side].kind == FMB_END_FINITE && end[side].attained);
    }
    fmb_box_free(box);
    fmb_solver_free(v);
    fmb_system_free(s);
    mpq_clears(coef[0], minus, NULL);
}

/* Both ends at q: the doubles around q, or q itself. */
static void expect_outward(const mpq_t q)
{
    fmb_end end[2];
    mpq_t d;
    mpq_init(d);
    interval(q, q, end);
    mpq_set_d(d, end[FMB_LOWER].value);
    cr_expect_leq(mpq_cmp(d, q), 0);
    bool exact = mpq_equal(d, q);
    mpq_set_d(d, end[FMB_UPPER].value);
    cr_expect_geq(mpq_cmp(d, q), 0);
    cr_expect_eq(exact, mpq_equal(d, q) != 0);
    double next = exact ? end[FMB_LOWER].value : nextafter(end[FMB_LOWER].value, INFINITY);
    cr_expect(next == end[FMB_UPPER].value, "%a %a", end[FMB_LOWER].value, end[FMB_UPPER].value);
    mpq_clear(d);
}

Test(doubles, outward)
{
    static const char *const number[] = {"0",
                                         "1/3",
                                         "-1/3",
                                         "2/3",
                                         "1/10",
                                         "-7/10",
                                         "9007199254740993",
                                         "-9007199254740993",
                                         "9007199254740992",
                                         "18014398509481985/2",
                                         "1/9007199254740993",
                                         "123456789012345678901234567890/7",
                                         "5"};
    mpq_t q;
    mpq_init(q);
    for (size_t i = 0; i < sizeof number / sizeof *number; i++) {
        mpq_set_str(q, number[i], 10);
        mpq_canonicalize(q);
        expect_outward(q);
    }
    mpq_clear(q);
}

/* A third of a unit beside numbers of 1 to 53 bits, times 2^power: subnormal ones, too. */
Test(doubles, outward_at_every_scale)
{
    mpq_t q, third;
    mpq_inits(q, third, NULL);
    mpq_set_ui(third, 1, 3);
    for (int power = -1140; power <= 970; power += power < -1010 || power > 950 ? 1 : 97)
        for (int bits = 0; bits <= 53; bits += 53 - bits < 3 || bits < 3 ? 1 : 9)
            for (int sign = -1; sign <= 1; sign += 2) {
                mpq_set_d(q, sign * ldexp(1, bits));
                mpq_add(q, q, third);
                if (power < 0)
                    mpq_div_2exp(q, q, (mp_bitcnt_t)-power);
                else
                    mpq_mul_2exp(q, q, (mp_bitcnt_t)power);
                expect_outward(q);
            }
    mpq_clears(q, third, NULL);
}

/* Beyond the range of doubles. */
Test(doubles, range)
{
    fmb_end end[2];
    mpq_t q;
    mpq_init(q);
    mpq_set_ui(q, 1, 1);
    mpq_mul_2exp(q, q, 2000);
    interval(q, q, end);
    cr_expect(end[FMB_LOWER].value == DBL_MAX && end[FMB_UPPER].value == INFINITY);
    mpq_neg(q, q);
    interval(q, q, end);
    cr_expect(end[FMB_LOWER].value == -INFINITY && end[FMB_UPPER].value == -DBL_MAX);
    mpq_set_ui(q, 1, 1);
    mpq_div_2exp(q, q, 2000);
    interval(q, q, end);
    cr_expect(end[FMB_LOWER].value == 0 && end[FMB_UPPER].value == 0x1p-1074);
    mpq_set_ui(q, 3, 1);
    mpq_div_2exp(q, q, 1075);
    expect_outward(q);
    mpq_set_d(q, 0x1p-1074);
    expect_outward(q);
    mpq_clear(q);
}

Test(doubles, refused)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    fmb_system *s = rows_none(1);
    for (int i = 0; i < 3; i++) {
        double one = 1;
        cr_expect_eq(fmb_system_add(s, &bad[i], FMB_LE, 0), FMB_ERR_ARG);
        cr_expect_eq(fmb_system_add(s, &one, FMB_LE, bad[i]), FMB_ERR_ARG);
    }
    cr_expect_eq(fmb_system_rows(s), 0);
    fmb_system_free(s);
}
