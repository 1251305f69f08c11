/* certified.c: answers of oracles (lp/oracle) on random programs, and while rows are added, removed
 * and restored: each comes with its proof, which is recomputed from the rows. */
#include <criterion/criterion.h>

#include "lp/oracle/oracle.h"
#include "support.h"
#include "system/system_private.h"

enum { COUNT = 400 / WATCHED };

/* The rows of a system, as a program and as dense rows; all columns. */
typedef struct bench {
    support_case c;
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel;
    fmb_program p;
    size_t n;
    mpq_t *x;
} bench;

static void add_row(bench *b, size_t i)
{
    const fmb_sysrow *r = fmb_system_row(b->c.s, i);
    cr_assert_eq(fmb_program_add(&b->p, r->nnz, r->var, NULL, &r->val, r->rel), FMB_OK);
}

static void open_bench(bench *b, support_family family, uint64_t seed)
{
    fmb_options o = {.size = sizeof o};
    *b = (bench){.c = support_make(family, seed, NULL)};
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    b->n = (size_t)fmb_system_dim(b->c.s);
    fmb_program_init(&b->p, &b->mem, (int)b->n);
    b->x = malloc((b->n + 1) * sizeof *b->x);
    for (size_t j = 0; j < b->n; j++)
        mpq_init(b->x[j]);
}

static void close_bench(bench *b)
{
    for (size_t j = 0; j < b->n; j++)
        mpq_clear(b->x[j]);
    free(b->x);
    fmb_program_clear(&b->p);
    cr_assert_eq(b->mem.used, 0);
    support_case_clear(&b->c);
}

/* ---- proofs ---------------------------------------------------------------------------------- */

/* sum w_i a_i = to[n]; rest = sum w_i b_i. Weights of inequalities that count are not negative;
 * *strict: some row that counts is strict. */
static void combine(const bench *b, const fmb_weights *w, mpq_t *to, mpq_t rest, bool *strict)
{
    mpq_t t;
    mpq_init(t);
    *strict = false;
    for (size_t j = 0; j < b->n; j++)
        mpq_set_ui(to[j], 0, 1);
    mpq_set_ui(rest, 0, 1);
    for (size_t k = 0; k < w->size; k++) {
        const fmb_program_row *r = &b->p.row[w->index[k]];
        cr_assert(!r->off);
        cr_assert(r->rel == FMB_EQ || mpq_sgn(w->value[k]) >= 0);
        *strict |= r->rel == FMB_LT && mpq_sgn(w->value[k]) > 0;
        for (size_t i = 0; i <= r->size; i++) {
            fmb_vec_get_q(r->value, i, t);
            mpq_mul(t, t, w->value[k]);
            if (i < r->size)
                mpq_add(to[r->column[i]], to[r->column[i]], t);
            else
                mpq_add(rest, rest, t);
        }
    }
    mpq_clear(t);
}

static void expect_conflict(bench *b, fmb_oracle *o)
{
    fmb_weights w = {0};
    bool strict;
    mpq_t rest;
    mpq_init(rest);
    cr_assert_eq(fmb_oracle_conflict(o, &w), FMB_OK);
    combine(b, &w, b->x, rest, &strict);
    for (size_t j = 0; j < b->n; j++)
        cr_assert_eq(mpq_sgn(b->x[j]), 0);
    cr_assert(mpq_sgn(rest) < 0 || (mpq_sgn(rest) == 0 && strict));
    fmb_weights_clear(&w, &b->mem);
    mpq_clear(rest);
}

/* Sign of b_i - a_i.x. */
static int slack(const fmb_program *p, size_t i, mpq_t *x, bool right)
{
    const fmb_program_row *r = &p->row[i];
    mpq_t s, t;
    mpq_inits(s, t, NULL);
    if (right)
        fmb_vec_get_q(r->value, r->size, s);
    for (size_t k = 0; k < r->size; k++) {
        fmb_vec_get_q(r->value, k, t);
        mpq_mul(t, t, x[r->column[k]]);
        mpq_sub(s, s, t);
    }
    int sign = mpq_sgn(s);
    mpq_clears(s, t, NULL);
    return sign;
}

static void expect_solution(bench *b, const fmb_oracle *o, bool closure)
{
    cr_assert_eq(fmb_oracle_point(o, b->x), FMB_OK);
    for (size_t i = 0; i < b->p.m; i++) {
        fmb_rel rel = b->p.row[i].rel;
        int s = slack(&b->p, i, b->x, true);
        if (!b->p.row[i].off)
            cr_assert(rel == FMB_EQ ? s == 0 : rel == FMB_LT && !closure ? s > 0 : s >= 0);
    }
}

/* ---- questions ------------------------------------------------------------------------------- */

/* The point reaches what the multipliers prove to be the most. */
static void expect_optimum(bench *b, fmb_oracle *o, int j, int sign, bool attained)
{
    fmb_weights w = {0};
    bool strict;
    mpq_t value, mine;
    mpq_inits(value, mine, NULL);
    cr_assert_eq(fmb_oracle_value(o, value), FMB_OK);
    if (sign < 0)
        mpq_neg(value, value);
    expect_solution(b, o, !attained);
    cr_assert(mpq_equal(b->x[j], value));
    cr_assert_eq(fmb_oracle_multipliers(o, &w), FMB_OK);
    combine(b, &w, b->x, mine, &strict);
    for (size_t k = 0; k < b->n; k++)
        cr_assert_eq(mpq_cmp_si(b->x[k], k == (size_t)j ? sign : 0, 1), 0);
    if (sign < 0)
        mpq_neg(mine, mine);
    cr_assert(mpq_equal(value, mine));
    cr_assert(attained || strict);
    fmb_weights_clear(&w, &b->mem);
    mpq_clears(value, mine, NULL);
}

static void expect_ray(bench *b, const fmb_oracle *o, int j, int sign)
{
    cr_assert_eq(fmb_oracle_ray(o, b->x), FMB_OK);
    cr_assert(mpq_sgn(b->x[j]) == sign);
    for (size_t i = 0; i < b->p.m; i++) {
        int s = slack(&b->p, i, b->x, false);
        cr_assert(b->p.row[i].off || (b->p.row[i].rel == FMB_EQ ? s == 0 : s >= 0));
    }
}

/* The same in steps: what is seen first is some point of the closure. */
static void maximize_in_steps(bench *b, fmb_oracle *o, const fmb_weights *cost, fmb_oracle_end *end,
                              bool *attained)
{
    *attained = false;
    cr_assert_eq(fmb_oracle_approach(o, cost, end), FMB_OK);
    if (*end == FMB_ORACLE_UNBOUNDED)
        return;
    expect_solution(b, o, true);
    cr_assert_eq(fmb_oracle_climb(o, end), FMB_OK);
    if (*end == FMB_ORACLE_OPTIMUM)
        cr_assert_eq(fmb_oracle_attain(o, attained), FMB_OK);
}

static void ask_end(bench *b, fmb_oracle *o, int j, int sign, bool in_steps)
{
    fmb_weights cost = {0};
    fmb_oracle_end end;
    bool attained;
    mpq_t one;
    mpq_init(one);
    mpq_set_si(one, sign, 1);
    cr_assert_eq(fmb_weights_add(&cost, (uint32_t)j, one, &b->mem), FMB_OK);
    if (in_steps)
        maximize_in_steps(b, o, &cost, &end, &attained);
    else
        cr_assert_eq(fmb_oracle_maximize(o, &cost, &end, &attained), FMB_OK);
    if (end == FMB_ORACLE_UNBOUNDED)
        expect_ray(b, o, j, sign);
    else
        expect_optimum(b, o, j, sign, attained);
    fmb_weights_clear(&cost, &b->mem);
    mpq_clear(one);
}

/* To the last column, or away from it. */
static void lean(bench *b, fmb_oracle *o)
{
    fmb_weights cost = {0};
    mpq_t one;
    mpq_init(one);
    mpq_set_si(one, b->p.m % 4 == 1 ? 1 : -1, 1);
    cr_assert_eq(fmb_weights_add(&cost, (uint32_t)b->n - 1, one, &b->mem), FMB_OK);
    cr_assert_eq(fmb_oracle_lean(o, &cost), FMB_OK);
    fmb_weights_clear(&cost, &b->mem);
    mpq_clear(one);
}

/* Every other program is leaned on before. */
static void ask_everything(bench *b, fmb_oracle *o)
{
    bool feasible;
    if (b->p.m % 2 == 1)
        lean(b, o);
    cr_assert_eq(fmb_oracle_feasible(o, &feasible), FMB_OK);
    if (!feasible)
        expect_conflict(b, o);
    else
        expect_solution(b, o, false);
    for (int j = 0; feasible && j < (int)b->n; j++)
        for (int k = 0; k < 4; k++)
            ask_end(b, o, j, k % 2 ? 1 : -1, k / 2 == j % 2);
}

Test(certified, random_programs)
{
    for (int family = 0; family < SUPPORT_FAMILIES; family++)
        for (uint64_t seed = 0; seed < COUNT; seed++) {
            bench b;
            fmb_oracle *o;
            open_bench(&b, (support_family)family, seed);
            for (size_t i = 0; i < fmb_system_rows(b.c.s); i++)
                add_row(&b, i);
            cr_assert_eq(fmb_oracle_new(&b.run, &b.p, &o), FMB_OK);
            ask_everything(&b, o);
            fmb_oracle_free(o);
            close_bench(&b);
        }
}

/* Row i times 2^1100 + 1: numbers that are longer than doubles have exponents for. */
static void add_long_row(bench *b, size_t i)
{
    const fmb_sysrow *r = fmb_system_row(b->c.s, i);
    mpz_t *z = fmb_vec_block(b->n + 1, &b->mem), t;
    mpz_init(t);
    for (size_t k = 0; k <= r->nnz; k++) {
        mpz_ptr at = z[k < r->nnz ? (size_t)r->var[k] : b->n];
        fmb_vec_get(&r->val, k, at);
        mpz_mul_2exp(t, at, 1100);
        mpz_add(at, at, t);
    }
    cr_assert_eq(fmb_program_add_integers(&b->p, z, r->rel), FMB_OK);
    mpz_clear(t);
    fmb_vec_block_free(z, b->n + 1, &b->mem);
}

/* Exact pivots that all questions about some programs of the family take. */
static uint64_t count_pivots(support_family family, void (*add)(bench *, size_t))
{
    uint64_t pivots = 0;
    for (uint64_t seed = 0; seed < COUNT / 4; seed++) {
        bench b;
        fmb_oracle *o;
        open_bench(&b, family, seed + 2000);
        for (size_t i = 0; i < fmb_system_rows(b.c.s); i++)
            add(&b, i);
        cr_assert_eq(fmb_oracle_new(&b.run, &b.p, &o), FMB_OK);
        ask_everything(&b, o);
        pivots += b.run.stats.pivots;
        fmb_oracle_free(o);
        close_bench(&b);
    }
    return pivots;
}

/* Doubles guess as well about numbers that are too long for them. */
Test(certified, long_rows)
{
    uint64_t few = 0, more = 0;
    for (int family = 0; family < SUPPORT_FAMILIES; family++) {
        few += count_pivots((support_family)family, add_row);
        more += count_pivots((support_family)family, add_long_row);
    }
    cr_assert_leq(more, few + few / 2);
}

/* Half of the rows, then the others one by one, while rows come and go at random. */
Test(certified, while_rows_change)
{
    for (int family = 0; family < SUPPORT_FAMILIES; family++)
        for (uint64_t seed = 0; seed < COUNT / 4; seed++) {
            bench b;
            fmb_oracle *o;
            support_rng g = {seed};
            open_bench(&b, (support_family)family, seed + 1000);
            size_t rows = fmb_system_rows(b.c.s), i = 0;
            for (; i < rows / 2; i++)
                add_row(&b, i);
            cr_assert_eq(fmb_oracle_new(&b.run, &b.p, &o), FMB_OK);
            ask_everything(&b, o);
            for (; i < rows; i++) {
                add_row(&b, i);
                cr_assert_eq(fmb_oracle_grow(o), FMB_OK);
                size_t k = (size_t)support_between(&g, 0, (int)i);
                b.p.row[k].off = !b.p.row[k].off;
                fmb_oracle_switch(o, k, !b.p.row[k].off);
                ask_everything(&b, o);
            }
            fmb_oracle_free(o);
            close_bench(&b);
        }
}

/* Multipliers over powers of 2, of which 1/2^30 once looked like an integer: it is one that is
 * short, modulo some powers of the prime. */
Test(certified, chain)
{
    bench b;
    fmb_oracle *o;
    fmb_oracle_end end;
    bool attained, feasible, strict;
    fmb_weights cost = {0}, w = {0};
    enum { N = 300 };
    int64_t coef[2][2] = {{-1, 2}, {1, -1}};
    fmb_system *s = NULL;
    mpq_t one, value;
    mpq_inits(one, value, NULL);
    mpq_set_ui(one, 1, 1);
    b = (bench){.c.s = NULL};
    cr_assert_eq(fmb_system_new(N, NULL, &s), FMB_OK);
    for (int j = 0; j < N; j++)
        for (int k = 0; k < 2; k++) {
            int64_t row[N] = {0};
            row[j] = coef[k][0];
            if (j + 1 < N)
                row[j + 1] = coef[k][1];
            cr_assert_eq(fmb_system_add_int(s, row, FMB_LE, 1), FMB_OK);
        }
    fmb_options options = {.size = sizeof options};
    fmb_mem_init(&b.mem, NULL, 0);
    fmb_run_begin(&b.run, &b.mem, &options, &b.cancel, (fmb_sink){0}, "test");
    b.c.s = s;
    b.n = N;
    b.x = malloc(N * sizeof *b.x);
    for (size_t j = 0; j < N; j++)
        mpq_init(b.x[j]);
    fmb_program_init(&b.p, &b.mem, N);
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        add_row(&b, i);
    cr_assert_eq(fmb_oracle_new(&b.run, &b.p, &o), FMB_OK);
    cr_assert_eq(fmb_oracle_feasible(o, &feasible), FMB_OK);
    cr_assert(feasible);
    for (uint32_t j = 0; j < N; j += 13) {
        cr_assert_eq(fmb_weights_add(&cost, j, one, &b.mem), FMB_OK);
        cr_assert_eq(fmb_oracle_maximize(o, &cost, &end, &attained), FMB_OK);
        cr_assert_eq(end, FMB_ORACLE_OPTIMUM);
        cr_assert_eq(fmb_oracle_multipliers(o, &w), FMB_OK);
        combine(&b, &w, b.x, value, &strict);
        for (uint32_t k = 0; k < N; k++)
            cr_assert_eq(mpq_cmp_si(b.x[k], k == j, 1), 0);
        fmb_weights_clear(&w, &b.mem);
        fmb_weights_clear(&cost, &b.mem);
    }
    fmb_oracle_free(o);
    mpq_clears(one, value, NULL);
    close_bench(&b);
}
