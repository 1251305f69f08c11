/* measure.c: see measure.h. */
#include "fmb-qualify/peers/measure.h"

#include <math.h>
#include <stdlib.h>

#include "common/message.h"
#include "fmb-qualify/verdicts/pool.h"
#include "fmb-qualify/watch.h"
#include "study/rivals/rows.h"

enum { MOST_JUDGED = 4096 }; /* pairs of each kind and family */

const fmb_shape peers_shape[PEERS_KINDS][2] = {{FMB_CUBOID, FMB_CUBOID},
                                               {FMB_CUBOID, FMB_SIMPLEX},
                                               {FMB_SIMPLEX, FMB_SIMPLEX},
                                               {FMB_CUBOID, FMB_CUBOID}};
const study_pair_family peers_family[PEERS_FAMILIES] = {STUDY_PAIR_ARTICLE, STUDY_PAIR_NEAR,
                                                        STUDY_PAIR_LATTICE, STUDY_PAIR_FLAT};

static bool takes(const peer_driver *d, int kind)
{
    return d->takes == PEER_TAKES_ALL ||
           (d->takes == PEER_TAKES_SIMPLICES && peers_shape[kind][0] == FMB_SIMPLEX) ||
           (d->takes == PEER_TAKES_BOXES && kind == PEERS_BOXES);
}

static study_pair_plan plan_of(study_pair_family family, int kind)
{
    return (study_pair_plan){.family = family,
                             .dim = 3,
                             .shape = {(int)peers_shape[kind][0], (int)peers_shape[kind][1]}};
}

static fmb_status ask_exactly(fmb_pair *k, const fmb_frame *p, const fmb_frame *q, fmb_verdict *out)
{
    *out = FMB_UNKNOWN;
    return fmb_pair_test(k, 1, p, q,
                         &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = out});
}

/* ---- times ----------------------------------------------------------------------------------- */

/* Gram-Schmidt: right angles, up to rounding; the first axis is unchanged. */
static void make_right_angles(int dim, double *axes)
{
    for (int k = 1; k < dim; k++)
        for (int i = 0; i < k; i++) {
            const double *a = axes + i * dim;
            double *b = axes + k * dim, along = 0, square = 0;
            for (int j = 0; j < dim; j++) {
                along += a[j] * b[j];
                square += a[j] * a[j];
            }
            for (int j = 0; j < dim; j++)
                b[j] -= along / square * a[j];
        }
}

static void make_boxes(const void *self, int dim, const verdict_draft f[2])
{
    (void)self;
    make_right_angles(dim, f[0].axes);
    make_right_angles(dim, f[1].axes);
}

static fmb_status draw_class(int kind, bool meets, uint64_t seed, size_t n, verdict_pool *out)
{
    static const verdict_kind KIND[PEERS_KINDS] = {VERDICT_CC, VERDICT_CT, VERDICT_TT, VERDICT_CC};
    const verdict_class c = {3, false, meets, KIND[kind]};
    const verdict_source from = {.reshape = kind == PEERS_BOXES ? make_boxes : NULL};
    fmb_pair *judge = NULL;
    fmb_status st = fmb_pair_new(3, NULL, NULL, &judge);
    if (st == FMB_OK)
        st = verdict_pool_make(&from, &c, seed, n, judge, out);
    fmb_pair_free(judge);
    return st;
}

/* A driver while it is timed. */
typedef struct runner {
    const peer_driver *driver;
    void *self;
    fmb_verdict *verdict; /* [n] */
} runner;

static fmb_status run(void *self, size_t first, size_t n)
{
    runner *r = self;
    return r->driver->ask(r->self, first, n, r->verdict + first);
}

static void close_all(runner *r, size_t ways)
{
    for (size_t i = 0; i < ways; i++)
        if (r[i].self)
            r[i].driver->close(r[i].self);
}

/* Opens the drivers that take this kind, in their order; which[] are their numbers. */
static fmb_status open_all(const peer_driver *const *driver, size_t drivers, int kind,
                           const peer_work *w, runner *r, size_t *which, size_t *ways)
{
    fmb_status st = FMB_OK;
    *ways = 0;
    for (size_t i = 0; st == FMB_OK && i < drivers; i++) {
        if (!takes(driver[i], kind))
            continue;
        r[*ways] = (runner){driver[i], NULL, r[*ways].verdict};
        which[*ways] = i;
        st = driver[i]->open(w, &r[*ways].self);
        ++*ways;
    }
    return st;
}

static fmb_status time_all(runner *r, const size_t *which, size_t ways, size_t n, int passes,
                           peers_times *out)
{
    study_timed way[PEERS_MOST];
    for (size_t i = 0; i < ways; i++)
        way[i] = (study_timed){run, &r[i]};
    study_clock clock = {.way = way,
                         .ways = ways,
                         .queries = n,
                         .groups = 1,
                         .passes = passes,
                         .max_seconds = 8,
                         .step = qualify_watch_step_within};
    fmb_status st = study_clock_run(&clock);
    if (st != FMB_OK)
        return st;
    out->complete = clock.complete > 0;
    for (size_t i = 0; i < ways; i++) {
        out->ns[which[i]] = study_clock_ns(&clock, i);
        out->ratio[which[i]] = study_clock_ratio(&clock, i, 0);
    }
    study_clock_clear(&clock);
    return FMB_OK;
}

static fmb_status count_wrong(runner *r, size_t n, fmb_verdict right, size_t *out)
{
    fmb_status st = run(r, 0, n);
    for (size_t i = 0; st == FMB_OK && i < n; i++)
        *out += r->verdict[i] != right;
    return st;
}

int peers_time(const peer_driver *const *driver, size_t drivers, int kind, bool meets,
               const qualify_setup *o, peers_times *out)
{
    const study_spread nothing = {NAN, NAN, NAN};
    runner r[PEERS_MOST] = {{0}};
    size_t which[PEERS_MOST], ways = 0;
    verdict_pool pairs = {0};
    *out = (peers_times){.pairs = o->pairs};
    for (size_t i = 0; i < drivers; i++) {
        out->ns[i] = nothing;
        out->ratio[i] = study_ratio_of_medians(NULL, NULL, 0);
    }
    fmb_verdict *verdict = app_need(malloc(o->pairs * sizeof *verdict));
    for (size_t i = 0; i < drivers; i++)
        r[i].verdict = verdict;
    fmb_status st = draw_class(kind, meets, o->seed, o->pairs, &pairs);
    const peer_work work = {pairs.n, pairs.p, pairs.q, o->simd};
    if (st == FMB_OK)
        st = open_all(driver, drivers, kind, &work, r, which, &ways);
    if (st == FMB_OK)
        st = time_all(r, which, ways, pairs.n, o->passes, out);
    for (size_t i = 0; st == FMB_OK && out->complete && i < ways; i++)
        st = count_wrong(&r[i], pairs.n, meets ? FMB_FEASIBLE : FMB_INFEASIBLE,
                         &out->wrong[which[i]]);
    close_all(r, ways);
    verdict_pool_free(&pairs);
    free(verdict);
    return st == FMB_OK ? APP_YES : app_status_error(st);
}

/* ---- right or wrong -------------------------------------------------------------------------- */

/* Frames with a volume: others need them. */
static bool is_solid(void *self, const fmb_frame *p, const fmb_frame *q)
{
    study_rows s;
    (void)self;
    return study_rows_make(p, q, 0, &s) && study_rows_make(q, p, 0, &s);
}

static void note(peers_faults *f, size_t i, fmb_verdict closed, fmb_verdict open, fmb_verdict said)
{
    if (closed != open) {
        f->touching[i]++;
        f->touching_meet[i] += said == FMB_FEASIBLE;
        return;
    }
    f->clear[i]++;
    f->unknown[i] += said == FMB_UNKNOWN;
    f->false_meet[i] += said == FMB_FEASIBLE && closed == FMB_INFEASIBLE;
    f->false_apart[i] += said == FMB_INFEASIBLE && closed == FMB_FEASIBLE;
}

/* The exact verdicts of n pairs, with and without faces: [2 n]. */
static fmb_status find_truth(const peer_work *w, fmb_verdict *truth)
{
    fmb_pair_options o = {.size = sizeof o};
    fmb_status st = FMB_OK;
    o.method = FMB_PAIR_EXACT;
    for (int contact = 0; st == FMB_OK && contact < 2; contact++) {
        fmb_pair *k = NULL;
        o.contact = (fmb_contact)contact;
        st = fmb_pair_new(3, &o, NULL, &k);
        for (size_t i = 0; st == FMB_OK && i < w->n; i++) {
            truth[(size_t)contact * w->n + i] = FMB_UNKNOWN;
            if (qualify_watch_step_within(NULL, (size_t)contact * w->n + i, 2 * w->n))
                st = ask_exactly(k, &w->p[i], &w->q[i], &truth[(size_t)contact * w->n + i]);
        }
        fmb_pair_free(k);
    }
    return st;
}

static fmb_status judge_one(const peer_driver *driver, size_t i, const peer_work *w,
                            const fmb_verdict *truth, fmb_verdict *said, peers_faults *out)
{
    void *self = NULL;
    fmb_status st = driver->open(w, &self);
    if (st == FMB_OK)
        st = driver->ask(self, 0, w->n, said);
    if (self)
        driver->close(self);
    for (size_t k = 0; st == FMB_OK && k < w->n; k++)
        note(out, i, truth[k], truth[w->n + k], said[k]);
    return st;
}

static fmb_status judge_kind(const peer_driver *const *driver, size_t drivers,
                             study_pair_family family, int kind, const qualify_setup *o,
                             peers_faults *out)
{
    const study_pair_plan plan = plan_of(family, kind);
    size_t n = o->pairs < MOST_JUDGED ? o->pairs : MOST_JUDGED;
    fmb_verdict *truth = app_need(malloc(3 * n * sizeof *truth));
    study_pairs pairs = {0};
    fmb_status st = study_pairs_make(&plan, o->seed, n, is_solid, NULL, &pairs);
    const peer_work work = {pairs.n, pairs.p, pairs.q, o->simd};
    if (st == FMB_OK)
        st = find_truth(&work, truth);
    out->complete = !qualify_watch_interrupted();
    for (size_t i = 0; st == FMB_OK && out->complete && i < drivers; i++)
        if (takes(driver[i], kind))
            st = judge_one(driver[i], i, &work, truth, truth + 2 * n, out);
    study_pairs_free(&pairs);
    free(truth);
    return st;
}

int peers_judge(const peer_driver *const *driver, size_t drivers, study_pair_family family,
                const qualify_setup *o, peers_faults *out)
{
    fmb_status st = FMB_OK;
    *out = (peers_faults){.complete = true};
    for (int kind = 0; st == FMB_OK && out->complete && kind < PEERS_BOXES; kind++)
        st = judge_kind(driver, drivers, family, kind, o, out);
    return st == FMB_OK ? APP_YES : app_status_error(st);
}
