/* slices.c: engines that go on where they stopped: whose turn it is, what trends tell, and that
 * stops and goes change nothing.
 */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include "property/random/agree.h"
#include "solve/portfolio/slices.h"
#include "support.h"
#include "trace/trend.h"

/* ---- whose turn it is ------------------------------------------------------------------------ */

static fmb_slices three_engines(double left0, double left1, double left2)
{
    return (fmb_slices){.engines = 3,
                        .engine = {{.left = left0, .share = 1},
                                   {.left = left1, .share = 1},
                                   {.left = left2, .share = 2}}};
}

/* Without estimates all do their shares, up to a slice, and one that gave up does nothing. */
Test(slices, are_equal_where_nobody_can_tell)
{
    fmb_slices t = three_engines(INFINITY, INFINITY, INFINITY);
    t.engine[1].over = true;
    uint64_t slice;
    for (int i = 0; i < 200; i++) {
        size_t k = fmb_slices_next(&t, &slice);
        cr_assert(k != 1 && slice > 0);
        fmb_slices_note(&t, k, slice);
    }
    double ratio = 2 * (double)t.engine[0].spent / (double)t.engine[2].spent;
    cr_expect(ratio > 0.75 && ratio < 1.34, "%g", ratio);
    cr_expect_eq(t.engine[1].spent, 0);
    cr_expect_eq(t.ahead, 0);
}

/* Whoever needs w, with one share of four, ends before all have done 7 w together, whatever others
 * say: 4 w and slices of a quarter, and half as much by runs ahead. */
Test(slices, cost_a_bounded_factor)
{
    static const double lies[] = {INFINITY, 1e3, 1e6, 1e9, 1e12};
    const uint64_t need = (uint64_t)1 << 32;
    for (size_t i = 0; i < sizeof lies / sizeof *lies; i++)
        for (size_t j = 0; j < sizeof lies / sizeof *lies; j++) {
            fmb_slices t = three_engines(lies[i], INFINITY, lies[j]);
            uint64_t slice, total = 0;
            while (t.engine[1].spent < need) {
                size_t k = fmb_slices_next(&t, &slice);
                fmb_slices_note(&t, k, slice);
                total += slice;
            }
            cr_expect_leq((double)total / (double)need, 7, "%g %g: %g", lies[i], lies[j],
                          (double)total / (double)need);
        }
}

/* One that needs less than half of what others do runs ahead, once it is worth less than what all
 * have done; one that needs as much does not. */
Test(slices, let_one_run_ahead)
{
    fmb_slices t = three_engines(1e8, 1e9, INFINITY);
    uint64_t slice;
    t.engine[0].spent = t.engine[1].spent = t.engine[2].spent = (uint64_t)1e8;
    t.equal = (uint64_t)3e8;
    t.engine[0].left = 5e7;
    cr_expect_eq(fmb_slices_next(&t, &slice), 0);
    cr_expect(t.runs_ahead && slice >= (uint64_t)5e7);
    t.engine[1].left = 6e7;
    fmb_slices_next(&t, &slice);
    cr_expect_not(t.runs_ahead);
    t.engine[1].left = INFINITY;
    t.engine[0].left = 1e9;
    fmb_slices_next(&t, &slice);
    cr_expect_not(t.runs_ahead, "it cannot end in time");
}

/* ---- trends ---------------------------------------------------------------------------------- */

/* Steps that grow by a factor that fades away linearly, as rays do: what is left is told to a
 * factor of 1.6 in the last third of them. */
Test(slices, trends_tell_what_is_left)
{
    enum { STEPS = 24 };
    double work[STEPS], all = 0, done = 0;
    fmb_trend t = {0};
    uint64_t at = 0;
    for (int i = 0; i < STEPS; i++) {
        work[i] = i == 0 ? 1e4 : work[i - 1] * exp(0.5 * (1 - (double)i / STEPS));
        all += work[i];
    }
    cr_expect(isinf(fmb_trend_left(&t, 0, STEPS)));
    for (int i = 0; i < STEPS; i++) {
        fmb_trend_go_on(&t, at);
        at += (uint64_t)work[i] / 2;
        fmb_trend_pause(&t, at);
        at += 1000000; /* somebody else's */
        fmb_trend_go_on(&t, at);
        at += (uint64_t)work[i] / 2;
        fmb_trend_end_step(&t, at);
        done += work[i];
        double told = fmb_trend_left(&t, 0, (size_t)(STEPS - 1 - i));
        if (3 * i >= 2 * STEPS && i + 1 < STEPS)
            cr_expect(told / (all - done) > 1 / 1.6 && told / (all - done) < 1.6, "%d: %g", i,
                      told / (all - done));
    }
    cr_expect_eq(fmb_trend_left(&t, 0, 0), 0);
}

/* A step on its way of which a quarter is done. */
Test(slices, trends_tell_of_the_step_on_its_way)
{
    fmb_trend t = {0};
    fmb_trend_go_on(&t, 0);
    fmb_trend_pause(&t, 1000);
    cr_expect_eq(fmb_trend_left(&t, 0.25, 1), 3000);
    cr_expect(isinf(fmb_trend_left(&t, 0, 1)));
}

/* ---- on systems ------------------------------------------------------------------------------ */

typedef struct heard_slices {
    int paused, engines;
    const char *engine[3];
    uint64_t spent;
} heard_slices;

static void hear_slice(void *self, const fmb_event *e)
{
    heard_slices *h = self;
    if (e->kind != FMB_EVENT_ENGINE || strcmp(e->attempt->ended, "paused") != 0)
        return;
    h->paused++;
    h->spent += e->attempt->spent;
    cr_expect_str_eq(e->attempt->unit, "steps");
    int k = 0;
    while (k < h->engines && strcmp(h->engine[k], e->attempt->engine) != 0)
        k++;
    cr_assert_lt(k, 3);
    if (k == h->engines)
        h->engine[h->engines++] = e->attempt->engine;
}

/* Sparse rows around a point: neither rays nor facets are few. */
static fmb_system *sparse_system(uint64_t seed, int dim, int rows)
{
    support_rng g = {seed};
    fmb_system *s = rows_none(dim);
    for (int i = 0; i < rows; i++) {
        int64_t a[32] = {0}, right = 0;
        for (int k = 0; k < 3; k++)
            a[support_between(&g, 0, dim - 1)] = support_between(&g, -9, 9);
        for (int j = 0; j < dim; j++)
            right += a[j] * (j % 5 - 2);
        must(fmb_system_add_int(s, a, FMB_LE, right + support_between(&g, 1, 40)));
    }
    return s;
}

static fmb_system *project_and_hear(const fmb_system *s, int keep, fmb_method method,
                                    heard_slices *h)
{
    static const int kept[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_system *out = NULL;
    fmb_result r = {.size = sizeof r};
    o.method = method;
    must(fmb_solver_new(&o, NULL, &v));
    *h = (heard_slices){0};
    fmb_solver_set_sink(v, (fmb_sink){hear_slice, h});
    must(fmb_project(v, s, kept, keep, &out, &r));
    cr_expect_eq(r.stop, FMB_STOP_DONE);
    fmb_solver_free(v);
    return out;
}

/* Engines stop and go on, all three of them; the same system takes the same way each time, and
 * comes to what elimination alone comes to. */
Test(slices, of_projections_end_as_others_do)
{
    for (uint64_t seed = 1; seed <= 3; seed++) {
        heard_slices first, second, none;
        agree same = {.max_rows = 5000};
        fmb_system *s = sparse_system(seed, 15, 28);
        fmb_system *a = project_and_hear(s, 7, FMB_METHOD_AUTO, &first);
        fmb_system *b = project_and_hear(s, 7, FMB_METHOD_AUTO, &second);
        fmb_system *c = project_and_hear(s, 7, FMB_METHOD_FM, &none);
        cr_expect(first.paused == second.paused && first.spent == second.spent);
        cr_expect_eq(none.paused, 0);
        cr_expect(agree_same(&same, a, c), "seed %d: %s", (int)seed, same.why);
        printf("seed %d: %d paused, %d engines\n", (int)seed, first.paused, first.engines);
        fmb_system_free(a);
        fmb_system_free(b);
        fmb_system_free(c);
        fmb_system_free(s);
    }
}
