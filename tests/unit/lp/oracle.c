/* oracle.c: the simplex oracle against the ground truth, and its certificates against the rows. */
#include <criterion/criterion.h>

#include <stdlib.h>

#include "lp/dictionary/dictionary_read.h"
#include "lp/dictionary/exact_simplex.h"
#include "lp/redundancy/active_test.h"
#include "solve/query/part.h"
#include "study/textbook/exact.h"
#include "support.h"

/* A random connected system and its oracle. */
typedef struct bench {
    support_case c;
    fmb_mem mem;
    fmb_arena arena;
    fmb_run run;
    atomic_int cancel;
    fmb_parts parts;
    fmb_lp lp;
    const fmb_part *p; /* the first part, or NULL */
} bench;

static void open_bench(bench *b, support_family family, uint64_t seed)
{
    fmb_options o = {.size = sizeof o};
    *b = (bench){.c = support_make(family, seed, NULL)};
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_arena_init(&b->arena, &b->mem);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    cr_assert_eq(fmb_parts_split(&b->parts, b->c.s, &b->run, &b->arena, true), FMB_OK);
    if (b->parts.count == 0)
        return;
    b->p = &b->parts.part[0];
    cr_assert_eq(fmb_part_load(&b->parts.part[0], b->c.s, b->parts.place, &b->run, false), FMB_OK);
    fmb_lp_row *rows = fmb_arena_get(&b->arena, b->p->m, sizeof *rows);
    for (size_t i = 0; i < b->p->m; i++)
        rows[i] = (fmb_lp_row){&b->p->row[i], b->p->rel[i]};
    cr_assert_eq(fmb_lp_init(&b->lp, &b->run, b->p->n, b->p->m, rows, seed % 4 == 0), FMB_OK);
}

static void close_bench(bench *b)
{
    if (b->p)
        fmb_lp_clear(&b->lp);
    fmb_parts_clear(&b->parts, &b->mem);
    fmb_arena_clear(&b->arena);
    cr_assert_eq(b->mem.used, 0);
    support_case_clear(&b->c);
}

/* The part as a system of its own. */
static fmb_system *as_system(const fmb_part *p)
{
    fmb_system *s;
    mpq_t *q = malloc(((size_t)p->n + 1) * sizeof *q);
    int *var = malloc((size_t)p->n * sizeof *var);
    cr_assert_eq(fmb_system_new(p->n, NULL, &s), FMB_OK);
    for (int j = 0; j <= p->n; j++)
        mpq_init(q[j]);
    for (size_t i = 0; i < p->m; i++) {
        for (int j = 0; j <= p->n; j++)
            fmb_vec_get(&p->row[i], (size_t)j, mpq_numref(q[j]));
        for (int j = 0; j < p->n; j++)
            var[j] = j;
        cr_assert_eq(fmb_system_add_q(s, (size_t)p->n, var, q, p->rel[i], q[p->n]), FMB_OK);
    }
    for (int j = 0; j <= p->n; j++)
        mpq_clear(q[j]);
    free(q);
    free(var);
    return s;
}

/* Compare both ends of every variable with the truth. */
static void check_ends(bench *b, const fmb_system *s)
{
    study_textbook_end truth[2];
    fmb_verdict verdict;
    fmb_lp_end end;
    mpq_t value;
    int step;
    mpq_inits(truth[0].value, truth[1].value, value, NULL);
    for (int j = 0; j < b->p->n; j++) {
        cr_assert_eq(study_textbook_bound(s, j, 20000, truth, &verdict), FMB_OK);
        for (int side = 0; verdict == FMB_FEASIBLE && side < 2; side++) {
            cr_assert_eq(fmb_lp_extreme(&b->lp, j, side ? 1 : -1, &end), FMB_OK);
            cr_assert_eq(end == FMB_LP_OPTIMUM, truth[side].kind == FMB_END_FINITE);
            if (end != FMB_LP_OPTIMUM)
                continue;
            fmb_lp_value(&b->lp, value, &step);
            cr_assert(mpq_equal(value, truth[side].value), "seed %lu", (unsigned long)b->c.seed);
            cr_assert_eq(step == 0, truth[side].attained);
        }
    }
    mpq_clears(truth[0].value, truth[1].value, value, NULL);
}

/* Test row i, with the others asleep or awake. A violation must satisfy every row still there but
 * i. */
static fmb_lp_end test_row(bench *b, size_t i, const bool *gone, bool lazily)
{
    double center[16] = {0};
    fmb_lp_end end;
    mpq_t x[16], sum, t;
    for (int j = 0; j < 16; j++)
        mpq_init(x[j]);
    mpq_inits(sum, t, NULL);
    if (lazily)
        cr_assert_eq(fmb_lp_test_active(&b->lp, i, center, x, &end), FMB_OK);
    else
        cr_assert_eq(fmb_lp_test(&b->lp, i, &end), FMB_OK);
    if (end == FMB_LP_VIOLATED && !lazily)
        cr_assert_eq(fmb_lp_violation(&b->lp, x), FMB_OK);
    for (size_t r = 0; end == FMB_LP_VIOLATED && r < b->p->m; r++) {
        mpq_set_ui(sum, 0, 1);
        for (size_t j = 0; j < (size_t)b->p->n; j++) {
            fmb_vec_get(&b->p->row[r], j, mpq_numref(t));
            mpz_set_ui(mpq_denref(t), 1);
            mpq_mul(t, t, x[j]);
            mpq_add(sum, sum, t);
        }
        fmb_vec_get(&b->p->row[r], (size_t)b->p->n, mpq_numref(t));
        mpz_set_ui(mpq_denref(t), 1);
        int side = mpq_cmp(sum, t);
        fmb_rel rel = b->p->rel[r];
        bool holds = rel == FMB_EQ ? side == 0 : rel == FMB_LT ? side < 0 : side <= 0;
        if (!gone[r] && r != i)
            cr_assert(holds, "row %zu, testing %zu, seed %lu", r, i, (unsigned long)b->c.seed);
        if (r == i)
            cr_assert_not(holds);
    }
    for (int j = 0; j < 16; j++)
        mpq_clear(x[j]);
    mpq_clears(sum, t, NULL);
    return end;
}

/* Row i is redundant iff the others and its negation have no solution; on the rows still there. */
static void check_tests(bench *b)
{
    bool *gone = calloc(b->p->m, sizeof *gone), lazily = b->c.seed % 2;
    if (lazily)
        fmb_lp_deactivate(&b->lp);
    for (size_t i = 0; i < b->p->m; i++) {
        fmb_lp_end end;
        fmb_verdict truth;
        if (b->p->rel[i] == FMB_EQ)
            continue;
        fmb_part negated = *b->p;
        fmb_system *s = as_system(&negated), *t;
        cr_assert_eq(fmb_system_new(b->p->n, NULL, &t), FMB_OK);
        mpq_t q[16], rhs;
        int var[16];
        mpq_init(rhs);
        for (int k = 0; k < 16; k++)
            mpq_init(q[k]);
        for (size_t r = 0; r < b->p->m; r++) {
            if (gone[r])
                continue;
            size_t terms = fmb_system_terms(s, r);
            for (size_t k = 0; k < terms; k++) {
                var[k] = fmb_system_term_q(s, r, k, q[k]);
                if (r == i)
                    mpq_neg(q[k], q[k]);
            }
            fmb_system_rhs_q(s, r, rhs);
            fmb_rel rel = b->p->rel[r];
            if (r == i) {
                mpq_neg(rhs, rhs);
                rel = rel == FMB_LT ? FMB_LE : FMB_LT;
            }
            cr_assert_eq(fmb_system_add_q(t, terms, var, q, rel, rhs), FMB_OK);
        }
        cr_assert_eq(study_textbook_solve(t, 20000, &truth), FMB_OK);
        end = test_row(b, i, gone, lazily);
        if (truth != FMB_UNKNOWN)
            cr_assert_eq(end == FMB_LP_OPTIMUM, truth == FMB_INFEASIBLE, "row %zu of seed %lu", i,
                         (unsigned long)b->c.seed);
        gone[i] = end == FMB_LP_OPTIMUM;
        if (!gone[i])
            cr_assert_eq(fmb_lp_restore(&b->lp), FMB_OK);
        for (int k = 0; k < 16; k++)
            mpq_clear(q[k]);
        mpq_clear(rhs);
        fmb_system_free(s);
        fmb_system_free(t);
    }
    free(gone);
}

Test(lp, verdicts_ends_and_redundancy_are_the_truth)
{
    for (uint64_t seed = 0; seed < 1500; seed++) {
        bench b;
        fmb_verdict truth;
        bool feasible;
        open_bench(&b, (support_family)(seed % SUPPORT_FAMILIES), seed);
        if (b.p) {
            fmb_system *s = as_system(b.p);
            cr_assert_eq(study_textbook_solve(s, 20000, &truth), FMB_OK);
            cr_assert_eq(fmb_lp_feasible(&b.lp, &feasible), FMB_OK);
            if (truth != FMB_UNKNOWN)
                cr_assert_eq(feasible, truth == FMB_FEASIBLE, "seed %lu", (unsigned long)seed);
            if (feasible) {
                check_ends(&b, s);
                check_tests(&b);
            }
            fmb_system_free(s);
        }
        close_bench(&b);
    }
}
