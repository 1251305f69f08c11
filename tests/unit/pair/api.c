/* api.c: fmb_pair_test as documented in its header: arguments, arrays, contact, memory. */
#include <criterion/criterion.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>

#include <fmb/pair.h>

#include "fault/hook.h"
#include "property/random/rows.h"
#include "support/pair_counts.h"

static const double ZERO[3], UNIT[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

static fmb_frame cube(int dim, const double *origin)
{
    static const double square[4] = {1, 0, 0, 1};
    return (fmb_frame){FMB_CUBOID, dim, dim, origin, dim == 2 ? square : UNIT, NULL};
}

static fmb_pair *opened(int dim, const fmb_pair_options *o)
{
    fmb_pair *k = NULL;
    must(fmb_pair_new(dim, o, NULL, &k));
    return k;
}

/* ---- answers --------------------------------------------------------------------------------- */

Test(pair, squares_that_overlap_touch_and_are_apart)
{
    const double place[3][2] = {{0.5, 0.25}, {1, 0}, {1.5, 0}};
    const fmb_verdict closed[3] = {FMB_FEASIBLE, FMB_FEASIBLE, FMB_INFEASIBLE};
    const fmb_verdict open[3] = {FMB_FEASIBLE, FMB_INFEASIBLE, FMB_INFEASIBLE};
    fmb_frame p[3], q[3];
    for (int i = 0; i < 3; i++) {
        p[i] = cube(2, ZERO);
        q[i] = cube(2, place[i]);
    }
    for (int contact = 0; contact < 2; contact++) {
        fmb_pair_options o = {.size = sizeof o};
        o.contact = (fmb_contact)contact;
        fmb_pair *k = opened(2, &o);
        fmb_verdict verdict[3];
        double world[3][2][2], inside[3][2][2], time[3][2], witness[3][2];
        const fmb_pair_answers out = {.size = sizeof(fmb_pair_answers),
                                      .verdict = verdict,
                                      .world = &world[0][0][0],
                                      .inside = &inside[0][0][0],
                                      .time = &time[0][0],
                                      .witness = &witness[0][0]};
        must(fmb_pair_test(k, 3, p, q, &out));
        for (int i = 0; i < 3; i++)
            cr_expect_eq(verdict[i], contact ? open[i] : closed[i], "%d %d", contact, i);
        cr_expect_eq(counts_of_pairs(k).pairs, 3u);
        cr_expect_float_eq(world[0][0][0], 0.5, 1e-12);
        cr_expect_float_eq(world[0][1][1], 1, 1e-12);
        cr_expect_float_eq(inside[0][0][1], 0.5, 1e-12);
        cr_expect_float_eq(inside[0][1][1], 0.75, 1e-12);
        cr_expect(witness[0][0] >= 0.5 - 1e-12 && witness[0][0] <= 1 + 1e-12);
        cr_expect_eq(time[0][1], 1);
        fmb_pair_free(k);
    }
}

/* A cube flies past another: from t = 1/4, when faces touch, to t = 3/4. */
Test(pair, contact_times)
{
    const double origin[3] = {-2, 0.5, 0}, speed[3] = {4, 0, 0};
    fmb_frame p = cube(3, ZERO), q = cube(3, origin);
    q.speed = speed;
    for (int tightest = 0; tightest < 2; tightest++) {
        fmb_pair_options o = {.size = sizeof o};
        o.tightest = tightest;
        fmb_pair *k = opened(3, &o);
        fmb_verdict verdict;
        double world[3][2], time[2];
        const fmb_pair_answers out = {
            .size = sizeof out, .verdict = &verdict, .world = world[0], .time = time};
        must(fmb_pair_test(k, 1, &p, &q, &out));
        cr_assert_eq(verdict, FMB_FEASIBLE);
        cr_expect(time[0] <= 0.25 && time[0] >= 0.25 - 1e-12);
        cr_expect(time[1] >= 0.75 && time[1] <= 0.75 + 1e-12);
        cr_expect(world[0][0] <= 0 && world[0][1] >= 1 && world[1][0] <= 0.5);
        if (tightest)
            cr_expect(time[0] == 0.25 && time[1] == 0.75 && world[1][0] == 0.5);
        fmb_pair_free(k);
    }
}

/* Only the arrays that are there are written, and those of pairs that meet alone. */
Test(pair, nothing_else_is_written)
{
    const double place[2][2] = {{5, 5}, {0.5, 0.5}};
    fmb_frame p[2] = {cube(2, ZERO), cube(2, ZERO)}, q[2] = {cube(2, place[0]), cube(2, place[1])};
    fmb_pair *k = opened(2, NULL);
    fmb_verdict verdict[2];
    double world[2][2][2];
    for (int i = 0; i < 8; i++)
        (&world[0][0][0])[i] = 77;
    must(fmb_pair_test(k, 2, p, q,
                       &(fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                                           .verdict = verdict,
                                           .world = world[0][0]}));
    cr_expect_eq(verdict[0], FMB_INFEASIBLE);
    for (int i = 0; i < 4; i++)
        cr_expect_eq((&world[0][0][0])[i], 77);
    cr_expect_neq(world[1][0][0], 77);
    must(fmb_pair_test(k, 0, NULL, NULL, &(fmb_pair_answers){.size = sizeof(fmb_pair_answers)}));
    fmb_pair_free(k);
}

/* ---- arguments ------------------------------------------------------------------------------- */

Test(pair, arguments)
{
    const double bad[2] = {NAN, 0}, huge[2] = {INFINITY, 0};
    fmb_pair *k = NULL;
    fmb_pair_options o = {.size = sizeof o};
    cr_expect_eq(fmb_pair_new(0, &o, NULL, &k), FMB_ERR_ARG);
    cr_expect_eq(fmb_pair_new(2, &o, NULL, NULL), FMB_ERR_ARG);
    o.contact = (fmb_contact)2;
    cr_expect_eq(fmb_pair_new(2, &o, NULL, &k), FMB_ERR_ARG);
    o = (fmb_pair_options){.size = sizeof(fmb_pair_options)};
    o.method = (fmb_pair_method)2;
    cr_expect_eq(fmb_pair_new(2, &o, NULL, &k), FMB_ERR_ARG);
    o = (fmb_pair_options){.size = sizeof(fmb_pair_options)};
    o.max_seconds = NAN;
    cr_expect_eq(fmb_pair_new(2, &o, NULL, &k), FMB_ERR_ARG);
    o = (fmb_pair_options){.size = sizeof(fmb_pair_options)};
    o.simd = (fmb_simd)9;
    cr_expect_eq(fmb_pair_new(2, &o, NULL, &k), FMB_ERR_ARG);
    cr_expect_null(k);
    fmb_pair_free(NULL);

    k = opened(2, NULL);
    fmb_verdict verdict = FMB_UNKNOWN;
    const fmb_pair_answers out = {.size = sizeof out, .verdict = &verdict};
    fmb_frame good = cube(2, ZERO), wrong[6];
    for (int i = 0; i < 6; i++)
        wrong[i] = good;
    wrong[0].origin = bad;
    wrong[1].origin = huge;
    wrong[2].dim = 3;
    wrong[3].naxes = 3;
    wrong[4].shape = (fmb_shape)4;
    wrong[5].axes = NULL;
    for (int i = 0; i < 6; i++) {
        cr_expect_eq(fmb_pair_test(k, 1, &good, &wrong[i], &out), FMB_ERR_ARG, "%d", i);
        cr_expect_eq(fmb_pair_test(k, 1, &wrong[i], &good, &out), FMB_ERR_ARG, "%d", i);
    }
    cr_expect_eq(fmb_pair_test(k, 1, &good, &good, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_pair_test(k, 1, NULL, &good, &out), FMB_ERR_ARG);
    cr_expect_eq(
        fmb_pair_test(k, 1, &good, &good, &(fmb_pair_answers){.size = sizeof(fmb_pair_answers)}),
        FMB_ERR_ARG);
    must(fmb_pair_test(k, 1, &good, &good, &out));
    cr_expect_eq(verdict, FMB_FEASIBLE);
    fmb_pair_free(k);
}

/* Which pair, which frame of it, which number. */
Test(pair, trouble_says_where)
{
    enum { PAIRS = 200000, WRONG = 123456 };
    const double bad[2] = {0, NAN}, edges[4] = {1, 0, INFINITY, 1};
    fmb_frame *p = calloc(PAIRS, sizeof *p), *q = calloc(PAIRS, sizeof *q);
    fmb_verdict *verdict = calloc(PAIRS, sizeof *verdict);
    const fmb_pair_answers out = {.size = sizeof out, .verdict = verdict};
    fmb_pair *k = opened(2, NULL);
    for (int i = 0; i < PAIRS; i++)
        p[i] = q[i] = cube(2, ZERO);
    must(fmb_pair_test(k, 1, p, q, &out));
    cr_expect_str_empty(fmb_pair_trouble(k));
    const struct {
        fmb_frame frame;
        const char *text;
    } wrong[] = {
        {{FMB_CUBOID, 2, 2, bad, UNIT, NULL}, "origin[1] is not finite"},
        {{FMB_CUBOID, 2, 2, ZERO, edges, NULL}, "axes[1][0] is not finite"},
        {{FMB_CUBOID, 2, 2, ZERO, UNIT, bad}, "speed[1] is not finite"},
        {{FMB_CUBOID, 2, 2, NULL, UNIT, NULL}, "origin is NULL"},
        {{FMB_CUBOID, 2, 2, ZERO, NULL, NULL}, "axes is NULL"},
        {{FMB_CUBOID, 2, 3, ZERO, UNIT, NULL}, "naxes is 3, not 0 to 2"},
        {{FMB_CUBOID, 2, -1, ZERO, UNIT, NULL}, "naxes is -1, not 0 to 2"},
        {{FMB_CUBOID, 3, 3, ZERO, UNIT, NULL}, "dim is 3, not 2"},
        {{FMB_CUBOID, INT_MAX, INT_MAX, ZERO, UNIT, NULL}, "dim is 2147483647, not 2"},
        {{(fmb_shape)7, 2, 2, ZERO, UNIT, NULL}, "shape is 7, which is none"},
    };
    for (size_t c = 0; c < sizeof wrong / sizeof *wrong; c++) {
        char want[80];
        fmb_frame *at = c % 2 ? &q[WRONG] : &p[WRONG], good = *at;
        *at = wrong[c].frame;
        snprintf(want, sizeof want, "%c[%d]: %s", c % 2 ? 'q' : 'p', WRONG, wrong[c].text);
        cr_expect_eq(fmb_pair_test(k, PAIRS, p, q, &out), FMB_ERR_ARG);
        cr_expect_str_eq(fmb_pair_trouble(k), want);
        *at = good;
    }
    must(fmb_pair_test(k, 1, p, q, &out));
    cr_expect_str_empty(fmb_pair_trouble(k));
    fmb_pair_free(k);
    free(p);
    free(q);
    free(verdict);
}

/* Nothing crashes, and what can say so says what is missing. */
Test(pair, null)
{
    fmb_pair *k = NULL;
    fmb_frame good = cube(2, ZERO);
    fmb_verdict verdict;
    const fmb_pair_answers out = {.size = sizeof out, .verdict = &verdict};
    cr_expect_eq(fmb_pair_count(NULL, &(fmb_pair_counts){.size = sizeof(fmb_pair_counts)}),
                 FMB_ERR_ARG);
    cr_expect_str_empty(fmb_pair_trouble(NULL));
    fmb_pair_cancel(NULL);
    cr_expect_eq(fmb_pair_test(NULL, 1, &good, &good, &out), FMB_ERR_ARG);
    cr_expect_eq(fmb_pair_new(INT_MAX, NULL, NULL, &k), FMB_ERR_ARG);
    cr_expect_eq(fmb_pair_new(-1, NULL, NULL, &k), FMB_ERR_ARG);
    cr_expect_null(k);
    k = opened(2, NULL);
    cr_expect_eq(fmb_pair_test(k, 1, &good, &good, NULL), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_pair_trouble(k), "out is NULL");
    cr_expect_eq(fmb_pair_test(k, 1, NULL, &good, &out), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_pair_trouble(k), "p is NULL");
    cr_expect_eq(fmb_pair_test(k, 1, &good, NULL, &out), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_pair_trouble(k), "q is NULL");
    cr_expect_eq(
        fmb_pair_test(k, 1, &good, &good, &(fmb_pair_answers){.size = sizeof(fmb_pair_answers)}),
        FMB_ERR_ARG);
    cr_expect_str_eq(fmb_pair_trouble(k), "out->verdict is NULL");
    fmb_pair_free(k);
}

/* Instructions can be forced; those that the processor lacks are refused. */
Test(pair, instructions)
{
    const double place[2] = {0.5, 0.5};
    fmb_frame p[5], q[5];
    for (int i = 0; i < 5; i++) {
        p[i] = cube(2, ZERO);
        q[i] = cube(2, place);
    }
    int levels = 0;
    for (int simd = FMB_SIMD_AUTO; simd <= FMB_SIMD_AVX512; simd++) {
        fmb_pair_options o = {.size = sizeof o};
        fmb_pair *k = NULL;
        fmb_verdict verdict[5] = {0};
        o.simd = (fmb_simd)simd;
        if (fmb_pair_new(2, &o, NULL, &k) != FMB_OK)
            continue;
        levels++;
        must(fmb_pair_test(
            k, 5, p, q, &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = verdict}));
        for (int i = 0; i < 5; i++)
            cr_expect_eq(verdict[i], FMB_FEASIBLE);
        fmb_pair_free(k);
    }
    cr_expect_geq(levels, 2);
}

/* ---- limits, memory, cancel ------------------------------------------------------------------ */

/* Touching frames cannot be told in doubles. */
Test(pair, doubles_only_leaves_the_close_ones)
{
    const double place[2][2] = {{1, 0}, {0.5, 0.5}};
    fmb_frame p[2] = {cube(2, ZERO), cube(2, ZERO)}, q[2] = {cube(2, place[0]), cube(2, place[1])};
    fmb_pair_options o = {.size = sizeof o};
    o.doubles_only = true;
    fmb_pair *k = opened(2, &o);
    fmb_verdict verdict[2];
    must(fmb_pair_test(k, 2, p, q,
                       &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = verdict}));
    cr_expect_eq(verdict[0], FMB_UNKNOWN);
    cr_expect_eq(verdict[1], FMB_FEASIBLE);
    cr_expect_eq(counts_of_pairs(k).exact_verdicts, 0u);
    fmb_pair_free(k);
}

Test(pair, memory)
{
    const double place[2][2] = {{1, 0}, {0.5, 0.5}};
    fmb_frame p[2] = {cube(2, ZERO), cube(2, ZERO)}, q[2] = {cube(2, place[0]), cube(2, place[1])};
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t fail = 1; st != FMB_OK; fail++) {
        fmb_pair *k = NULL;
        fmb_verdict verdict[2];
        double world[2][2][2], witness[2][2];
        const fmb_pair_answers out = {
            .size = sizeof out, .verdict = verdict, .world = world[0][0], .witness = witness[0]};
        hook_arm(&h, fail, false);
        st = fmb_pair_new(2, NULL, &mem, &k);
        if (st == FMB_OK)
            st = fmb_pair_test(k, 2, p, q, &out);
        cr_assert(st == FMB_OK || st == FMB_ERR_MEMORY);
        hook_calm(&h);
        if (k) {
            must(fmb_pair_test(k, 2, p, q, &out));
            cr_expect(verdict[0] == FMB_FEASIBLE && verdict[1] == FMB_FEASIBLE);
        }
        fmb_pair_free(k);
        cr_assert_eq(h.live, 0);
    }
}

enum { MANY = 20000 };

/* An allocator that cancels at a request that is counted: from within, whatever the machine does.
 */
typedef struct fuse {
    fmb_pair *k;
    size_t calls, cancel_at; /* 0: never */
} fuse;

static void *count_and_cancel(void *self, void *p, size_t old_bytes, size_t new_bytes)
{
    fuse *f = self;
    (void)old_bytes;
    if (new_bytes == 0) {
        free(p);
        return NULL;
    }
    if (++f->calls == f->cancel_at)
        fmb_pair_cancel(f->k);
    return realloc(p, new_bytes);
}

static fmb_alloc fuse_alloc(fuse *f)
{
    return (fmb_alloc){count_and_cancel, f};
}

/* Exact queries take so long that there is something to cancel; what is answered is right, and the
 * next call is not touched. */
Test(pair, cancel)
{
    static fmb_frame p[MANY], q[MANY];
    static fmb_verdict verdict[MANY];
    const double place[2] = {1, 0};
    size_t known = 0;
    for (int i = 0; i < MANY; i++) {
        p[i] = cube(2, ZERO);
        q[i] = cube(2, place);
    }
    fmb_pair_options o = {.size = sizeof o};
    o.method = FMB_PAIR_EXACT;
    fuse of = {0};
    fmb_alloc alloc = fuse_alloc(&of);
    fmb_pair *k = NULL;
    must(fmb_pair_new(2, &o, &alloc, &k));
    of = (fuse){k, 0, 1000};
    must(fmb_pair_test(k, MANY, p, q,
                       &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = verdict}));
    cr_expect_geq(of.calls, of.cancel_at, "only %zu requests", of.calls);
    for (int i = 0; i < MANY; i++) {
        cr_assert_neq(verdict[i], FMB_INFEASIBLE);
        known += verdict[i] == FMB_FEASIBLE;
    }
    cr_expect_lt(known, MANY);
    must(fmb_pair_test(k, 10, p, q,
                       &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = verdict}));
    for (int i = 0; i < 10; i++)
        cr_expect_eq(verdict[i], FMB_FEASIBLE);
    fmb_pair_free(k);
}
