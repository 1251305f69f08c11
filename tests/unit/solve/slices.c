/* slices.c: engines that resume where they stopped: whose turn it is, and that pauses do not change
 * results. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include "property/random/agree.h"
#include "solve/portfolio/slices.h"
#include "support.h"

/* ---- whose turn it is ------------------------------------------------------------------------ */

static fmb_slices three_engines(double expected0, double expected1, double expected2)
{
    return (fmb_slices){
        .engines = 3,
        .engine = {{.expected = expected0}, {.expected = expected1}, {.expected = expected2}}};
}

/* The one that is expected to take least goes first, but no longer than six times what the next one
 * is expected to; then that one goes on as long. */
Test(slices, first_engine_gets_what_the_next_is_expected_to_take)
{
    fmb_slices t = three_engines(3e6, 1e6, 1e12);
    uint64_t slice;
    cr_expect_eq(fmb_slices_next(&t, &slice), 1);
    cr_expect_eq(slice, (uint64_t)18e6);
    t.engine[1].spent = slice;
    cr_expect_eq(fmb_slices_next(&t, &slice), 0);
    cr_expect_eq(slice, (uint64_t)27e6);
}

/* Who has given up does nothing, and the last one that has not goes on to its end. */
Test(slices, of_the_last_engine_have_no_end)
{
    fmb_slices t = three_engines(3e6, 1e6, 1e12);
    uint64_t slice;
    t.engine[1].over = true;
    cr_expect_eq(fmb_slices_next(&t, &slice), 0);
    t.engine[0].over = true;
    cr_expect_eq(fmb_slices_next(&t, &slice), 2);
    cr_expect_eq(slice, 0);
}

/* Whoever takes w and is expected to take e ends before all have done w + 12 max(e, w / 4)
 * together, but for their least slices, whatever is expected of others. */
Test(slices, cost_a_bounded_factor)
{
    static const double expected[] = {1, 1e3, 1e6, 1e9, 1e12, 1e15};
    enum { COUNT = sizeof expected / sizeof *expected };
    const double need = (double)((uint64_t)1 << 32);
    for (size_t i = 0; i < COUNT * COUNT * COUNT; i++) {
        double e = expected[i % COUNT];
        fmb_slices t = three_engines(expected[i / COUNT % COUNT], e, expected[i / COUNT / COUNT]);
        double total = 0;
        for (uint64_t slice; (double)t.engine[1].spent < need;) {
            size_t k = fmb_slices_next(&t, &slice);
            double left = need - (double)t.engine[1].spent;
            bool ends = k == 1 && (double)slice >= left;
            t.engine[k].spent += ends ? (uint64_t)left : slice;
            total += ends ? left : (double)slice;
        }
        cr_expect_leq(total, need + 12 * fmax(e, need / 4) + 3 * 65536, "%g %g %g: %g",
                      t.engine[0].expected, e, t.engine[2].expected, total / need);
    }
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
