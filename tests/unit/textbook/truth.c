/* truth.c: the ground truth against planted answers, and answers computed by hand. */
#include <criterion/criterion.h>
#include <stdlib.h>

#include "study/textbook/exact.h"
#include "support.h"
#include "unit/proof/samples.h"

static fmb_verdict solve(const fmb_system *s, size_t max_rows)
{
    fmb_verdict v = FMB_UNKNOWN;
    cr_assert_eq(study_textbook_solve(s, max_rows, &v), FMB_OK);
    return v;
}

static void expect_verdict(const char *text, fmb_verdict truth)
{
    fmb_system *s = proof_system(text, NULL);
    cr_expect_eq(solve(s, 0), truth, "%s", text);
    fmb_system_free(s);
}

Test(truth, verdicts)
{
    expect_verdict("x\n", FMB_FEASIBLE);
    expect_verdict("x\n0 <= 0", FMB_FEASIBLE);
    expect_verdict("x\n0 < 0", FMB_INFEASIBLE);
    expect_verdict("x\n0 = 1/3", FMB_INFEASIBLE);
    expect_verdict("x\n0 <= -1", FMB_INFEASIBLE);
    expect_verdict("x\n1 <= 0\n-1 <= 0", FMB_FEASIBLE);
    expect_verdict("x\n1 < 0\n-1 <= 0", FMB_INFEASIBLE);
    expect_verdict("x\n1 <= 0\n-1 < 0", FMB_INFEASIBLE);
    expect_verdict("x\n1 = 1\n2 = 3", FMB_INFEASIBLE);
    expect_verdict("x\n1 = 1\n2 = 2\n1 < 1", FMB_INFEASIBLE);
    expect_verdict("x y\n1 -1 = 0\n1 1 = 2\n1 0 <= 1", FMB_FEASIBLE);
    expect_verdict("x y\n1 -1 = 0\n1 1 = 2\n1 0 < 1", FMB_INFEASIBLE);
    expect_verdict("x y\n1 1 < 1\n-1 0 <= 0\n0 -1 <= -1", FMB_INFEASIBLE);
    /* infeasible, with multipliers 2, 3, 0, 1 and 6, 1, 1, 0, 3 */
    expect_verdict("u y\n1 -1 <= 0\n-1 0 <= -1\n-1 -1 <= -1\n1 2 <= -1", FMB_INFEASIBLE);
    expect_verdict("x y z\n1 -1 0 <= -1\n-1 2 2 <= -2\n1 1 -2 <= 1\n1 -2 0 <= -2\n-2 1 0 <= 1",
                   FMB_INFEASIBLE);
}

Test(truth, planted)
{
    for (support_family family = 0; family < SUPPORT_FAMILIES; family++)
        for (uint64_t seed = 0; seed < 3000; seed++) {
            support_case c = support_make(family, seed, NULL);
            fmb_verdict v = solve(c.s, 20000);
            cr_assert(c.verdict == FMB_UNKNOWN || v == FMB_UNKNOWN || v == c.verdict,
                      "%s, seed %llu", support_family_name(family), (unsigned long long)seed);
            support_case_clear(&c);
        }
}

/* ---- intervals ------------------------------------------------------------------------------- */

static void init_ends(study_textbook_end end[2])
{
    for (int side = 0; side < 2; side++) {
        end[side] = (study_textbook_end){.attained = true};
        mpq_init(end[side].value);
    }
}

static void clear_ends(study_textbook_end end[2])
{
    mpq_clears(end[0].value, end[1].value, NULL);
}

/* "[1/2, inf)" */
static void print_ends(study_textbook_end end[2], char *out, size_t size)
{
    char *low = mpq_get_str(NULL, 10, end[0].value), *high = mpq_get_str(NULL, 10, end[1].value);
    snprintf(out, size, "%c%s, %s%c", end[0].attained ? '[' : '(',
             end[0].kind == FMB_END_FINITE ? low : "-inf",
             end[1].kind == FMB_END_FINITE ? high : "inf", end[1].attained ? ']' : ')');
    free(low);
    free(high);
}

static void expect_interval(const char *text, int var, const char *truth)
{
    fmb_system *s = proof_system(text, NULL);
    study_textbook_end end[2];
    fmb_verdict v = FMB_UNKNOWN;
    char found[200];
    init_ends(end);
    cr_assert_eq(study_textbook_bound(s, var, 0, end, &v), FMB_OK);
    cr_assert_eq(v, FMB_FEASIBLE);
    print_ends(end, found, sizeof found);
    cr_expect_str_eq(found, truth, "%s: %s", text, found);
    clear_ends(end);
    fmb_system_free(s);
}

Test(truth, intervals)
{
    const char *triangle = "x y\n1 1 <= 4\n-1 0 <= 0\n0 -1 < 0\n2 0 <= 5";
    expect_interval(triangle, 0, "[0, 5/2]");
    expect_interval(triangle, 1, "(0, 4]");
    expect_interval("x y\n1 -1 <= 0\n0 1 < 7/3", 0, "(-inf, 7/3)");
    expect_interval("x y\n1 -1 <= 0\n0 1 < 7/3", 1, "(-inf, 7/3)");
    expect_interval("x y\n1 -1 = 0\n1 1 = 3\n1 0 <= 5", 0, "[3/2, 3/2]");
    expect_interval("x y\n0 1 <= 1", 0, "(-inf, inf)");
    expect_interval("x\n1 <= 1\n1 < 1\n-1 <= 2\n-2 <= 3", 0, "[-3/2, 1)");
    expect_interval("x y z\n1 1 1 = 1\n-1 0 0 <= 0\n0 -1 0 <= 0\n0 0 -1 < 0", 0, "[0, 1)");
    expect_interval("x y z\n1 1 1 = 1\n-1 0 0 <= 0\n0 -1 0 <= 0\n0 0 -1 < 0", 2, "(0, 1]");
}

/* The ends of every interval are confirmed by verdicts: the end itself can be had exactly if it is
 * attained, nothing lies beyond it, and what is just inside can be had. */
static fmb_verdict with_row(const fmb_system *s, int var, int sign, fmb_rel rel, const mpq_t end)
{
    fmb_system *more = NULL;
    mpq_t coef[1], rhs;
    mpq_inits(coef[0], rhs, NULL);
    mpq_set_si(coef[0], sign, 1);
    mpq_mul(rhs, coef[0], end);
    cr_assert_eq(fmb_system_copy(s, &more), FMB_OK);
    cr_assert_eq(fmb_system_add_q(more, 1, &var, coef, rel, rhs), FMB_OK);
    fmb_verdict v = solve(more, 20000);
    mpq_clears(coef[0], rhs, NULL);
    fmb_system_free(more);
    return v;
}

static void confirm_end(const fmb_system *s, int var, fmb_side side, const study_textbook_end *end)
{
    int outward = side == FMB_UPPER ? -1 : 1; /* sign of a row outward x <= ... that lies beyond */
    mpq_t far;
    mpq_init(far);
    if (end->kind == FMB_END_FINITE) {
        cr_assert_eq(with_row(s, var, 1, FMB_EQ, end->value),
                     end->attained ? FMB_FEASIBLE : FMB_INFEASIBLE);
        cr_assert_eq(with_row(s, var, outward, FMB_LT, end->value), FMB_INFEASIBLE);
        mpq_set_si(far, outward, 1000000);
        mpq_canonicalize(far);
        mpq_add(far, end->value, far);
    } else {
        mpz_ui_pow_ui(mpq_numref(far), 2, 300);
        if (side == FMB_LOWER)
            mpq_neg(far, far);
    }
    cr_assert_eq(with_row(s, var, outward, FMB_LE, far), FMB_FEASIBLE);
    mpq_clear(far);
}

Test(truth, ends_confirmed)
{
    for (uint64_t seed = 0; seed < 1000; seed++) {
        support_family family = (support_family)(seed % SUPPORT_FAMILIES);
        support_shape shape = {.dim = 1 + (int)(seed % 3), .rows = 1 + (int)(seed % 8)};
        support_case c = support_make(family, seed, &shape);
        for (int var = 0; var < shape.dim; var++) {
            study_textbook_end end[2];
            fmb_verdict v = FMB_UNKNOWN;
            init_ends(end);
            cr_assert_eq(study_textbook_bound(c.s, var, 20000, end, &v), FMB_OK);
            cr_assert_eq(v, solve(c.s, 20000));
            bool point = v == FMB_FEASIBLE && end[0].kind == FMB_END_FINITE &&
                         end[1].kind == FMB_END_FINITE && mpq_equal(end[0].value, end[1].value);
            for (int side = 0; v == FMB_FEASIBLE && !point && side < 2; side++)
                confirm_end(c.s, var, (fmb_side)side, &end[side]);
            clear_ends(end);
        }
        support_case_clear(&c);
    }
}

/* ---- limits and errors ----------------------------------------------------------------------- */

Test(truth, max_rows)
{
    support_shape shape = {.dim = 6, .rows = 14};
    support_case c = support_make(SUPPORT_PLANTED_POINT, 1, &shape);
    study_textbook_end end[2];
    fmb_verdict v = FMB_INFEASIBLE;
    fmb_system *out = NULL;
    int keep[] = {0, 3};
    init_ends(end);
    cr_expect_eq(solve(c.s, 15), FMB_UNKNOWN);
    cr_expect_eq(study_textbook_bound(c.s, 0, 15, end, &v), FMB_OK);
    cr_expect_eq(v, FMB_UNKNOWN);
    v = FMB_INFEASIBLE;
    cr_expect_eq(study_textbook_project(c.s, keep, 2, 15, &out, &v), FMB_OK);
    cr_expect(v == FMB_UNKNOWN && !out);
    clear_ends(end);
    support_case_clear(&c);
}

Test(truth, arguments)
{
    fmb_system *s = proof_system("x y\n1 1 <= 1", NULL), *out = NULL;
    study_textbook_end end[2];
    fmb_verdict v = FMB_UNKNOWN;
    int twice[] = {0, 0}, beyond[] = {2}, before[] = {-1};
    init_ends(end);
    cr_expect_eq(study_textbook_bound(s, 2, 0, end, &v), FMB_ERR_ARG);
    cr_expect_eq(study_textbook_bound(s, -1, 0, end, &v), FMB_ERR_ARG);
    cr_expect_eq(study_textbook_project(s, twice, 2, 0, &out, &v), FMB_ERR_ARG);
    cr_expect_eq(study_textbook_project(s, beyond, 1, 0, &out, &v), FMB_ERR_ARG);
    cr_expect_eq(study_textbook_project(s, before, 1, 0, &out, &v), FMB_ERR_ARG);
    cr_expect_null(out);
    clear_ends(end);
    fmb_system_free(s);
}
