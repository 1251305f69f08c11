/* answers.c: the point and the conflict of the last answer, without its evidence, checked against
 * the rows of the system. */
#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "property/random/options.h"
#include "property/random/rows.h"
#include "support.h"

/* The left side of row i at the point, minus its right side. */
static void slack_at_point(const fmb_solver *v, const fmb_system *s, size_t i, mpq_t out)
{
    mpq_t a, x;
    mpq_inits(a, x, NULL);
    fmb_system_rhs_q(s, i, out);
    mpq_neg(out, out);
    for (size_t k = 0; k < fmb_system_terms(s, i); k++) {
        fmb_solver_point_q(v, fmb_system_term_q(s, i, k, a), x);
        mpq_mul(a, a, x);
        mpq_add(out, out, a);
    }
    mpq_clears(a, x, NULL);
}

/* All three ways to read a number agree. */
static void expect_same_number(mpq_t q, double nearest, const char *text, size_t length)
{
    char *want = mpq_get_str(NULL, 10, q);
    cr_expect_str_eq(text, want);
    cr_expect_eq(length, strlen(want));
    cr_expect_float_eq(nearest, mpq_get_d(q), 1e-9 * (1 + fabs(nearest)));
    free(want);
}

static void expect_solution(fmb_solver *v, const fmb_system *s, const char *ways)
{
    double x[64];
    char text[4000];
    mpq_t q;
    mpq_init(q);
    must(fmb_solver_point(v, x));
    for (size_t i = 0; i < fmb_system_rows(s); i++) {
        slack_at_point(v, s, i, q);
        fmb_rel rel = fmb_system_rel(s, i);
        int sign = mpq_sgn(q);
        cr_expect(rel == FMB_EQ ? sign == 0 : rel == FMB_LT ? sign < 0 : sign <= 0, "%s", ways);
    }
    for (int j = 0; j < fmb_system_dim(s); j++) {
        size_t length = fmb_solver_point_text(v, j, text, sizeof text);
        fmb_solver_point_q(v, j, q);
        expect_same_number(q, x[j], text, length);
    }
    size_t n = 7;
    cr_expect_eq(fmb_solver_conflict(v, &n), FMB_ERR_STATE);
    cr_expect_str_eq(fmb_solver_trouble(v), "the last answer has no conflict");
    cr_expect_eq(n, 7);
    mpq_clear(q);
}

/* The rows of the conflict alone, but for the one of number `without` among them. */
static fmb_verdict judge_conflict(const fmb_solver *v, size_t n, const fmb_system *s,
                                  size_t without)
{
    fmb_system *part = rows_none(fmb_system_dim(s));
    fmb_solver *other = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_solver_new(NULL, NULL, &other));
    for (size_t k = 0; k < n; k++)
        if (k != without)
            rows_append(part, s, fmb_solver_conflict_row(v, k), ROW_SAME, NULL);
    must(fmb_solve(other, part, &r));
    fmb_system_free(part);
    fmb_solver_free(other);
    return r.verdict;
}

/* Irreducible: infeasible, and feasible without any one row. Coprime whole multipliers, those of
 * inequalities positive. */
static void expect_irreducible(fmb_solver *v, const fmb_system *s, const char *ways)
{
    size_t n = 0;
    double x[64];
    char text[4000];
    mpq_t y;
    mpq_init(y);
    must(fmb_solver_conflict(v, &n));
    cr_assert_gt(n, 0);
    cr_expect_eq(judge_conflict(v, n, s, SIZE_MAX), FMB_INFEASIBLE, "%s", ways);
    for (size_t k = 0; k < n; k++) {
        size_t row = fmb_solver_conflict_row(v, k);
        size_t length = fmb_solver_conflict_multiplier_text(v, k, text, sizeof text);
        cr_assert_lt(row, fmb_system_rows(s));
        cr_expect(k == 0 || row > fmb_solver_conflict_row(v, k - 1), "%s", ways);
        cr_expect_eq(judge_conflict(v, n, s, k), FMB_FEASIBLE, "%s", ways);
        fmb_solver_conflict_multiplier_q(v, k, y);
        cr_expect(mpq_sgn(y) > 0 || fmb_system_rel(s, row) == FMB_EQ, "%s", ways);
        expect_same_number(y, fmb_solver_conflict_multiplier(v, k), text, length);
    }
    cr_expect_eq(fmb_solver_conflict_row(v, n), SIZE_MAX);
    cr_expect_eq(fmb_solver_conflict_multiplier(v, n), 0);
    cr_expect_eq(fmb_solver_point(v, x), FMB_ERR_STATE);
    cr_expect_str_eq(fmb_solver_trouble(v), "the last answer has no point");
    mpq_clear(y);
}

static fmb_verdict ask(fmb_solver *v, const fmb_system *s, int question)
{
    fmb_result r = {.size = sizeof r};
    fmb_system *out = NULL;
    fmb_box *box = NULL;
    static const int one[1];
    if (question == 0)
        must(fmb_solve(v, s, &r));
    else if (question == 1)
        must(fmb_bound(v, s, NULL, 0, &box, &r));
    else if (question == 2)
        must(fmb_project(v, s, one, 1, &out, &r));
    else
        must(fmb_reduce(v, s, NULL, &out, &r));
    fmb_box_free(box);
    fmb_system_free(out);
    return r.verdict;
}

Test(answers, of_every_way_to_ask)
{
    int feasible = 0, infeasible = 0;
    for (int i = 0; i < options_count(); i += 5) {
        char ways[200];
        fmb_options o = options_at(i);
        fmb_solver *v = NULL;
        o.evidence = i % 2 ? FMB_EVIDENCE_VERDICT : FMB_EVIDENCE_ALL;
        options_text(&o, ways, sizeof ways);
        must(fmb_solver_new(&o, NULL, &v));
        for (uint64_t seed = 0; seed < 8; seed++) {
            support_case c = support_make(seed % 2 ? SUPPORT_MIXED : SUPPORT_PLANTED_FARKAS,
                                          1000 * (uint64_t)i + seed, NULL);
            bool solved = ask(v, c.s, (int)(seed / 2 % 4)) == FMB_FEASIBLE;
            (solved ? expect_solution : expect_irreducible)(v, c.s, ways);
            *(solved ? &feasible : &infeasible) += 1;
            support_case_clear(&c);
        }
        fmb_solver_free(v);
    }
    cr_expect(feasible > 20 && infeasible > 20, "%d and %d", feasible, infeasible);
}

/* A third of x is what it is; so is a multiplier that no double holds. */
Test(answers, exact_numbers)
{
    static const char text[] = "3x = 1\n", clash[] = "100000000000000000001 y <= 7\n7 y >= 1\n";
    static const fmb_reader how = {.size = sizeof how, .format = FMB_FORMAT_TEXT};
    fmb_system *s = NULL, *t = NULL;
    fmb_solver *v = NULL;
    char room[64] = "untouched";
    size_t n;
    double x;
    must(fmb_system_parse(text, sizeof text - 1, &how, &s, NULL));
    must(fmb_system_parse(clash, sizeof clash - 1, &how, &t, NULL));
    must(fmb_solver_new(NULL, NULL, &v));
    must(fmb_solve(v, s, NULL));
    must(fmb_solver_point(v, &x));
    cr_expect_float_eq(x, 1.0 / 3, 0);
    cr_expect_eq(fmb_solver_point_text(v, 0, room, 3), 3);
    cr_expect_str_eq(room, "untouched", "no room for the NUL");
    cr_expect_eq(fmb_solver_point_text(v, 0, room, 4), 3);
    cr_expect_str_eq(room, "1/3");
    cr_expect_eq(fmb_solver_point_text(v, 1, room, sizeof room), 1);
    cr_expect_eq(fmb_solver_point_text(v, -1, NULL, 0), 1);
    must(fmb_solve(v, t, NULL));
    must(fmb_solver_conflict(v, &n));
    cr_assert_eq(n, 2);
    fmb_solver_conflict_multiplier_text(v, 0, room, sizeof room);
    cr_expect_str_eq(room, "7");
    fmb_solver_conflict_multiplier_text(v, 1, room, sizeof room);
    cr_expect_str_eq(room, "100000000000000000001");
    fmb_solver_free(v);
    fmb_system_free(s);
    fmb_system_free(t);
}

static void expect_state(fmb_solver *v, const char *why)
{
    double x[3] = {5, 5, 5};
    size_t n = 5;
    cr_expect_eq(fmb_solver_point(v, x), FMB_ERR_STATE);
    cr_expect_str_eq(fmb_solver_trouble(v), why);
    cr_expect_eq(fmb_solver_conflict(v, &n), FMB_ERR_STATE);
    cr_expect_str_eq(fmb_solver_trouble(v), why);
    cr_expect(x[0] == 5 && n == 5, "nothing is written");
    cr_expect_eq(fmb_solver_conflict_row(v, 0), SIZE_MAX);
    cr_expect_eq(fmb_solver_point_text(v, 0, NULL, 0), 1);
}

Test(answers, not_kept)
{
    fmb_options o = {.size = sizeof o};
    fmb_system *s = rows_none(3);
    fmb_solver *v = NULL;
    o.evidence = FMB_EVIDENCE_NONE;
    must(fmb_system_add_int(s, (int64_t[]){1, 1, 1}, FMB_LE, 1));
    must(fmb_solver_new(&o, NULL, &v));
    expect_state(v, "no query has ended with an answer");
    must(fmb_solve(v, s, NULL));
    expect_state(v, "the last query kept no evidence (options.evidence)");
    fmb_solver_free(v);
    fmb_system_free(s);
}

Test(answers, arguments)
{
    fmb_solver *v = NULL;
    double x;
    size_t n;
    must(fmb_solver_new(NULL, NULL, &v));
    cr_expect_eq(fmb_solver_point(NULL, &x), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_conflict(NULL, &n), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_point(v, NULL), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(v), "x is NULL");
    cr_expect_eq(fmb_solver_conflict(v, NULL), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(v), "n is NULL");
    cr_expect_eq(fmb_solver_conflict_row(NULL, 0), SIZE_MAX);
    cr_expect_eq(fmb_solver_conflict_multiplier(NULL, 0), 0);
    cr_expect_eq(fmb_solver_conflict_multiplier_text(NULL, 0, NULL, 0), 1);
    cr_expect_eq(fmb_solver_point_text(NULL, 0, NULL, 0), 1);
    fmb_solver_point_q(NULL, 0, NULL);
    fmb_solver_conflict_multiplier_q(NULL, 0, NULL);
    fmb_solver_free(v);
}
