/* substituted_rows.c: redundant rows among equalities, found after the equalities are substituted:
 * the oracle agrees on all of them. */
#include <criterion/criterion.h>
#include <string.h>

#include "lp/redundancy/irredundant.h"
#include "solve/prepare/substituted_rows.h"
#include "support.h"

enum { COLUMNS = 6, ROWS = 16, TRIALS = 3000 };

typedef struct drawn {
    size_t n, m;
    int64_t words[ROWS][COLUMNS + 1];
    fmb_vec v[ROWS];
    fmb_lp_row row[ROWS];
} drawn;

/* What was met; each is to be. */
static int insides, outsides, empties, dependents, longs, tights, roomless;

/* Rows that hold at a point, or, if `any`, perhaps at none; equalities may be sums of others, and
 * all rows multiples. */
static void draw_rows(drawn *d, support_rng *g, bool any)
{
    int64_t z[COLUMNS];
    d->n = (size_t)support_between(g, 1, COLUMNS);
    d->m = (size_t)support_between(g, 1, ROWS);
    for (size_t j = 0; j < d->n; j++)
        z[j] = support_between(g, -3, 3);
    for (size_t i = 0; i < d->m; i++) {
        int64_t *w = d->words[i], times = support_chance(g, 3) ? (int64_t)1 << 40 : 1;
        const fmb_rel rel = support_chance(g, 30)   ? FMB_EQ
                            : support_chance(g, 15) ? FMB_LT
                                                    : FMB_LE;
        bool turned = i > 0 && support_chance(g, 10); /* the one before, backwards */
        bool sum = i > 1 && rel == FMB_EQ && support_chance(g, 40);
        int64_t value = 0;
        for (size_t j = 0; j < d->n; j++) {
            w[j] = support_chance(g, 50) ? support_between(g, -4, 4) : 0;
            if (sum)
                w[j] = d->words[i - 1][j] % 100 + d->words[i - 2][j] % 100;
            else if (turned)
                w[j] = -(d->words[i - 1][j] % 100);
            value += w[j] * z[j];
        }
        int64_t slack =
            rel == FMB_EQ || (turned && rel == FMB_LE) ? 0 : support_between(g, rel == FMB_LT, 6);
        w[d->n] = any && support_chance(g, 20) ? support_between(g, -3, 3) : value + slack;
        for (size_t j = 0; j <= d->n; j++)
            w[j] *= times;
        d->v[i] = (fmb_vec){.s = w};
        fmb_vec_measure(&d->v[i], d->n + 1);
        d->row[i] = (fmb_lp_row){&d->v[i], rel};
    }
}

/* Nothing satisfies all rows, and row i strictly. */
static void expect_tight(fmb_run *run, const drawn *d, size_t i)
{
    fmb_lp_row row[ROWS];
    fmb_fate fate[ROWS] = {FMB_FATE_UNKNOWN};
    bool feasible;
    memcpy(row, d->row, sizeof row);
    row[i].rel = FMB_LT;
    cr_assert_eq(fmb_redundant(run, d->n, d->m, row, NULL, fate, &feasible), FMB_OK);
    cr_assert(!feasible);
    tights++;
}

/* As in lp/sorting.c: rows not gone imply those that are, and those kept are needed. */
static void expect_truth(fmb_run *run, const drawn *d, const fmb_sorting *found, const bool *tight)
{
    fmb_lp_row row[ROWS];
    fmb_fate fate[ROWS];
    size_t m = 0, place[ROWS];
    bool feasible, flat = false;
    for (int gone = 0; gone <= 1; gone++)
        for (size_t i = 0; i < d->m; i++)
            if (found->gone[i] == (gone == 1)) {
                place[m] = i;
                fate[m] = FMB_FATE_UNKNOWN;
                bool equal = found->feasible && tight[i];
                row[m++] = (fmb_lp_row){d->row[i].v, equal ? FMB_EQ : d->row[i].rel};
            }
    for (size_t i = 0; found->feasible && i < d->m; i++)
        if (tight[i])
            expect_tight(run, d, i);
    cr_assert_eq(fmb_redundant(run, d->n, m, row, NULL, fate, &feasible), FMB_OK);
    cr_assert_eq(feasible, found->feasible);
    for (size_t k = 0; feasible && k < m; k++) {
        cr_assert(!found->gone[place[k]] || fate[k] == FMB_FATE_REDUNDANT);
        cr_assert(!found->kept[place[k]] || fate[k] == FMB_FATE_KEPT);
        dependents += found->gone[place[k]] && row[k].rel == FMB_EQ;
        fate[k] = FMB_FATE_UNKNOWN;
    }
    cr_assert_eq(fmb_irredundant(run, d->n, m, row, fate, NULL, &feasible), FMB_OK);
    for (size_t k = 0; feasible && k < m; k++)
        flat |= fate[k] == FMB_FATE_EQUALITY;
    cr_assert(!(found->inner && flat));
}

Test(substituted_rows, are_sorted_as_the_oracle_does)
{
    static drawn d;
    support_rng g = {20261126};
    fmb_options o = {.size = sizeof o};
    atomic_int cancel = 0;
    fmb_mem mem;
    fmb_run run;
    fmb_arena arena;
    fmb_num num;
    fmb_mem_init(&mem, NULL, 0);
    fmb_arena_init(&arena, &mem);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    cr_assert_eq(fmb_run_open_num(&run, &num, COLUMNS + 1, false), FMB_OK);
    for (int trial = 0; trial < TRIALS / WATCHED; trial++) {
        bool any = trial % 2 == 0, gone[ROWS] = {0}, kept[ROWS] = {0}, tight[ROWS] = {0};
        bool equal = false;
        fmb_sorting out = {.gone = gone, .kept = kept, .known = !any && trial % 4 == 1};
        draw_rows(&d, &g, any);
        fmb_arena_reset(&arena);
        cr_assert_eq(fmb_substituted_rows_sort(&run, &arena, &num, d.n, d.m, d.row, &out,
                                               trial % 3 == 0 ? NULL : tight),
                     FMB_OK);
        expect_truth(&run, &d, &out, tight);
        for (size_t i = 0; i < d.m; i++) {
            equal |= d.row[i].rel == FMB_EQ;
            longs += d.v[i].bits > 40;
        }
        roomless += trial % 3 != 0 && out.feasible && !out.inner;
        insides += equal && out.inner;
        outsides += equal && out.feasible && !out.inner;
        empties += equal && !out.feasible;
    }
    const int met[] = {insides, outsides, empties, dependents, longs, tights};
    for (size_t i = 0; i < sizeof met / sizeof *met; i++)
        cr_expect(met[i] > 10 / WATCHED, "%zu: %d", i, met[i]);
    cr_expect_eq(roomless, 0,
                 "where tight rows are looked for, there is a point inside the others");
    fmb_num_clear(&num);
    fmb_arena_clear(&arena);
    cr_expect_eq(mem.used, 0);
}
