/* doubt.c: projections of small systems, of which many have no solution. Without evidence that is
 * found on the stack; with evidence it is proved. */
#include <criterion/criterion.h>

#include "property/random/agree.h"
#include "support.h"

static fmb_solver *solver(fmb_method method, fmb_evidence_kept evidence)
{
    fmb_options o = fmb_options_default();
    fmb_solver *v = NULL;
    o.method = method;
    o.evidence = evidence;
    must(fmb_solver_new(&o, NULL, &v));
    return v;
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

typedef struct tally {
    int empty, others;
} tally;

static void check_seed(uint64_t seed, tally *sum)
{
    support_rng rng = {seed};
    int n = support_between(&rng, 2, 9), keep = support_between(&rng, 1, n - 1);
    fmb_system *p[3], *s = rows_that_name_few(&rng, n, n + support_between(&rng, 0, 9));
    fmb_solver *v[3] = {solver(FMB_METHOD_AUTO, FMB_EVIDENCE_NONE),
                        solver(FMB_METHOD_AUTO, FMB_EVIDENCE_WHOLE),
                        solver(FMB_METHOD_DD, FMB_EVIDENCE_NONE)};
    fmb_result r[3];
    agree g = {.max_rows = 5000};
    for (int k = 0; k < 3; k++) {
        must(fmb_project(v[k], s, (int[]){0, 1, 2, 3, 4, 5, 6, 7}, keep, &p[k], &r[k]));
        cr_assert_eq(r[k].verdict, r[0].verdict, "seed %lu", (unsigned long)seed);
        cr_assert_eq(fmb_system_rows(p[k]), fmb_system_rows(p[0]), "seed %lu", (unsigned long)seed);
        cr_assert(agree_same(&g, p[k], p[0]), "seed %lu: %s", (unsigned long)seed, g.why);
    }
    sum->empty += r[0].verdict == FMB_INFEASIBLE;
    sum->others += r[0].verdict == FMB_FEASIBLE;
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
        check_seed(seed, &sum);
    cr_expect(sum.empty > 100 && sum.others > 100, "%d, %d", sum.empty, sum.others);
}
