/* measure.c: one class of the study of dimensions; see scaling.h. */
#include <math.h>
#include <stdlib.h>

#include "common/message.h"
#include "fmb-qualify/scaling/scaling.h"
#include "fmb-qualify/watch.h"
#include "study/reference/reference.h"
#include "study/rivals/aabb.h"

enum {
    PILOTS = 256,   /* pairs to calibrate the distance */
    HALVINGS = 10,  /* of that distance */
    LP_PAIRS = 256, /* programs in memory at once */
};

static const double allowed = 1e-12; /* beyond the exact end, of the largest coordinate */

/* Pairs whose second frame was put closer to, or farther from, the first. */
typedef struct placed {
    study_pairs drawn;
    double *place; /* [n][dim] origins of the second frames */
    fmb_pair *k;
    fmb_verdict *verdict; /* [n] */
} placed;

/* The number of pairs for exact elimination and for boxes: fewer where that takes long. */
static size_t some_of(const placed *g)
{
    size_t some = (size_t)512 >> g->drawn.p[0].dim;
    return some < g->drawn.n ? some : g->drawn.n;
}

/* ---- pairs ----------------------------------------------------------------------------------- */

/* From the origin to the middle. */
static void centre(const fmb_frame *f, double *out)
{
    double share = f->shape == FMB_CUBOID ? 0.5 : 1.0 / (f->dim + 1);
    for (int j = 0; j < f->dim; j++) {
        out[j] = 0;
        for (int k = 0; k < f->naxes; k++)
            out[j] += share * f->axes[k * f->dim + j];
    }
}

/* Move the second frames so that the distance of centres is `times` the drawn distance of origins.
 */
static void put_at(placed *g, const double *away, size_t n, double times)
{
    size_t dim = (size_t)g->drawn.p[0].dim;
    for (size_t i = 0; i < n; i++) {
        double p[SCALING_MOST_DIM], q[SCALING_MOST_DIM];
        centre(&g->drawn.p[i], p);
        centre(&g->drawn.q[i], q);
        for (size_t j = 0; j < dim; j++)
            g->place[i * dim + j] =
                g->drawn.p[i].origin[j] + p[j] - q[j] + times * away[i * dim + j];
    }
}

static fmb_status ask(placed *g, size_t n)
{
    return fmb_pair_test(
        g->k, n, g->drawn.p, g->drawn.q,
        &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = g->verdict});
}

static size_t count_meeting(const placed *g, size_t n)
{
    size_t meeting = 0;
    for (size_t i = 0; i < n; i++)
        meeting += g->verdict[i] == FMB_FEASIBLE;
    return meeting;
}

/* Frames with the same centre meet, and far ones do not: bisect. */
static fmb_status find_distance(placed *g, const double *away, double *times)
{
    size_t n = g->drawn.n < PILOTS ? g->drawn.n : PILOTS;
    double low = 0, high = 4;
    fmb_status st = FMB_OK;
    for (int i = 0; st == FMB_OK && i < HALVINGS; i++) {
        double middle = (low + high) / 2;
        put_at(g, away, n, middle);
        st = ask(g, n);
        *(2 * count_meeting(g, n) > n ? &low : &high) = middle;
    }
    *times = low;
    return st;
}

static fmb_status place(placed *g)
{
    size_t n = g->drawn.n, dim = (size_t)g->drawn.p[0].dim;
    double *away = app_need(malloc(n * dim * sizeof *away)), times;
    g->place = app_need(malloc(n * dim * sizeof *g->place));
    g->verdict = app_need(malloc(n * sizeof *g->verdict));
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < dim; j++)
            away[i * dim + j] = g->drawn.q[i].origin[j] - g->drawn.p[i].origin[j];
        g->drawn.q[i].origin = g->place + i * dim;
    }
    fmb_status st = find_distance(g, away, &times);
    if (st == FMB_OK)
        put_at(g, away, n, times);
    free(away);
    return st;
}

static void clear(placed *g)
{
    study_pairs_free(&g->drawn);
    fmb_pair_free(g->k);
    free(g->place);
    free(g->verdict);
}

static fmb_status make(const scaling_class *c, const qualify_setup *o, size_t n, placed *g)
{
    const study_pair_plan plan = {.family = STUDY_PAIR_ARTICLE,
                                  .dim = c->dim,
                                  .moves = c->moves,
                                  .shape = {(int)c->shape[0], (int)c->shape[1]}};
    fmb_pair_options options = {.size = sizeof options};
    options.simd = o->simd;
    fmb_status st = fmb_pair_new(c->dim, &options, NULL, &g->k);
    if (st == FMB_OK)
        st = study_pairs_make(&plan, o->seed, n, NULL, NULL, &g->drawn);
    return st == FMB_OK ? place(g) : st;
}

/* ---- right or wrong -------------------------------------------------------------------------- */

/* [give, fmb_system_free] */
static fmb_status system_of(const placed *g, size_t i, fmb_system **s)
{
    const fmb_frame pair[2] = {g->drawn.p[i], g->drawn.q[i]};
    return fmb_system_from_frames(pair, 2, FMB_COORDINATES_LAST, FMB_CONTACT_CLOSED, NULL, s);
}

/* All verdicts against the oracle, whose evidence the checker accepted. */
static fmb_status check_verdicts(const placed *g, scaling_cell *out)
{
    study_reference judge;
    fmb_status st = study_reference_open(&judge, 0);
    for (size_t i = 0; st == FMB_OK && i < g->drawn.n && out->complete; i++) {
        fmb_system *s = NULL;
        fmb_verdict truth = FMB_UNKNOWN;
        out->complete = qualify_watch_step_within(NULL, i, 2 * g->drawn.n);
        st = system_of(g, i, &s);
        if (st == FMB_OK)
            st = study_reference_verdict(&judge, s, &truth);
        fmb_system_free(s);
        out->wrong += st == FMB_OK && truth != g->verdict[i];
        out->checked++;
    }
    out->wrong += judge.rejected;
    study_reference_close(&judge);
    return st;
}

/* Does the default box hold the exact one, and exceed it by no more than allowed? */
static fmb_status check_box(const placed *g, fmb_pair *tightest, size_t i, bool *good)
{
    const fmb_frame *p = &g->drawn.p[i], *q = &g->drawn.q[i];
    double usual[2 * SCALING_MOST_DIM], tight[2 * SCALING_MOST_DIM];
    double scale = fmax(study_aabb_scale(p), study_aabb_scale(q));
    fmb_verdict verdict;
    fmb_status st = fmb_pair_test(
        g->k, 1, p, q,
        &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &verdict, .world = usual});
    if (st == FMB_OK)
        st = fmb_pair_test(tightest, 1, p, q,
                           &(fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                                               .verdict = &verdict,
                                               .world = tight});
    *good = st == FMB_OK && study_aabb_holds(p->dim, usual, tight, 0) &&
            study_aabb_holds(p->dim, tight, usual, allowed * scale);
    return st;
}

static fmb_status check_boxes(const placed *g, scaling_cell *out)
{
    fmb_pair_options o = {.size = sizeof o};
    fmb_pair *tightest = NULL;
    o.tightest = true;
    fmb_status st = fmb_pair_new(out->class.dim, &o, NULL, &tightest);
    for (size_t i = 0; st == FMB_OK && i < g->drawn.n && out->boxes < some_of(g); i++) {
        bool good;
        if (g->verdict[i] != FMB_FEASIBLE)
            continue;
        st = check_box(g, tightest, i, &good);
        out->boxes++;
        out->bad_boxes += !good;
    }
    fmb_pair_free(tightest);
    return st;
}

/* ---- counts and times ------------------------------------------------------------------------ */

/* Rows that exact elimination makes. */
static fmb_status count_rows(const placed *g, scaling_cell *out)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    size_t n = some_of(g);
    double rows = 0;
    o.method = FMB_METHOD_FM;
    fmb_status st = fmb_solver_new(&o, NULL, &v);
    for (size_t i = 0; st == FMB_OK && i < n; i++) {
        fmb_system *s = NULL;
        fmb_result res = {.size = sizeof res};
        st = system_of(g, i, &s);
        if (st == FMB_OK)
            st = fmb_solve(v, s, &res);
        if (st == FMB_OK)
            rows += (double)res.stats.rows_made;
        fmb_system_free(s);
    }
    fmb_solver_free(v);
    out->rows = rows / (double)n;
    return st;
}

static fmb_status run(void *self, size_t first, size_t n)
{
    placed *g = self;
    return fmb_pair_test(
        g->k, n, g->drawn.p + first, g->drawn.q + first,
        &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = g->verdict + first});
}

static study_clock clock_of(const study_timed *way, size_t ways, size_t n, int passes)
{
    return (study_clock){.way = way,
                         .ways = ways,
                         .queries = n,
                         .groups = 1,
                         .passes = passes,
                         .max_seconds = 0.5,
                         .step = qualify_watch_step_within};
}

static fmb_status time_verdicts(placed *g, int passes, scaling_cell *out)
{
    const study_timed way = {run, g};
    study_clock clock = clock_of(&way, 1, g->drawn.n, passes);
    fmb_pair_counts before = {.size = sizeof before}, after = {.size = sizeof after};
    fmb_status st = fmb_pair_count(g->k, &before);
    if (st == FMB_OK)
        st = study_clock_run(&clock);
    if (st == FMB_OK)
        st = fmb_pair_count(g->k, &after);
    if (st != FMB_OK)
        return st;
    out->exact_share = (double)(after.exact_verdicts - before.exact_verdicts) /
                       (double)(after.pairs - before.pairs);
    out->ns = study_clock_ns(&clock, 0);
    out->complete = clock.complete > 0;
    study_clock_clear(&clock);
    return FMB_OK;
}

static fmb_status time_programs(placed *g, int passes, scaling_cell *out)
{
    size_t n = g->drawn.n < LP_PAIRS ? g->drawn.n : LP_PAIRS;
    fmb_verdict *said = app_need(calloc(n, sizeof *said));
    scaling_lp *lp = scaling_lp_open(n, g->drawn.p, g->drawn.q, said);
    fmb_status st = FMB_OK;
    if (lp) {
        const study_timed way[2] = {{run, g}, {scaling_lp_run, lp}};
        study_clock clock = clock_of(way, 2, n, passes);
        st = study_clock_run(&clock);
        if (st == FMB_OK) {
            out->beside_lp_ns = study_clock_ns(&clock, 0);
            out->lp_ns = study_clock_ns(&clock, 1);
            out->over_lp = study_clock_ratio(&clock, 0, 1);
            out->complete = out->complete && clock.complete > 0;
            study_clock_clear(&clock);
        }
        for (size_t i = 0; i < n; i++)
            out->lp_wrong += said[i] != g->verdict[i];
        out->lp_pairs = n;
    }
    scaling_lp_close(lp);
    free(said);
    return st;
}

int scaling_measure(const scaling_class *c, const qualify_setup *o, size_t pairs, scaling_cell *out)
{
    const study_spread nothing = {NAN, NAN, NAN};
    placed g = {0};
    *out = (scaling_cell){.class = *c,
                          .pairs = pairs,
                          .lp_ns = nothing,
                          .beside_lp_ns = nothing,
                          .over_lp = study_ratio_of_medians(NULL, NULL, 0)};
    fmb_status st = make(c, o, pairs, &g);
    if (st == FMB_OK)
        st = time_verdicts(&g, o->passes, out);
    if (st == FMB_OK && out->complete)
        st = time_programs(&g, o->passes, out);
    out->meeting = st == FMB_OK ? count_meeting(&g, pairs) : 0;
    if (st == FMB_OK && out->complete)
        st = check_verdicts(&g, out);
    if (st == FMB_OK && out->complete)
        st = check_boxes(&g, out);
    if (st == FMB_OK && out->complete)
        st = count_rows(&g, out);
    clear(&g);
    return st == FMB_OK ? APP_YES : app_status_error(st);
}
