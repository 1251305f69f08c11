/* irredundant.c: redundant rows by linear programs: each proof is recomputed from the rows, and
 * each kept row is violated by a point that satisfies all others. */
#include <criterion/criterion.h>

#include <stdlib.h>
#include <string.h>

#include "bareiss.h"
#include "claims.h"
#include "study/textbook/exact.h"
#include "support/dense.h"
#include "support/must.h"

typedef struct tally {
    size_t redundant, kept, equality, strict;
} tally;

/* Equalities that stay do not depend on one another. */
static void expect_independent_equalities(const scene *c, const fmb_fate *fate, uint64_t seed)
{
    size_t size = c->m > c->n ? c->m : c->n, rows = 0;
    mpz_t *a = bareiss_numbers(size * size);
    for (size_t i = 0; i < c->m; i++) {
        if (c->rel[i] != FMB_EQ || fate[i] == FMB_FATE_REDUNDANT)
            continue;
        for (size_t j = 0; j < c->n; j++)
            fmb_vec_get(c->row[i].v, j, a[rows * size + j]);
        rows++;
    }
    cr_assert_eq(bareiss_rank(a, size), rows, "seed %lu", (unsigned long)seed);
    bareiss_free(a, size * size);
}

/* No inequality that stays is always tight: some solution of the system is not on it. */
static void expect_slack_inequalities(const scene *c, const fmb_system *s, const fmb_fate *fate,
                                      uint64_t seed)
{
    dense d = dense_of(s);
    for (size_t i = 0; i < c->m; i++) {
        fmb_verdict truth;
        if (c->rel[i] != FMB_LE || fate[i] != FMB_FATE_KEPT)
            continue;
        d.rel[i] = FMB_LT;
        fmb_system *open = dense_system(&d);
        d.rel[i] = FMB_LE;
        must(study_textbook_solve(open, 20000, &truth));
        cr_assert_neq(truth, FMB_INFEASIBLE, "seed %lu, row %zu", (unsigned long)seed, i);
        fmb_system_free(open);
    }
    dense_free(&d);
}

static void count_fates(const scene *c, const fmb_fate *fate, const scene_listener *l, tally *t)
{
    for (size_t i = 0; i < c->m; i++) {
        cr_assert_neq(fate[i], FMB_FATE_UNKNOWN);
        cr_assert_eq(l->gone[i], fate[i] == FMB_FATE_REDUNDANT);
        t->redundant += fate[i] == FMB_FATE_REDUNDANT;
        t->kept += fate[i] == FMB_FATE_KEPT;
        t->equality += fate[i] == FMB_FATE_EQUALITY;
        t->strict += c->rel[i] == FMB_LT;
    }
}

static void sort_rows(const support_case *s, bool small, tally *t)
{
    scene c;
    bool open = scene_open(&c, s->s), feasible = false;
    fmb_verdict truth = FMB_UNKNOWN;
    fmb_fate *fate = calloc(c.m + 1, sizeof *fate);
    bool *gone = calloc(c.m + 1, sizeof *gone);
    scene_listener l = {&c, gone, 0};
    fmb_verdicts told = {scene_hear_redundant, scene_hear_equality, scene_hear_irredundant, &l};
    if (open)
        must(fmb_irredundant(&c.run, c.n, c.m, c.row, fate, &told, &feasible));
    small = small && c.m == fmb_system_rows(s->s); /* no constant rows */
    if (open && small)
        must(study_textbook_solve(s->s, 20000, &truth));
    cr_assert(truth == FMB_UNKNOWN || feasible == (truth == FMB_FEASIBLE));
    if (feasible) {
        count_fates(&c, fate, &l, t);
        expect_independent_equalities(&c, fate, s->seed);
    }
    if (feasible && small)
        expect_slack_inequalities(&c, s->s, fate, s->seed);
    scene_close(&c);
    free(fate);
    free(gone);
}

Test(irredundant, small_systems_of_all_families)
{
    tally t = {0};
    for (uint64_t seed = 0; seed < 150; seed++)
        for (support_family family = 0; family < SUPPORT_FAMILIES; family++) {
            support_case c = support_make(family, seed, NULL);
            sort_rows(&c, true, &t);
            support_case_clear(&c);
        }
    cr_expect_gt(t.strict, 100);
    cr_expect_gt(t.redundant, 300);
    cr_expect_gt(t.kept, 800);
    cr_expect_gt(t.equality, 30);
}

Test(irredundant, systems_of_ten_variables)
{
    tally t = {0};
    for (uint64_t seed = 0; seed < 20; seed++)
        for (support_family family = 0; family < SUPPORT_FAMILIES; family++) {
            support_shape shape = {.dim = 10, .rows = 24, .bits = seed % 4 == 0 ? 63 : 0};
            support_case c = support_make(family, seed, &shape);
            sort_rows(&c, false, &t);
            support_case_clear(&c);
        }
    cr_expect_gt(t.redundant, 50);
    cr_expect_gt(t.kept, 200);
}

/* Numbers that are longer than exponents of doubles reach, too. */
Test(irredundant, systems_of_long_numbers)
{
    tally t = {0};
    for (uint64_t seed = 0; seed < 6; seed++)
        for (support_family family = 0; family < SUPPORT_FAMILIES; family++) {
            support_shape shape = {
                .dim = 2 + (int)seed % 3, .rows = 14, .bits = seed % 2 == 0 ? 300 : 1300};
            support_case c = support_make(family, seed, &shape);
            sort_rows(&c, false, &t);
            support_case_clear(&c);
        }
    cr_expect_gt(t.redundant, 20);
    cr_expect_gt(t.kept, 20);
}

/* Less and less memory: a limit each time, and nothing is left behind. */
Test(irredundant, limits_on_memory_leave_nothing_behind)
{
    support_shape shape = {.dim = 6, .rows = 14, .bits = 0};
    support_case c = support_make(SUPPORT_PLANTED_POINT, 5, &shape);
    scene s;
    cr_assert(scene_open(&s, c.s));
    fmb_fate fate[14] = {0};
    bool feasible;
    size_t used = s.mem.used;
    must(fmb_irredundant(&s.run, s.n, s.m, s.row, fate, NULL, &feasible));
    size_t peak = s.mem.peak;
    for (size_t part = 1; part < 40; part++) {
        for (size_t i = 0; i < s.m; i++)
            fate[i] = FMB_FATE_UNKNOWN;
        s.mem.limit = used + (peak - used) * part / 40;
        cr_assert_eq(fmb_irredundant(&s.run, s.n, s.m, s.row, fate, NULL, &feasible), FMB_LIMIT);
        cr_assert_eq(s.mem.used, used);
    }
    s.mem.limit = 0;
    scene_close(&s);
    support_case_clear(&c);
}
