/* tiny.c: the elimination on the stack against the exact simplex and the ground truth.
 *
 * FMB_TINY_RUNS in the environment is the number of random systems of each kind.
 */
#include <criterion/criterion.h>

#include <stdlib.h>

#include "counted_clock.h"
#include "elim/tiny/tiny.h"
#include "study/textbook/exact.h"
#include "support.h"

/* ---- random systems -------------------------------------------------------------------------- */

/* Numbers of up to `bits` bits; rows through a point, moved by at most `slack` either way. */
typedef struct kind {
    int dim, rows, bits, slack, zeros, boxes;
} kind;

static const kind KINDS[] = {
    {2, 8, 4, 2, 20, 50},   {3, 14, 4, 2, 30, 40},  {4, 16, 4, 3, 40, 40},  {6, 14, 3, 2, 50, 30},
    {5, 20, 1, 1, 50, 40},  {3, 64, 6, 3, 20, 10},  {6, 64, 2, 2, 60, 20},  {4, 12, 16, 50, 30, 40},
    {5, 12, 20, 9, 20, 20}, {3, 12, 31, 3, 20, 30}, {5, 12, 45, 3, 20, 30}, {4, 12, 61, 1, 20, 40},
};
enum { KINDS_SIZE = sizeof KINDS / sizeof *KINDS, MOST = 9 };

static int64_t number(support_rng *g, int bits)
{
    int width = support_between(g, 1, bits);
    int64_t v = (int64_t)(support_next(g) >> (64 - width));
    return support_next(g) & 1 ? v : -v;
}

static fmb_system *make(const kind *k, uint64_t seed)
{
    support_rng g = {seed};
    int dim = support_between(&g, 1, k->dim), rows = support_between(&g, 1, k->rows);
    int64_t x[MOST], a[64][MOST], b[64];
    fmb_system *s = NULL;
    cr_assert_eq(fmb_system_new(dim, NULL, &s), FMB_OK);
    for (int j = 0; j < dim; j++)
        x[j] = support_between(&g, -3, 3);
    for (int i = 0; i < rows; i++) {
        int64_t value = 0;
        int copied = i > 0 && support_chance(&g, 10) ? support_between(&g, 0, i - 1) : -1;
        int sign = support_chance(&g, 50) ? 1 : -1, only = support_between(&g, 0, dim - 1);
        bool end = support_chance(&g, k->boxes);
        for (int j = 0; j < dim; j++) {
            bool none = end ? j != only : support_chance(&g, k->zeros);
            a[i][j] = copied >= 0 ? sign * a[copied][j] : none ? 0 : number(&g, k->bits);
            value = (int64_t)((uint64_t)value + (uint64_t)a[i][j] * (uint64_t)x[j]);
        }
        if (value > INT64_MAX / 2 || value < -(INT64_MAX / 2))
            value /= 2;
        b[i] = value + support_between(&g, support_chance(&g, 90) ? 0 : -k->slack, k->slack);
        fmb_rel rel = support_chance(&g, 15) ? FMB_LT : FMB_LE;
        cr_assert_eq(fmb_system_add_int(s, a[i], rel, b[i]), FMB_OK);
    }
    return s;
}

/* ---- judges ---------------------------------------------------------------------------------- */

static fmb_solver *simplex(void)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    o.method = FMB_METHOD_LP;
    o.evidence = FMB_EVIDENCE_NONE;
    cr_assert_eq(fmb_solver_new(&o, NULL, &v), FMB_OK);
    return v;
}

/* FMB_UNKNOWN: the ground truth would take too long. */
static fmb_verdict ground_truth(const fmb_system *s)
{
    fmb_verdict verdict = FMB_UNKNOWN;
    cr_assert_eq(study_textbook_solve(s, 400, &verdict), FMB_OK);
    return verdict;
}

static bool is_wrong(fmb_verdict a, fmb_verdict b)
{
    return a != FMB_UNKNOWN && b != FMB_UNKNOWN && a != b;
}

static bool differs(void *self, const fmb_system *s)
{
    fmb_stats stats = {0};
    fmb_result r = {.size = sizeof r};
    cr_assert_eq(fmb_solve(self, s, &r), FMB_OK);
    return is_wrong(fmb_tiny_decide(s, &stats), r.verdict);
}

static void refuse(fmb_solver *v, const fmb_system *s, uint64_t seed)
{
    fmb_system *small = support_shrink(s, differs, v);
    support_print(small, "wrong verdict", stderr);
    cr_assert_fail("seed %llu", (unsigned long long)seed);
}

Test(tiny, random_systems)
{
    const char *text = getenv("FMB_TINY_RUNS");
    uint64_t runs = text ? strtoull(text, NULL, 10) : 12000 / WATCHED;
    uint64_t unknown[KINDS_SIZE] = {0}, seen[3] = {0};
    fmb_solver *v = simplex();
    for (uint64_t seed = 0; seed < runs * KINDS_SIZE; seed++) {
        fmb_stats stats = {0};
        fmb_system *s = make(&KINDS[seed % KINDS_SIZE], seed);
        fmb_verdict said = fmb_tiny_decide(s, &stats);
        if (differs(v, s) || (seed % 64 == 0 && is_wrong(said, ground_truth(s))))
            refuse(v, s, seed);
        unknown[seed % KINDS_SIZE] += said == FMB_UNKNOWN;
        seen[said]++;
        fmb_system_free(s);
    }
    fmb_solver_free(v);
    cr_expect_gt(seen[FMB_FEASIBLE], runs);
    cr_expect_gt(seen[FMB_INFEASIBLE], runs);
    cr_expect_gt(seen[FMB_UNKNOWN], 0, "rows that do not fit are met");
    for (int k = 0; k < 5; k++)
        cr_expect_lt(unknown[k], runs / 20, "kind %d: %llu", k, (unsigned long long)unknown[k]);
}

Test(tiny, all_of_two_variables)
{
    support_tiny at = {0};
    uint64_t systems = 0;
    for (fmb_system *s; (s = support_tiny_next(&at)) != NULL; systems++) {
        fmb_stats stats = {0};
        cr_assert_eq(fmb_tiny_decide(s, &stats), ground_truth(s), "system %llu",
                     (unsigned long long)systems);
        fmb_system_free(s);
    }
    cr_assert_eq(systems, SUPPORT_TINY_COUNT);
}

/* ---- tight rows ------------------------------------------------------------------------------ */

enum { NAMING = 16 };

/* Rows of m over n columns, each of which names some, and has the same sign as others so often that
 * no solution, or none strictly inside, is frequent. */
static void draw_naming_rows(support_rng *g, size_t n, size_t m, int64_t words[][MOST + 1],
                             fmb_vec *row)
{
    int bits = support_between(g, 1, 8);
    for (size_t i = 0; i < m; i++) {
        int only = support_chance(g, 40) ? support_between(g, 0, (int)n - 1) : -1;
        for (size_t j = 0; j < n; j++)
            words[i][j] = only < 0 && support_chance(g, 60) ? number(g, bits) : 0;
        words[i][only < 0 ? support_between(g, 0, (int)n - 1) : only] =
            support_chance(g, 50) ? 1 : -1;
        words[i][n] = support_chance(g, 60) ? 0 : number(g, bits);
        row[i] = (fmb_vec){.s = words[i]};
        fmb_vec_measure(&row[i], n + 1);
    }
}

/* By the simplex: those of a set of rows, all of them strict, or row `strict` alone. */
static fmb_verdict decide_some(fmb_solver *v, size_t n, size_t m, const fmb_vec *row, uint64_t set,
                               size_t strict)
{
    fmb_system *s = NULL;
    fmb_result r = {.size = sizeof r};
    cr_assert_eq(fmb_system_new((int)n, NULL, &s), FMB_OK);
    for (size_t i = 0; i < m; i++) {
        fmb_rel rel = strict == SIZE_MAX || strict == i ? FMB_LT : FMB_LE;
        if (set >> i & 1)
            cr_assert_eq(fmb_system_add_int(s, row[i].s, rel, row[i].s[n]), FMB_OK);
    }
    cr_assert_eq(fmb_solve(v, s, &r), FMB_OK);
    fmb_system_free(s);
    return r.verdict;
}

Test(tiny, rows_that_are_tight)
{
    fmb_solver *v = simplex();
    int64_t words[NAMING][MOST + 1];
    fmb_vec row[NAMING];
    uint64_t runs = 6000 / WATCHED, seen[3] = {0};
    for (uint64_t seed = 0; seed < runs; seed++) {
        support_rng g = {seed};
        size_t n = (size_t)support_between(&g, 1, 5), m = (size_t)support_between(&g, 1, NAMING);
        uint64_t tight, all = ((uint64_t)1 << m) - 1;
        draw_naming_rows(&g, n, m, words, row);
        fmb_verdict said = fmb_tiny_find_tight(n, m, row, &tight);
        seen[said]++;
        if (said != FMB_UNKNOWN) {
            cr_assert_eq(said, decide_some(v, n, m, row, all, SIZE_MAX), "seed %d", (int)seed);
            cr_assert_eq(tight != 0, said == FMB_INFEASIBLE);
            cr_assert_eq(tight & ~all, 0);
        }
        for (size_t i = 0; said == FMB_INFEASIBLE && i < m; i++)
            if (tight >> i & 1)
                cr_assert_eq(decide_some(v, n, m, row, tight, i), FMB_INFEASIBLE,
                             "seed %d, row %zu", (int)seed, i);
    }
    fmb_solver_free(v);
    cr_expect_gt(seen[FMB_FEASIBLE], runs / 5);
    cr_expect_gt(seen[FMB_INFEASIBLE], runs / 5);
    cr_expect_lt(seen[FMB_UNKNOWN], runs / 50);
}

/* ---- by hand --------------------------------------------------------------------------------- */

static fmb_verdict decide(int dim, size_t rows, const int64_t *row, fmb_rel rel, fmb_stats *stats)
{
    fmb_system *s = NULL;
    cr_assert_eq(fmb_system_new(dim, NULL, &s), FMB_OK);
    for (size_t i = 0; i < rows; i++, row += dim + 1)
        cr_assert_eq(fmb_system_add_int(s, row, rel, row[dim]), FMB_OK);
    *stats = (fmb_stats){0};
    fmb_verdict verdict = fmb_tiny_decide(s, stats);
    fmb_system_free(s);
    return verdict;
}

Test(tiny, counts_rounds_and_pairs)
{
    /* x + y + z <= 3, x, y, z >= 1: one point, and none if the rows are strict. */
    const int64_t row[] = {1, 1, 1, 3, -1, 0, 0, -1, 0, -1, 0, -1, 0, 0, -1, -1};
    fmb_stats stats;
    cr_assert_eq(decide(3, 4, row, FMB_LE, &stats), FMB_FEASIBLE);
    cr_assert_eq(stats.rounds, 2);
    cr_assert_eq(stats.pairs, 2);
    cr_assert_eq(stats.rows_made, 2);
    cr_assert_eq(stats.rows_peak, 4);
    cr_assert_eq(decide(3, 4, row, FMB_LT, &stats), FMB_INFEASIBLE);
}

Test(tiny, the_box_alone)
{
    /* 2x <= 3, -2x <= -3 touches; with 0 <= x, y <= 1, x + y >= 3 fails and x + y <= 3 says
     * nothing. */
    const int64_t touch[] = {2, 3, -2, -3};
    const int64_t fails[] = {1, 0, 1, 0, 1, 1, -1, 0, 0, 0, -1, 0, -1, -1, -3};
    const int64_t slack[] = {1, 0, 1, 0, 1, 1, -1, 0, 0, 0, -1, 0, 1, 1, 3};
    fmb_stats stats;
    cr_assert_eq(decide(1, 2, touch, FMB_LE, &stats), FMB_FEASIBLE);
    cr_assert_eq(decide(1, 2, touch, FMB_LT, &stats), FMB_INFEASIBLE);
    cr_assert_eq(decide(2, 5, fails, FMB_LE, &stats), FMB_INFEASIBLE);
    cr_assert_eq(stats.rounds, 0);
    cr_assert_eq(decide(2, 5, slack, FMB_LE, &stats), FMB_FEASIBLE);
    cr_assert_eq(stats.rows_dropped, 1);
}

/* The last ends differ in the 125th bit. */
Test(tiny, long_fractions)
{
    const int64_t n = ((int64_t)1 << 61) - 1;
    const int64_t near[] = {n, n - 1, n - 2, 1 - n, 2 - n, 3 - n}; /* y >= -1/n of both */
    fmb_stats stats;
    for (int64_t d = -1; d <= 1; d++) {
        /* n x + (n-1) y <= n-2, -(n-1) x - (n-2) y <= 3-n+d: y <= 1 + d n from both */
        const int64_t row[] = {n, n - 1, n - 2, 1 - n, 2 - n, 3 - n + d, 0, -1, -1};
        fmb_system *s = NULL;
        cr_assert_eq(fmb_system_new(2, NULL, &s), FMB_OK);
        for (int i = 0; i < 3; i++)
            cr_assert_eq(fmb_system_add_int(s, row + 3 * i, FMB_LE, row[3 * i + 2]), FMB_OK);
        stats = (fmb_stats){0};
        fmb_verdict verdict = fmb_tiny_decide(s, &stats);
        cr_assert_eq(verdict, ground_truth(s), "%d", (int)d);
        fmb_system_free(s);
    }
    cr_assert_eq(decide(2, 2, near, FMB_LE, &stats), FMB_FEASIBLE);
}

/* Over such ends nine products of 62 bits would not fit in 128. */
Test(tiny, nine_large_ends)
{
    const int64_t most = ((int64_t)1 << 62) - 1;
    int64_t row[10][10] = {{0}}; /* x_k <= most, sum of (most - 2k) x_k >= 1 */
    fmb_stats stats;
    for (int k = 0; k < 9; k++) {
        row[k][k] = 1;
        row[k][9] = most;
        row[9][k] = 2 * k - most;
    }
    row[9][9] = -1;
    cr_assert_neq(decide(9, 10, row[0], FMB_LE, &stats), FMB_INFEASIBLE);
    for (int k = 0; k < 9; k++)
        row[9][k] = -row[9][k]; /* and sum <= -1 */
    cr_assert_neq(decide(9, 10, row[0], FMB_LE, &stats), FMB_INFEASIBLE);
}

Test(tiny, what_it_leaves_to_others)
{
    fmb_stats stats = {0};
    fmb_system *s = NULL;
    int64_t a[10] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    cr_assert_eq(fmb_system_new(10, NULL, &s), FMB_OK);
    cr_assert_eq(fmb_tiny_decide(s, &stats), FMB_UNKNOWN, "ten variables");
    fmb_system_free(s);
    cr_assert_eq(decide(1, 1, a, FMB_EQ, &stats), FMB_UNKNOWN, "an equality");
    cr_assert_eq(decide(0, 0, a, FMB_LE, &stats), FMB_FEASIBLE, "nothing");
    cr_assert_eq(fmb_system_new(1, NULL, &s), FMB_OK);
    for (int i = 0; i < 65; i++)
        cr_assert_eq(fmb_system_add_int(s, a, FMB_LE, i), FMB_OK);
    cr_assert_eq(fmb_tiny_decide(s, &stats), FMB_UNKNOWN, "65 rows");
    fmb_system_free(s);
}

/* ---- through fmb_solve ----------------------------------------------------------------------- */

static fmb_solver *usual(void)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    o.evidence = FMB_EVIDENCE_NONE;
    cr_assert_eq(fmb_solver_new(&o, NULL, &v), FMB_OK);
    return v;
}

/* Systems of all families, with equalities and long numbers, some tiny and some not. */
Test(tiny, families_through_the_solver)
{
    fmb_solver *v = usual(), *judge = simplex();
    fmb_evidence *none = NULL;
    uint64_t on_stack = 0;
    for (uint64_t seed = 0; seed < 20000; seed++) {
        support_case c = support_make((support_family)(seed % SUPPORT_FAMILIES), seed, NULL);
        fmb_result r = {.size = sizeof r}, truth = {.size = sizeof truth};
        fmb_stats stats = {0};
        counted_clock_start(0, NULL, NULL);
        cr_assert_eq(fmb_solve(v, c.s, &r), FMB_OK);
        counted_clock_stop();
        cr_assert_eq(fmb_solve(judge, c.s, &truth), FMB_OK);
        cr_assert_eq(r.verdict, truth.verdict, "seed %llu", (unsigned long long)seed);
        cr_assert_eq(r.trust, FMB_TRUST_EXACT);
        cr_assert_eq(r.stop, FMB_STOP_DONE);
        if (fmb_tiny_decide(c.s, &stats) != FMB_UNKNOWN) {
            on_stack++;
            cr_assert_eq(r.stats.pairs, stats.pairs);
            cr_assert_eq(r.stats.lps, 0);
            cr_assert_eq(r.stats.seconds, 1); /* one reading after the first */
        }
        cr_assert_eq(fmb_solver_evidence(v, &none), FMB_ERR_STATE);
        support_case_clear(&c);
    }
    cr_expect_gt(on_stack, 4000);
    cr_expect_lt(on_stack, 20000);
    fmb_solver_free(v);
    fmb_solver_free(judge);
}

/* What a query must stop at, it stops at. */
Test(tiny, limits_are_kept)
{
    const int64_t row[] = {1, 1, 1, -1, 1, 1, 1, -1, 1, -1, -1, 1};
    fmb_options o = {.size = sizeof o};
    fmb_system *s = NULL;
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    o.evidence = FMB_EVIDENCE_NONE;
    cr_assert_eq(fmb_system_new(2, NULL, &s), FMB_OK);
    for (int i = 0; i < 4; i++)
        cr_assert_eq(fmb_system_add_int(s, row + 3 * i, FMB_LE, row[3 * i + 2]), FMB_OK);
    o.method = FMB_METHOD_FM;
    o.max_seconds = 1;
    cr_assert_eq(fmb_solver_new(&o, NULL, &v), FMB_OK);
    counted_clock_start(0, NULL, NULL);
    fmb_status st = fmb_solve(v, s, &r);
    counted_clock_stop();
    cr_assert_eq(st, FMB_OK);
    cr_assert_eq(r.stop, FMB_STOP_TIME);
    fmb_solver_free(v);
    o.max_seconds = 0;
    o.max_bytes = 1;
    for (int evidence = 0; evidence < 2; evidence++) { /* on the stack no bytes are taken */
        o.evidence = evidence ? FMB_EVIDENCE_ALL : FMB_EVIDENCE_NONE;
        cr_assert_eq(fmb_solver_new(&o, NULL, &v), FMB_OK);
        cr_assert_eq(fmb_solve(v, s, &r), FMB_OK);
        cr_assert_eq(r.stop, evidence ? FMB_STOP_BYTES : FMB_STOP_DONE);
        fmb_solver_free(v);
    }
    fmb_system_free(s);
}
