/* test.c: the generators keep their promises, and the shrinker shrinks. */
#include <criterion/criterion.h>
#include <stdlib.h>

#include "dense.h"
#include "study/textbook/exact.h"

static fmb_verdict solve(const fmb_system *s)
{
    fmb_verdict v = FMB_UNKNOWN;
    cr_assert_eq(study_textbook_solve(s, 20000, &v), FMB_OK);
    return v;
}

/* The same rows in the same order. */
static bool same(const fmb_system *a, const fmb_system *b)
{
    dense x = dense_of(a), y = dense_of(b);
    bool good = x.dim == y.dim && x.rows == y.rows;
    for (int i = 0; good && i < x.rows; i++) {
        good = x.rel[i] == y.rel[i];
        for (int j = 0; good && j <= x.dim; j++)
            good = mpq_equal(dense_row(&x, i)[j], dense_row(&y, i)[j]) != 0;
    }
    dense_free(&x);
    dense_free(&y);
    return good;
}

Test(support, seeds_repeat)
{
    for (support_family family = 0; family < SUPPORT_FAMILIES; family++) {
        support_case a = support_make(family, 11, NULL), b = support_make(family, 11, NULL),
                     c = support_make(family, 12, NULL);
        cr_expect(same(a.s, b.s));
        cr_expect_not(same(a.s, c.s));
        support_case_clear(&a);
        support_case_clear(&b);
        support_case_clear(&c);
    }
    support_rng g = {0};
    cr_expect_eq(support_next(&g), 0xe220a8397b1dcdafu); /* the published first output of seed 0 */
}

/* Each family without planted answers has feasible and infeasible members. */
Test(support, both_verdicts)
{
    static const support_family unplanned[] = {SUPPORT_DEGENERATE, SUPPORT_PARALLEL, SUPPORT_MIXED};
    for (int f = 0; f < 3; f++) {
        int count[3] = {0};
        for (uint64_t seed = 0; seed < 200; seed++) {
            support_case c = support_make(unplanned[f], seed, NULL);
            count[solve(c.s)]++;
            support_case_clear(&c);
        }
        cr_expect(count[FMB_FEASIBLE] > 20 && count[FMB_INFEASIBLE] > 20, "%s: %d and %d",
                  support_family_name(unplanned[f]), count[FMB_FEASIBLE], count[FMB_INFEASIBLE]);
    }
}

Test(support, wide_numbers)
{
    support_shape shape = {.dim = 3, .rows = 6, .bits = 200};
    support_case c = support_make(SUPPORT_MIXED, 3, &shape);
    dense d = dense_of(c.s);
    size_t bits = 0;
    for (int k = 0; k < d.rows * (d.dim + 1); k++)
        if (mpz_sizeinbase(mpq_numref(d.cell[k]), 2) > bits)
            bits = mpz_sizeinbase(mpq_numref(d.cell[k]), 2);
    cr_expect_geq(bits, 200);
    dense_free(&d);
    support_case_clear(&c);
}

Test(support, tiny)
{
    support_tiny at = {0};
    int count = 0, rows[5] = {0};
    for (fmb_system *s; (s = support_tiny_next(&at)); count++) {
        rows[fmb_system_rows(s)]++;
        fmb_system_free(s);
    }
    cr_expect_eq(count, SUPPORT_TINY_COUNT);
    /* One row: 3 left sides up to symmetry, (0, 0), (0, 1), (1, 1), with 3 right sides and 2
     * relations. */
    cr_expect_eq(rows[0], 1);
    cr_expect_eq(rows[1], 18);
}

static bool is_infeasible(void *self, const fmb_system *s)
{
    ++*(int *)self;
    return solve(s) == FMB_INFEASIBLE;
}

/* The smallest infeasible system: 0 <= -1 without variables. */
Test(support, shrink)
{
    for (uint64_t seed = 0; seed < 20; seed++) {
        support_case c = support_make(SUPPORT_PLANTED_FARKAS, seed, NULL);
        int asked = 0;
        fmb_system *small = support_shrink(c.s, is_infeasible, &asked);
        cr_expect(is_infeasible(&asked, small));
        cr_expect(fmb_system_rows(small) <= fmb_system_rows(c.s) && asked > 1);
        for (size_t i = 0; i < fmb_system_rows(small); i++) {
            fmb_system *less = NULL;
            dense d = dense_of(small), without = dense_without(&d, (int)i, -1);
            less = dense_system(&without);
            cr_expect_eq(solve(less), FMB_FEASIBLE);
            fmb_system_free(less);
            dense_free(&d);
            dense_free(&without);
        }
        fmb_system_free(small);
        support_case_clear(&c);
    }
}

Test(support, print)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    fmb_system *s = NULL;
    cr_assert_eq(fmb_system_new(3, NULL, &s), FMB_OK);
    cr_assert_eq(fmb_system_add_int(s, (int64_t[]){-1, 2, 0}, FMB_LE, 3), FMB_OK);
    cr_assert_eq(fmb_system_add_int(s, (int64_t[]){0, 0, 0}, FMB_EQ, 1), FMB_OK);
    cr_assert_eq(fmb_system_add(s, (double[]){0.5, 0, -1}, FMB_LT, -0.25), FMB_OK);
    support_print(s, "seed 1", out);
    fclose(out);
    cr_expect_str_eq(text,
                     "# seed 1\nvars: x1 x2 x3\n-x1 + 2 x2 <= 3\n0 = 1\n1/2 x1 - x3 < -1/4\n");
    free(text);
    fmb_system_free(s);
}
