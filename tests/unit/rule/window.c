/* window.c: what <fmb/rule.h> shows to a rule, against the rows themselves, on random systems:
 * histories, eliminated columns, ranks, and refused pairs. */
#include <criterion/criterion.h>
#include <string.h>

#include <fmb/gmp.h>

#include "property/random/rows.h"
#include "support.h"

enum { DIM = 6, PRIME_BITS = 61 };

/* What was looked at, so that a test that saw nothing fails. */
static struct seen {
    int rows, rounds, pairs, larger, covered, minimal, not_minimal, wide, implicit;
} seen;

static bool has(const uint64_t *set, size_t i)
{
    return set[i / 64] >> (i % 64) & 1;
}

static int size_of(const uint64_t *set, size_t words)
{
    int n = 0;
    for (size_t k = 0; k < words; k++)
        n += __builtin_popcountll(set[k]);
    return n;
}

/* ---- ranks ----------------------------------------------------------------------------------- */

typedef struct matrix {
    mpq_t at[64][DIM];
    int rows, cols;
} matrix;

static void subtract(matrix *m, int i, int from, int c)
{
    mpq_t f, t;
    mpq_inits(f, t, NULL);
    mpq_div(f, m->at[i][c], m->at[from][c]);
    for (int j = 0; j < m->cols; j++) {
        mpq_mul(t, f, m->at[from][j]);
        mpq_sub(m->at[i][j], m->at[i][j], t);
    }
    mpq_clears(f, t, NULL);
}

/* Gauss in rationals, by the book. */
static int rank_of(matrix *m)
{
    int rank = 0;
    for (int c = 0; c < m->cols && rank < m->rows; c++) {
        int p = rank;
        while (p < m->rows && mpq_sgn(m->at[p][c]) == 0)
            p++;
        if (p == m->rows)
            continue;
        for (int j = 0; j < m->cols; j++)
            mpq_swap(m->at[p][j], m->at[rank][j]);
        for (int i = rank + 1; i < m->rows; i++)
            subtract(m, i, rank, c);
        rank++;
    }
    return rank;
}

static bool is_minimal(const fmb_view *w, const uint64_t *history)
{
    matrix m = {.rows = 0};
    mpz_t z;
    mpz_init(z);
    for (size_t b = 0; b < fmb_view_bases(w); b++) {
        if (!has(history, b))
            continue;
        m.cols = 0;
        for (int j = 0; j < fmb_view_dim(w); j++)
            if (has(fmb_view_gone(w), (size_t)j)) {
                fmb_view_base_get(w, b, j, z);
                cr_assert_eq(mpz_sgn(z), fmb_view_base_sign(w, b, j));
                mpq_init(m.at[m.rows][m.cols]);
                mpq_set_z(m.at[m.rows][m.cols++], z);
            }
        m.rows++;
    }
    int rank = rank_of(&m);
    for (int i = 0; i < m.rows; i++)
        for (int j = 0; j < m.cols; j++)
            mpq_clear(m.at[i][j]);
    mpz_clear(z);
    return rank == m.rows - 1;
}

/* ---- a row ----------------------------------------------------------------------------------- */

static void look_at_numbers(const fmb_view *w, size_t row)
{
    const int64_t *v = fmb_view_int64(w, row);
    mpz_t z;
    mpz_init(z);
    for (int j = 0; j <= fmb_view_dim(w); j++) {
        fmb_view_get(w, row, j, z);
        cr_expect_eq(mpz_sgn(z), fmb_view_sign(w, row, j));
        if (v)
            cr_expect_eq(mpz_cmp_si(z, v[j]), 0);
    }
    seen.wide += v == NULL;
    mpz_clear(z);
}

/* Columns that some base row of the history names. */
static uint64_t columns_of(const fmb_view *w, const uint64_t *history)
{
    uint64_t all = 0;
    for (size_t b = 0; b < fmb_view_bases(w); b++)
        for (int j = 0; has(history, b) && j < fmb_view_dim(w); j++)
            all |= (uint64_t)(fmb_view_base_sign(w, b, j) != 0) << j;
    return all;
}

static void look_at_history(const fmb_view *w, size_t row)
{
    size_t words, columns;
    uint64_t implicit, named = 0;
    const uint64_t *history = fmb_view_history(w, row, &words), *gone = fmb_view_gone(w);
    const uint64_t *effective = fmb_view_effective(w, row, &columns);
    cr_assert(history && effective && columns == 1);
    cr_assert_eq(words, (fmb_view_bases(w) + 63) / 64);
    cr_expect_eq(size_of(gone, 1), fmb_view_eliminated(w));
    for (int j = 0; j < fmb_view_dim(w); j++)
        named |= (uint64_t)(fmb_view_sign(w, row, j) != 0) << j;
    cr_expect_eq(*effective & ~*gone, 0, "eliminated, but still there");
    cr_expect_eq(*effective & named, 0);
    fmb_view_implicit(w, row, &implicit);
    cr_expect_eq(implicit, columns_of(w, history) & ~named & ~*effective);
    seen.implicit += implicit != 0;
    bool minimal = fmb_view_minimal(w, row);
    cr_expect_eq(minimal, is_minimal(w, history));
    *(minimal ? &seen.minimal : &seen.not_minimal) += 1;
}

static bool look_at_row(void *state, const fmb_view *w, size_t row)
{
    (void)state;
    seen.rows++;
    cr_expect(fmb_view_column(w) >= 0 && fmb_view_column(w) < fmb_view_dim(w));
    cr_expect_eq(fmb_view_sign(w, row, fmb_view_column(w)), 0);
    cr_expect(fmb_view_lowers(w) == 0 && fmb_view_uppers(w) == 0);
    look_at_numbers(w, row);
    look_at_history(w, row);
    return false;
}

/* ---- pairs ----------------------------------------------------------------------------------- */

static bool is_inside(const uint64_t *a, const uint64_t *b, size_t words)
{
    for (size_t k = 0; k < words; k++)
        if (a[k] & ~b[k])
            return false;
    return true;
}

/* Does the history of a third live row lie inside the union? */
static bool is_covered(const fmb_view *w, size_t i, size_t j, const uint64_t *sum)
{
    size_t words;
    for (size_t k = 0; k < fmb_view_rows(w); k++) {
        size_t row = fmb_view_row(w, k);
        const uint64_t *h = fmb_view_history(w, row, &words);
        if (row != i && row != j && is_inside(h, sum, words))
            return true;
    }
    return false;
}

static void look_at_pair(const fmb_view *w, size_t i, size_t j, bool larger, bool covered)
{
    size_t words, lower = fmb_view_lower(w, i), upper = fmb_view_upper(w, j);
    uint64_t sum[8];
    const uint64_t *a = fmb_view_history(w, lower, &words);
    const uint64_t *b = fmb_view_history(w, upper, &words);
    cr_expect_eq(fmb_view_sign(w, lower, fmb_view_column(w)), -1);
    cr_expect_eq(fmb_view_sign(w, upper, fmb_view_column(w)), 1);
    cr_assert_leq(words, 8);
    for (size_t k = 0; k < words; k++)
        sum[k] = a[k] | b[k];
    cr_expect_eq(larger, size_of(sum, words) > 2);
    cr_expect(covered || !is_covered(w, lower, upper, sum));
    seen.pairs++;
    seen.larger += larger;
    seen.covered += covered;
}

/* Bits that are set stay set. */
static void look_at_pairs(void *state, const fmb_view *w, size_t i, uint64_t *drop)
{
    size_t words = (fmb_view_uppers(w) + 63) / 64;
    uint64_t *set = fmb_view_scratch(w, 2 * words * sizeof *set);
    (void)state;
    cr_assert_not_null(set);
    memset(set, 0, 2 * words * sizeof *set);
    cr_expect_eq(drop[0], 0);
    fmb_view_drop_larger(w, i, 2, set);
    fmb_view_drop_covered(w, i, set + words);
    for (size_t j = 0; j < fmb_view_uppers(w); j++)
        look_at_pair(w, i, j, has(set, j), has(set + words, j));
    memset(set, -1, words * sizeof *set);
    fmb_view_drop_larger(w, i, 1000, set);
    fmb_view_drop_covered(w, i, set);
    cr_expect_eq(set[0], UINT64_MAX);
}

/* ---- rounds ---------------------------------------------------------------------------------- */

static fmb_status look_at_round(void *state, const fmb_view *w, bool *drop)
{
    mpz_t z, g;
    int *rounds = state;
    mpz_inits(z, g, NULL);
    for (size_t i = 0; i < fmb_view_rows(w); i++) {
        size_t row = fmb_view_row(w, i);
        cr_expect(!drop[i]);
        mpz_set_ui(g, 0);
        for (int j = 0; j <= fmb_view_dim(w); j++) {
            fmb_view_get(w, row, j, z);
            mpz_gcd(g, g, z);
        }
        cr_expect_eq(mpz_cmp_ui(g, 1), 0, "a common divisor");
        cr_expect(fmb_view_rel(w, row) == FMB_LE || fmb_view_rel(w, row) == FMB_LT);
    }
    mpz_clears(z, g, NULL);
    *rounds += 1;
    seen.rounds++;
    return FMB_OK;
}

/* State is zero at first, and is told to go. */
static int told_to_go;

static void forget(void *state)
{
    told_to_go++;
    cr_expect_geq(*(int *)state, 0);
}

static const fmb_rule spy = {.name = "spy",
                             .source = "this test",
                             .flags = FMB_RULE_NEEDS_HISTORY,
                             .state_bytes = sizeof(int),
                             .drop_pairs = look_at_pairs,
                             .drop_row = look_at_row,
                             .end_round = look_at_round,
                             .clear = forget};

/* ---- systems --------------------------------------------------------------------------------- */

/* Few numbers, many ties; `huge`: times 2^61 - 1 here and there, so that ranks fall modulo that. */
static fmb_system *make(support_rng *g, bool huge)
{
    int dim = support_between(g, 2, DIM), rows = support_between(g, 3, 9);
    int64_t prime = ((int64_t)1 << PRIME_BITS) - 1;
    fmb_system *s = rows_none(dim);
    for (int i = 0; i < rows; i++) {
        int64_t a[DIM];
        for (int j = 0; j < dim; j++)
            a[j] = support_between(g, -1, 1) * (huge && support_chance(g, 70) ? prime : 1);
        must(fmb_system_add_int(s, a, support_chance(g, 20) ? FMB_LT : FMB_LE,
                                support_between(g, 0, 3)));
    }
    return s;
}

static void look_through(bool huge, fmb_arith arith, int count)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    o.method = FMB_METHOD_FM;
    o.rules = "none";
    o.arith = arith;
    o.max_rows = 100;
    memset(&seen, 0, sizeof seen);
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solver_add_rule(v, &spy));
    for (uint64_t seed = 0; seed < (uint64_t)count; seed++) {
        support_rng g = {seed};
        fmb_system *s = make(&g, huge);
        must(fmb_solve(v, s, &r));
        fmb_system_free(s);
    }
    fmb_solver_free(v);
    cr_expect(seen.rows > 1000 && seen.rounds > 100 && seen.pairs > 1000);
    cr_expect(seen.larger > 100 && seen.covered > 100 && seen.implicit > 100);
    cr_expect(seen.minimal > 100 && seen.not_minimal > 100);
    cr_expect_gt(told_to_go, 0);
}

Test(window, small_rows)
{
    look_through(false, FMB_ARITH_INT, 1500);
    cr_expect_eq(seen.wide, 0);
}

Test(window, wide_rows)
{
    look_through(false, FMB_ARITH_GMP, 600);
    cr_expect_eq(seen.wide, seen.rows);
}

/* Ranks that are less modulo the prime of lib/elim/history/rank.c. */
Test(window, ranks_beside_the_prime)
{
    look_through(true, FMB_ARITH_INT, 1500);
}

/* ---- between rounds, and without histories --------------------------------------------------- */

static int answer_slack[3];

static bool note_row(void *state, const fmb_view *w, size_t row)
{
    size_t words;
    (void)state;
    cr_expect_null(fmb_view_history(w, row, &words), "no rule needs histories");
    cr_expect_null(fmb_view_effective(w, row, &words));
    if (fmb_view_sign(w, row, 0) != 0 && fmb_view_sign(w, row, 1) != 0)
        answer_slack[fmb_view_slack(w, row) + 1]++;
    cr_expect_eq(fmb_view_column(w), -1, "base rows come between rounds");
    cr_expect(fmb_view_variable(w, 0) == 1 && fmb_view_variable(w, 1) == 3);
    return true;
}

/* Variables x2 and x4 of a system of 4; x + y <= 1, 2, 3 over the unit square. */
Test(window, slack_and_variables)
{
    static const fmb_rule rule = {.name = "slack", .drop_row = note_row};
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    fmb_system *s = rows_none(4);
    for (int sign = -1; sign <= 1; sign += 2)
        for (int j = 1; j < 4; j += 2) {
            int64_t a[4] = {0};
            a[j] = sign;
            must(fmb_system_add_int(s, a, FMB_LE, sign > 0));
        }
    for (int64_t b = 1; b <= 3; b++)
        must(fmb_system_add_int(s, (int64_t[]){0, 1, 0, 1}, FMB_LE, b));
    o.method = FMB_METHOD_FM;
    o.rules = "none";
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solver_add_rule(v, &rule));
    must(fmb_solve(v, s, &r));
    for (int sign = 0; sign < 3; sign++)
        cr_expect_eq(answer_slack[sign], 1, "least slack %d: %d times", sign - 1,
                     answer_slack[sign]);
    fmb_solver_free(v);
    fmb_system_free(s);
}

/* A rule that forgot to say that it needs histories finds none, and nothing to drop. */
static void ask_in_vain(void *state, const fmb_view *w, size_t i, uint64_t *drop)
{
    size_t words;
    (void)state;
    cr_expect_null(fmb_view_history(w, fmb_view_lower(w, i), &words));
    fmb_view_drop_larger(w, i, 0, drop);
    fmb_view_drop_covered(w, i, drop);
    cr_expect_eq(drop[0], 0);
    seen.pairs++;
}

static bool ask_row_in_vain(void *state, const fmb_view *w, size_t row)
{
    uint64_t implicit = UINT64_MAX;
    (void)state;
    fmb_view_implicit(w, row, &implicit);
    cr_expect_eq(implicit, 0);
    cr_expect(fmb_view_minimal(w, row));
    cr_expect_eq(fmb_view_slack(w, row), -1, "there is no box");
    if (fmb_view_column(w) < 0)
        cr_expect(fmb_view_bases(w) == 0 && fmb_view_gone(w)[0] == 0);
    seen.rows++;
    return false;
}

Test(window, without_histories)
{
    static const fmb_rule rule = {
        .name = "vain", .drop_pairs = ask_in_vain, .drop_row = ask_row_in_vain};
    memset(&seen, 0, sizeof seen);
    for (uint64_t seed = 0; seed < 50; seed++) {
        support_rng g = {seed};
        fmb_options o = {.size = sizeof o};
        fmb_solver *v = NULL;
        fmb_result r = {.size = sizeof r};
        fmb_system *s = make(&g, false);
        o.method = FMB_METHOD_FM;
        o.rules = "none";
        o.presolve = "none";
        must(fmb_solver_new(&o, NULL, &v));
        must(fmb_solver_add_rule(v, &rule));
        must(fmb_solve(v, s, &r));
        fmb_solver_free(v);
        fmb_system_free(s);
    }
    cr_expect(seen.pairs > 50 && seen.rows > 100);
}
