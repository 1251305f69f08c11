/* recession.c: projections with unbounded eliminated variables, against elimination. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include "property/random/agree.h"
#include "support.h"

static fmb_solver *solver(fmb_method method)
{
    return must_open((fmb_options){.method = method,
                                   .evidence = method == FMB_METHOD_AUTO ? FMB_EVIDENCE_WHOLE
                                                                         : FMB_EVIDENCE_NONE,
                                   .max_rows = 5000});
}

/* a[n], or doubles near it that make a row of numbers longer than a word. */
static void append_row(support_rng *g, fmb_system *s, int n, const int64_t *a, bool is_long,
                       fmb_rel rel, int64_t right)
{
    double x[16];
    for (int j = 0; j < n; j++)
        x[j] = !is_long || a[j] == 0
                   ? (double)a[j]
                   : ldexp((double)a[j] + ldexp(support_between(g, 1, 1 << 29), -49),
                           support_between(g, -7, 7));
    must(fmb_system_add(s, x, rel, (double)right));
}

/* m rows in n variables, of which the first `only` name none but the first `keep`. Of the others
 * most go down along the last variables. */
static fmb_system *rows_that_mostly_escape(support_rng *g, int n, int keep, int m, int only,
                                           bool is_long)
{
    fmb_system *s = rows_none(n);
    int down = support_between(g, 50, 100);
    for (int i = 0; i < m; i++) {
        int64_t a[16];
        for (int j = 0; j < n; j++)
            a[j] = support_between(g, -9, 9);
        for (int j = keep; j < n; j++)
            a[j] = i < only ? 0 : support_chance(g, down) ? -support_between(g, 1, 9) : a[j];
        fmb_rel rel = support_chance(g, 20) ? FMB_LT : FMB_LE;
        append_row(g, s, n, a, is_long, rel, support_between(g, -4, 9));
    }
    return s;
}

static void check_evidence(const fmb_solver *v, const fmb_system *s, uint64_t seed)
{
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_assert(j.accepted, "seed %lu, claim %zu: %s", (unsigned long)seed, j.claim, j.reason);
    fmb_evidence_free(e);
}

/* No row of p has to do with other rows than the first `only`. */
static bool is_no_row_new(const fmb_system *p, int only)
{
    return fmb_system_rows(p) <= (size_t)only;
}

typedef struct tally {
    int escaped, far, others, empty, unjudged; /* far: escaped, of long numbers */
} tally;

static void check_seed(uint64_t seed, tally *sum)
{
    support_rng rng = {seed};
    int n = support_between(&rng, 4, 8), keep = support_between(&rng, 1, n - 2), kept[8];
    int only = support_chance(&rng, 50) ? support_between(&rng, 1, 3) : 0;
    int m = n + support_between(&rng, 2, 8);
    bool is_long = seed % 3 == 0;
    fmb_system *p = NULL, *q = NULL, *s = rows_that_mostly_escape(&rng, n, keep, m, only, is_long);
    fmb_solver *v = solver(FMB_METHOD_AUTO), *fm = solver(FMB_METHOD_FM);
    fmb_result r = {.size = sizeof r}, other = {.size = sizeof other};
    agree g = {.max_rows = 5000};
    for (int j = 0; j < keep; j++)
        kept[j] = j;
    must(fmb_project(v, s, kept, keep, &p, &r));
    must(fmb_project(fm, s, kept, keep, &q, &other));
    bool judged = r.stop == FMB_STOP_DONE && other.stop == FMB_STOP_DONE;
    if (judged) {
        check_evidence(v, s, seed);
        cr_assert_eq(r.verdict, other.verdict, "seed %lu", (unsigned long)seed);
        cr_assert_eq(fmb_system_rows(p), fmb_system_rows(q), "seed %lu", (unsigned long)seed);
        cr_assert(agree_same(&g, p, q), "seed %lu: %s", (unsigned long)seed, g.why);
    }
    sum->unjudged += !judged;
    sum->empty += judged && r.verdict == FMB_INFEASIBLE;
    sum->escaped += judged && r.verdict == FMB_FEASIBLE && is_no_row_new(p, only);
    sum->far += is_long && judged && r.verdict == FMB_FEASIBLE && is_no_row_new(p, only);
    sum->others += judged && r.verdict == FMB_FEASIBLE && !is_no_row_new(p, only);
    fmb_system_free(p);
    fmb_system_free(q);
    fmb_system_free(s);
    fmb_solver_free(v);
    fmb_solver_free(fm);
}

Test(escape, as_elimination_says)
{
    tally sum = {0};
    for (uint64_t seed = 0; seed < 400; seed++)
        check_seed(seed, &sum);
    cr_expect(sum.escaped > 100 && sum.far > 30 && sum.others > 50 && sum.empty > 10,
              "%d, %d, %d, %d", sum.escaped, sum.far, sum.others, sum.empty);
    cr_expect_leq(sum.unjudged, 20, "%d unjudged", sum.unjudged);
}

/* ---- a search -------------------------------------------------------------------------------- */

/* Variables, those that stay, rows: a direction is there about as often as not. */
enum { MANY = 29, FEW = 4, ROWS = 45 };

typedef struct watched_direction {
    fmb_solver *v;
    bool found;
} watched_direction;

/* Without a direction nobody waits for the engines. */
static void watch_direction(void *self, const fmb_event *e)
{
    watched_direction *w = self;
    if (e->kind != FMB_EVENT_ENGINE || strcmp(e->attempt->engine, "recession direction") != 0)
        return;
    w->found = strcmp(e->attempt->ended, "answered") == 0;
    if (!w->found)
        fmb_solver_cancel(w->v);
}

static fmb_system *rows_of_a_narrow_cone(uint64_t seed)
{
    support_rng g = {seed};
    fmb_system *s = rows_none(MANY);
    for (int i = 0; i < ROWS; i++) {
        double a[MANY];
        for (int j = 0; j < MANY; j++)
            a[j] = support_between(&g, -9, 9);
        must(fmb_system_add(s, a, FMB_LE, support_between(&g, 0, 49)));
    }
    return s;
}

/* Is the projection everything because a direction was found? */
static bool is_direction_found(uint64_t seed)
{
    const int kept[FEW] = {0, 1, 2, 3};
    fmb_system *p = NULL, *s = rows_of_a_narrow_cone(seed);
    watched_direction w = {.v = must_open((fmb_options){.evidence = FMB_EVIDENCE_WHOLE})};
    fmb_solver_set_sink(w.v, (fmb_sink){watch_direction, &w});
    must(fmb_project(w.v, s, kept, FEW, &p, NULL));
    if (w.found) {
        cr_expect_eq(fmb_system_rows(p), 0, "seed %lu", (unsigned long)seed);
        check_evidence(w.v, s, seed);
    }
    fmb_system_free(p);
    fmb_system_free(s);
    fmb_solver_free(w.v);
    return w.found;
}

/* A glance finds a direction in 19 of these, a search in 31. */
Test(escape, where_a_glance_is_not_enough)
{
    int found = 0;
    for (uint64_t seed = 1; seed <= 40; seed++)
        found += is_direction_found(seed);
    cr_expect_gt(found, 25, "%d", found);
}
