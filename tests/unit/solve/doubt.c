/* doubt.c: projections of small systems, many of them infeasible or without rows. Without evidence
 * they are found by the elimination on the stack; with evidence they are proved. */
#include <criterion/criterion.h>

#include "property/random/agree.h"
#include "support.h"

static fmb_solver *solver(fmb_method method, fmb_evidence_kept evidence)
{
    return must_open((fmb_options){.method = method, .evidence = evidence});
}

/* m rows that name up to four of n variables each, often far from the origin. */
static fmb_system *rows_that_name_few(support_rng *g, int n, int m)
{
    fmb_system *s = rows_none(n);
    for (int i = 0; i < m; i++) {
        int64_t a[9] = {0};
        for (int k = support_between(g, 1, 4); k > 0; k--)
            a[support_between(g, 0, n - 1)] = support_between(g, -5, 5);
        fmb_rel rel = support_chance(g, 5) ? FMB_EQ : support_chance(g, 20) ? FMB_LT : FMB_LE;
        must(fmb_system_add_int(s, a, rel, support_between(g, -3, 5)));
    }
    return s;
}

/* m rows, nearly all of which go down along a direction among the last variables, but by little. */
static fmb_system *rows_that_go_down(support_rng *g, int n, int keep, int m)
{
    fmb_system *s = rows_none(n);
    int z[9], strays = support_between(g, 0, 3);
    for (int j = 0; j < n; j++)
        z[j] = support_between(g, -3, 3);
    for (int i = 0; i < m; i++) {
        int64_t a[9], slope = 0;
        for (int j = 0; j < n; j++) {
            a[j] = support_chance(g, 40) ? 0 : support_between(g, -9, 9);
            slope += j < keep ? 0 : a[j] * z[j];
        }
        for (int j = 0; slope > 0 && j < n; j++)
            a[j] = -a[j];
        a[n - 1] += support_chance(g, 10 * strays) ? support_between(g, -9, 9) : 0;
        must(fmb_system_add_int(s, a, support_chance(g, 20) ? FMB_LT : FMB_LE,
                                support_between(g, -9, 9)));
    }
    return s;
}

typedef struct tally {
    int empty, whole, others;
} tally;

static void check_seed(uint64_t seed, bool few, tally *sum)
{
    support_rng rng = {seed};
    int n = support_between(&rng, few ? 2 : 3, few ? 9 : 6), keep = support_between(&rng, 1, n - 1);
    int m = n + support_between(&rng, 0, few ? 9 : 4);
    fmb_system *p[3],
        *s = few ? rows_that_name_few(&rng, n, m) : rows_that_go_down(&rng, n, keep, m);
    fmb_solver *v[3] = {solver(FMB_METHOD_AUTO, FMB_EVIDENCE_NONE),
                        solver(FMB_METHOD_AUTO, FMB_EVIDENCE_WHOLE),
                        solver(FMB_METHOD_DD, FMB_EVIDENCE_NONE)};
    fmb_result r[3] = {{.size = sizeof r[0]}, {.size = sizeof r[0]}, {.size = sizeof r[0]}};
    agree g = {.max_rows = 5000};
    for (int k = 0; k < 3; k++) {
        must(fmb_project(v[k], s, (int[]){0, 1, 2, 3, 4, 5, 6, 7}, keep, &p[k], &r[k]));
        cr_assert_eq(r[k].verdict, r[0].verdict, "seed %lu", (unsigned long)seed);
        cr_assert_eq(fmb_system_rows(p[k]), fmb_system_rows(p[0]), "seed %lu", (unsigned long)seed);
        cr_assert(agree_same(&g, p[k], p[0]), "seed %lu: %s", (unsigned long)seed, g.why);
    }
    sum->empty += r[0].verdict == FMB_INFEASIBLE;
    sum->whole += r[0].verdict == FMB_FEASIBLE && fmb_system_rows(p[0]) == 0;
    sum->others += r[0].verdict == FMB_FEASIBLE && fmb_system_rows(p[0]) > 0;
    for (int k = 0; k < 3; k++) {
        fmb_system_free(p[k]);
        fmb_solver_free(v[k]);
    }
    fmb_system_free(s);
}

Test(doubt, with_and_without_evidence)
{
    tally sum = {0};
    for (uint64_t seed = 0; seed < 400; seed++)
        check_seed(seed, true, &sum);
    cr_expect(sum.empty > 100 && sum.others > 100, "%d, %d", sum.empty, sum.others);
}

Test(doubt, no_row_is_left)
{
    tally sum = {0};
    for (uint64_t seed = 0; seed < 400; seed++)
        check_seed(seed, false, &sum);
    cr_expect(sum.whole > 100 && sum.others > 100, "%d, %d", sum.whole, sum.others);
}
