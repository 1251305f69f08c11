/* long_numbers.c: verdicts on linear programs, found without an exact solution where possible
 * (lp/oracle/lattice_point.c, refute.c), against answers whose evidence fmb_check accepts. */
#include <criterion/criterion.h>

#include <string.h>

#include "property/random/agree.h"
#include "property/random/rows.h"
#include "study/program/program.h"
#include "support/support.h"

static fmb_verdict ask_with(const fmb_system *s, fmb_method method, fmb_evidence_kept evidence)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    o.method = method;
    o.evidence = evidence;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solve(v, s, &r));
    if (evidence != FMB_EVIDENCE_NONE) {
        fmb_evidence *e = NULL;
        fmb_judgement j = {.size = sizeof j};
        must(fmb_solver_evidence(v, &e));
        must(fmb_check(s, e, &j));
        cr_assert(j.accepted, "%s", j.reason);
        cr_assert_eq(j.verdict, r.verdict);
        fmb_evidence_free(e);
    }
    fmb_solver_free(v);
    return r.verdict;
}

/* The same verdict with evidence, which is accepted, and without. */
static fmb_verdict ask_oracle(const fmb_system *s)
{
    fmb_verdict proved = ask_with(s, FMB_METHOD_LP, FMB_EVIDENCE_ALL);
    cr_assert_eq(ask_with(s, FMB_METHOD_LP, FMB_EVIDENCE_NONE), proved);
    return proved;
}

static fmb_verdict ask_text(const char *text)
{
    fmb_system *s = NULL;
    must(fmb_system_parse(text, strlen(text), NULL, &s, NULL));
    fmb_verdict verdict = ask_oracle(s);
    cr_assert_eq(ask_with(s, FMB_METHOD_FM, FMB_EVIDENCE_ALL), verdict, "%s", text);
    fmb_system_free(s);
    return verdict;
}

Test(long_numbers, programs_in_every_dress_have_the_verdict_that_is_proved)
{
    static const char *const plan[] = {
        "sparse-point:60x20", "sparse-conflict:60x20",
        "dense-point:40x12",  "dense-conflict:60x12",
        "strict:40x12",       "strict-cycle:30x10",
        "equalities:40x16",   "degenerate:40x10",
        "unbounded:30x12",    "ball:80x5",
        "chain:12",           "chain-equal:12",
    };
    for (size_t k = 0; k < 2 * sizeof plan / sizeof *plan; k++) {
        study_program_plan how;
        study_program p;
        fmb_system *s = NULL, *t = NULL;
        const char *bad = "";
        cr_assert(study_program_plan_parse(plan[k / 2], &how, &bad), "%s", bad);
        how.seed = k;
        must(study_program_draw(&how, &p));
        if (p.verdict != FMB_UNKNOWN)
            cr_assert_eq(ask_oracle(p.s), p.verdict, "%s", plan[k / 2]);
        must(study_system_fractions(p.s, k % 2 ? 3 : 12, k, &s));
        ask_oracle(s);
        must(study_system_rescale(s, 20, k, NULL, &t));
        cr_assert_eq(ask_oracle(t), ask_oracle(s), "%s", plan[k / 2]);
        fmb_system_free(s);
        fmb_system_free(t);
        study_program_clear(&p);
    }
}

Test(long_numbers, small_systems_of_long_fractions_have_the_verdict_of_elimination)
{
    for (uint64_t seed = 0; seed < 150; seed++) {
        fmb_system *s = NULL;
        support_shape shape = {.dim = 4, .rows = 9, .bits = seed % 2 ? 0 : 200};
        support_case c = support_make((support_family)(seed % SUPPORT_FAMILIES), seed, &shape);
        must(study_system_fractions(c.s, 15, seed, &s));
        cr_assert_eq(ask_oracle(s), ask_with(s, FMB_METHOD_FM, FMB_EVIDENCE_NONE), "seed %lu",
                     (unsigned long)seed);
        fmb_system_free(s);
        support_case_clear(&c);
    }
}

#define THIN  "1/1000000000000000000000000000000"
#define LARGE "1000000000000000000000000000000"

Test(long_numbers, margins_are_told_apart_however_thin)
{
    cr_assert_eq(ask_text("x + y + z <= 1\nx + y + z >= 1\nx - y <= 0\ny - x <= 0\n"),
                 FMB_FEASIBLE);
    cr_assert_eq(ask_text("x + 3y < 1\nx + 3y > 1\n"), FMB_INFEASIBLE);
    cr_assert_eq(ask_text("x + 3y < 1 + " THIN "\nx + 3y > 1\nx >= 3\n"), FMB_FEASIBLE);
    cr_assert_eq(ask_text("x + 3y <= 1 - " THIN "\nx + 3y >= 1\nx - y >= 3\n"), FMB_INFEASIBLE);
    cr_assert_eq(ask_text("x + y <= 1\n-x + " THIN "y <= -1\ny >= " THIN "\n"), FMB_INFEASIBLE);
    cr_assert_eq(ask_text("x + y <= 1\n-x + " THIN "y <= -1\ny >= -1\n"), FMB_FEASIBLE);
    cr_assert_eq(ask_text("x + y + " LARGE " z <= 1\ny + z >= " LARGE "\nx >= 0\nx < " THIN "\n"),
                 FMB_FEASIBLE);
    cr_assert_eq(ask_text(LARGE " x = 1\nx + y = 1\ny >= 1\nx + 2y < 5\n"), FMB_INFEASIBLE);
    cr_assert_eq(ask_text(LARGE " x = 1\nx + y = 1\ny < 1\nx + 2y < 5\n"), FMB_FEASIBLE);
    cr_assert_eq(ask_text("x - " LARGE " y >= 1\ny - " LARGE " z >= 1\nz - " LARGE " x >= 1\n"),
                 FMB_FEASIBLE);
    cr_assert_eq(ask_text("x - " LARGE " y >= 1\ny - " LARGE " z >= 1\nz >= 0\nx <= 1\n"),
                 FMB_INFEASIBLE);
}

/* Three terms a row around a point, each of up to four digits, and a box of 10: [n] variables. */
static fmb_system *sparse_rows_in_box(support_rng *g, int n, int m)
{
    enum { MOST = 40 };
    fmb_system *s = rows_none(n);
    int64_t point[MOST];
    for (int j = 0; j < n; j++)
        point[j] = support_between(g, -3, 3);
    for (int i = 0; i < m; i++) {
        int64_t a[MOST] = {0}, at = 0;
        for (int k = 0; k < 3; k++)
            a[support_between(g, 0, n - 1)] = support_between(g, -1000, 1000);
        for (int j = 0; j < n; j++)
            at += a[j] * point[j];
        must(fmb_system_add_int(s, a, FMB_LE, at + support_between(g, 0, 3000)));
    }
    for (int k = 0; k < 2 * n; k++) {
        int64_t a[MOST] = {0};
        a[k / 2] = k % 2 ? 1 : -1;
        must(fmb_system_add_int(s, a, FMB_LE, 10));
    }
    return s;
}

Test(long_numbers, a_projection_does_not_prune_rows_of_them_for_long)
{
    for (uint64_t seed = 0; seed < 6; seed++) {
        support_rng g = {seed};
        fmb_system *s = sparse_rows_in_box(&g, 40, 56), *p[2];
        fmb_result r[2] = {{.size = sizeof r[0]}, {.size = sizeof r[0]}};
        agree equal = {.max_rows = 1};
        for (int k = 0; k < 2; k++) {
            fmb_options o = {.size = sizeof o};
            fmb_solver *v = NULL;
            o.method = k == 0 ? FMB_METHOD_AUTO : FMB_METHOD_HULL;
            o.evidence = FMB_EVIDENCE_NONE;
            must(fmb_solver_new(&o, NULL, &v));
            must(fmb_project(v, s, (int[]){0, 1, 2}, 3, &p[k], &r[k]));
            fmb_solver_free(v);
        }
        cr_expect_leq(r[0].stats.promotions, 4 * fmb_system_rows(s), "seed %lu: %lu",
                      (unsigned long)seed, (unsigned long)r[0].stats.promotions);
        cr_expect(agree_same(&equal, p[0], p[1]), "seed %lu: %s", (unsigned long)seed, equal.why);
        fmb_system_free(p[0]);
        fmb_system_free(p[1]);
        fmb_system_free(s);
    }
}

/* ---- units ----------------------------------------------------------------------------------- */

static void multiply_by_power(mpq_t q, int power)
{
    mpq_t unit;
    mpq_init(unit);
    mpq_set_ui(unit, 1, 1);
    mpz_ui_pow_ui(power < 0 ? mpq_denref(unit) : mpq_numref(unit), 3, (unsigned long)abs(power));
    mpq_mul(q, q, unit);
    mpq_clear(unit);
}

/* The rows of s, their right sides times 3^power; or, of_columns, columns times powers of 3 that
 * differ by so much. */
static fmb_system *rows_in_unit(const fmb_system *s, int power, bool of_columns)
{
    int n = fmb_system_dim(s), *var = calloc((size_t)n + 1, sizeof *var);
    mpq_t *a = calloc((size_t)n + 1, sizeof *a);
    fmb_system *t = rows_none(n);
    cr_assert(var && a);
    for (int j = 0; j <= n; j++)
        mpq_init(a[j]);
    for (size_t i = 0; i < fmb_system_rows(s); i++) {
        size_t terms = fmb_system_terms(s, i);
        for (size_t k = 0; k < terms; k++)
            var[k] = fmb_system_term_q(s, i, k, a[k]);
        for (size_t k = 0; of_columns && k < terms; k++)
            multiply_by_power(a[k], power * (var[k] % 3 - 1));
        fmb_system_rhs_q(s, i, a[n]);
        if (!of_columns)
            multiply_by_power(a[n], power);
        must(fmb_system_add_q(t, terms, var, a, fmb_system_rel(s, i), a[n]));
    }
    for (int j = 0; j <= n; j++)
        mpq_clear(a[j]);
    free(a);
    free(var);
    return t;
}

/* Of each row what fmb_reduce finds, and how many exact programs and pivots that and a box take. */
static uint64_t effort_of_fates_and_box(const fmb_system *s, fmb_fate *fate)
{
    int n = fmb_system_dim(s), vars[16];
    fmb_options o = {.size = sizeof o, .evidence = FMB_EVIDENCE_NONE};
    fmb_solver *v = NULL;
    fmb_system *reduced = NULL;
    fmb_box *box = NULL;
    fmb_result r[2] = {{.size = sizeof r[0]}, {.size = sizeof r[0]}};
    for (int j = 0; j < n; j++)
        vars[j] = j;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_reduce(v, s, fate, &reduced, &r[0]));
    must(fmb_bound(v, s, vars, n, &box, &r[1]));
    fmb_system_free(reduced);
    fmb_box_free(box);
    fmb_solver_free(v);
    return r[0].stats.lps + r[0].stats.pivots + r[1].stats.lps + r[1].stats.pivots;
}

/* Right sides far beyond what doubles can square, and nearly what they can hold; in half of the
 * cases columns that differ by up to 3^150. */
Test(long_numbers, units_cost_no_guess)
{
    enum { ROWS = 64, N = 12, ALL = ROWS + 2 * N };
    static const int power[] = {-600, -300, -40, 40, 300, 600};
    for (uint64_t seed = 0; seed < 4; seed++) {
        support_rng g = {seed};
        fmb_system *s = sparse_rows_in_box(&g, N, ROWS);
        fmb_fate fate[2][ALL];
        uint64_t least = effort_of_fates_and_box(s, fate[0]);
        for (size_t k = 0; k < 2 * sizeof power / sizeof *power; k++) {
            fmb_system *t = rows_in_unit(s, power[k / 2] / (k % 2 == 1 ? 8 : 1), k % 2 == 1);
            uint64_t effort = effort_of_fates_and_box(t, fate[1]);
            cr_expect_arr_eq(fate[0], fate[1], sizeof fate[0], "seed %lu, 3^%d, %d",
                             (unsigned long)seed, power[k / 2], (int)k % 2);
            cr_expect_leq(effort, least + least / 2, "seed %lu, 3^%d, %d: %lu for %lu",
                          (unsigned long)seed, power[k / 2], (int)k % 2, (unsigned long)effort,
                          (unsigned long)least);
            fmb_system_free(t);
        }
        fmb_system_free(s);
    }
}
