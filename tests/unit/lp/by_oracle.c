/* by_oracle.c: rows that go, by linear programs that are guessed, against passes over an exact
 * dictionary; each proof is formed again from the rows. */
#include <criterion/criterion.h>

#include <stdlib.h>

#include "claims.h"
#include "lp/dictionary/exact_simplex.h"
#include "lp/redundancy/by_oracle.h"
#include "support/dense.h"
#include "support/must.h"

typedef struct tally {
    size_t redundant, kept, equality;
} tally;

/* Strict rows are taken for others here. */
static void close_strict_rows(scene *c)
{
    for (size_t i = 0; i < c->m; i++) {
        c->rel[i] = c->rel[i] == FMB_LT ? FMB_LE : c->rel[i];
        c->row[i].rel = c->rel[i];
    }
}

/* False: infeasible. */
static bool ask_dictionary(scene *c, fmb_fate *fate)
{
    fmb_lp lp;
    bool feasible = false;
    must(fmb_lp_init(&lp, &c->run, (int)c->n, c->m, c->row, false));
    must(fmb_lp_feasible(&lp, &feasible));
    if (feasible)
        must(fmb_irredundant(&lp, c->rel, fate, NULL));
    fmb_lp_clear(&lp);
    return feasible;
}

static void compare_fates(const scene *c, const fmb_fate *fate, const fmb_fate *truth,
                          uint64_t seed, tally *t)
{
    for (size_t i = 0; i < c->m; i++) {
        cr_assert_eq(fate[i], truth[i], "seed %lu, row %zu: %d, not %d", (unsigned long)seed, i,
                     fate[i], truth[i]);
        t->redundant += fate[i] == FMB_FATE_REDUNDANT;
        t->kept += fate[i] == FMB_FATE_KEPT;
        t->equality += fate[i] == FMB_FATE_EQUALITY;
    }
}

static void sort_both_ways(const support_case *s, tally *t)
{
    scene c;
    bool open = scene_open(&c, s->s);
    fmb_fate *fate = calloc(c.m + 1, sizeof *fate), *truth = calloc(c.m + 1, sizeof *truth);
    bool *gone = calloc(c.m + 1, sizeof *gone);
    scene_listener l = {&c, gone, 0};
    fmb_verdicts told = {scene_hear_redundant, scene_hear_equality, scene_hear_irredundant, &l};
    if (open)
        close_strict_rows(&c);
    if (open && ask_dictionary(&c, truth)) {
        must(fmb_irredundant_by_oracle(&c.run, c.n, c.m, c.row, fate, &told));
        compare_fates(&c, fate, truth, s->seed, t);
    }
    scene_close(&c);
    free(fate);
    free(truth);
    free(gone);
}

Test(by_oracle, small_systems_of_all_families)
{
    tally t = {0};
    for (uint64_t seed = 0; seed < 150; seed++)
        for (support_family family = 0; family < SUPPORT_FAMILIES; family++) {
            support_case c = support_make(family, seed, NULL);
            sort_both_ways(&c, &t);
            support_case_clear(&c);
        }
    cr_expect_gt(t.redundant, 300);
    cr_expect_gt(t.kept, 800);
    cr_expect_gt(t.equality, 30);
}

Test(by_oracle, systems_of_ten_variables)
{
    tally t = {0};
    for (uint64_t seed = 0; seed < 20; seed++)
        for (support_family family = 0; family < SUPPORT_FAMILIES; family++) {
            support_shape shape = {.dim = 10, .rows = 24, .bits = seed % 4 == 0 ? 63 : 0};
            support_case c = support_make(family, seed, &shape);
            sort_both_ways(&c, &t);
            support_case_clear(&c);
        }
    cr_expect_gt(t.redundant, 50);
    cr_expect_gt(t.kept, 200);
}

/* Less and less memory: a limit each time, and nothing is left behind. */
Test(by_oracle, limits_on_memory_leave_nothing_behind)
{
    support_shape shape = {.dim = 6, .rows = 14, .bits = 0};
    support_case c = support_make(SUPPORT_PLANTED_POINT, 5, &shape);
    scene s;
    cr_assert(scene_open(&s, c.s));
    close_strict_rows(&s);
    fmb_fate fate[14] = {0};
    size_t used = s.mem.used;
    must(fmb_irredundant_by_oracle(&s.run, s.n, s.m, s.row, fate, NULL));
    size_t peak = s.mem.peak;
    for (size_t part = 1; part < 40; part++) {
        for (size_t i = 0; i < s.m; i++)
            fate[i] = FMB_FATE_UNKNOWN;
        s.mem.limit = used + (peak - used) * part / 40;
        cr_assert_eq(fmb_irredundant_by_oracle(&s.run, s.n, s.m, s.row, fate, NULL), FMB_LIMIT);
        cr_assert_eq(s.mem.used, used);
    }
    s.mem.limit = 0;
    scene_close(&s);
    support_case_clear(&c);
}
