/* duel.c: see duel.h. */
#include "fmb-qualify/verdicts/duel.h"

#include <stdlib.h>

#include "fmb-qualify/watch.h"
#include "study/rivals/sat_plain.h"
#include "study/sat/sat.h"

enum {
    WARM_LEAST = 16,   /* pairs, */
    WARM_SHARE = 64,   /* and one in so many */
    WARM_REPEATS = 256 /* makes reading the clock less than 1 % of a group */
};

fmb_status verdict_rivals_open(verdict_rivals *r, int dim, fmb_simd simd)
{
    fmb_pair_options o = {.size = sizeof o};
    o.simd = simd;
    *r = (verdict_rivals){NULL, NULL};
    fmb_status st = fmb_pair_new(dim, &o, NULL, &r->fmb);
    return st == FMB_OK ? study_sat_new(dim, &o, &r->sat) : st;
}

void verdict_rivals_close(verdict_rivals *r)
{
    fmb_pair_free(r->fmb);
    fmb_pair_free(r->sat);
}

/* ---- the ways -------------------------------------------------------------------------------- */

fmb_status verdict_way_all(void *self, size_t first, size_t n)
{
    verdict_way *w = self;
    return fmb_pair_test(
        w->k, n, w->p + first, w->q + first,
        &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = w->verdict + first});
}

static fmb_status one_by_one(void *self, size_t first, size_t n)
{
    fmb_status st = FMB_OK;
    for (size_t i = first; st == FMB_OK && i < first + n; i++)
        st = verdict_way_all(self, i, 1);
    return st;
}

static fmb_status warm(void *self, size_t first, size_t n)
{
    fmb_status st = FMB_OK;
    for (size_t i = first; st == FMB_OK && i < first + n; i++)
        for (int repeat = 0; st == FMB_OK && repeat < WARM_REPEATS; repeat++)
            st = verdict_way_all(self, i, 1);
    return st;
}

static fmb_status plainly(void *self, size_t first, size_t n)
{
    verdict_way *w = self;
    for (size_t i = first; i < first + n; i++)
        w->verdict[i] = study_sat_plain(&w->p[i], &w->q[i]) ? FMB_FEASIBLE : FMB_INFEASIBLE;
    return FMB_OK;
}

/* ---- the duel -------------------------------------------------------------------------------- */

static size_t count_wrong(const verdict_duel *d, const fmb_verdict *verdict)
{
    fmb_verdict right = d->class.meets ? FMB_FEASIBLE : FMB_INFEASIBLE;
    size_t wrong = 0;
    for (size_t i = 0; i < d->queries; i++)
        wrong += verdict[i] != right;
    return wrong;
}

static double share(fmb_pair_counts before, fmb_pair_counts after)
{
    return (double)(after.exact_verdicts - before.exact_verdicts) /
           (double)(after.pairs - before.pairs);
}

/* In one call, and a call for each pair. */
static fmb_status run_cold(const verdict_pool *pool, const qualify_setup *o,
                           const verdict_rivals *r, fmb_verdict *verdict, verdict_duel *d)
{
    enum { FMB, SAT, PLAIN, ONE_FMB, ONE_SAT, WAYS };
    verdict_way self[] = {{r->fmb, pool->p, pool->q, verdict},
                          {r->sat, pool->p, pool->q, verdict + pool->n},
                          {NULL, pool->p, pool->q, verdict + 2 * pool->n}};
    const study_timed way[WAYS] = {[FMB] = {verdict_way_all, &self[0]},
                                   [SAT] = {verdict_way_all, &self[1]},
                                   [PLAIN] = {plainly, &self[2]},
                                   [ONE_FMB] = {one_by_one, &self[0]},
                                   [ONE_SAT] = {one_by_one, &self[1]}};
    study_clock c = {.way = way,
                     .ways = WAYS,
                     .queries = pool->n,
                     .groups = 1,
                     .passes = o->passes,
                     .step = qualify_watch_step_within};
    fmb_pair_counts before = {.size = sizeof before}, after = {.size = sizeof after};
    fmb_status st = fmb_pair_count(r->fmb, &before);
    if (st == FMB_OK)
        st = study_clock_run(&c);
    if (st == FMB_OK)
        st = fmb_pair_count(r->fmb, &after);
    d->exact_share = share(before, after);
    d->complete = c.complete == o->passes;
    d->fmb = study_clock_ns(&c, FMB);
    d->sat = study_clock_ns(&c, SAT);
    d->plain = study_clock_ns(&c, PLAIN);
    d->fmb_sat = study_clock_ratio(&c, FMB, SAT);
    d->plain_sat = study_clock_ratio(&c, PLAIN, SAT);
    d->one_fmb = study_clock_ns(&c, ONE_FMB);
    d->one_sat = study_clock_ns(&c, ONE_SAT);
    d->one_fmb_sat = study_clock_ratio(&c, ONE_FMB, ONE_SAT);
    d->wrong = count_wrong(d, verdict) + count_wrong(d, verdict + pool->n);
    d->plain_wrong = count_wrong(d, verdict + 2 * pool->n);
    study_clock_clear(&c);
    return st;
}

static study_spread of_one(study_spread s)
{
    return (study_spread){s.least / WARM_REPEATS, s.median / WARM_REPEATS, s.most / WARM_REPEATS};
}

/* As in the article: the same pair again and again, one pair in each group. */
static fmb_status run_warm(const verdict_pool *pool, const qualify_setup *o,
                           const verdict_rivals *r, fmb_verdict *verdict, verdict_duel *d)
{
    verdict_way self[] = {{r->fmb, pool->p, pool->q, verdict}, {r->sat, pool->p, pool->q, verdict}};
    const study_timed way[] = {{warm, &self[0]}, {warm, &self[1]}};
    size_t some = WARM_LEAST + pool->n / WARM_SHARE;
    d->warm_pairs = pool->n < some ? pool->n : some;
    study_clock c = {.way = way,
                     .ways = 2,
                     .queries = d->warm_pairs,
                     .groups = d->warm_pairs,
                     .passes = o->passes,
                     .step = qualify_watch_step_within};
    fmb_status st = study_clock_run(&c);
    d->complete &= c.complete == o->passes;
    if (st == FMB_OK)
        st = study_clock_group_ns(&c, 0, &d->warm_fmb);
    if (st == FMB_OK)
        st = study_clock_group_ns(&c, 1, &d->warm_sat);
    if (st == FMB_OK)
        st = study_clock_group_ratio(&c, 0, 1, &d->warm_fmb_sat);
    d->warm_fmb = of_one(d->warm_fmb);
    d->warm_sat = of_one(d->warm_sat);
    study_clock_clear(&c);
    return st;
}

fmb_status verdict_duel_run(const verdict_source *from, const verdict_class *c,
                            const qualify_setup *o, verdict_rivals *r, verdict_duel *out)
{
    verdict_pool pool = {0};
    *out = (verdict_duel){.class = *c, .queries = o->pairs};
    fmb_verdict *verdict = calloc(3 * o->pairs, sizeof *verdict);
    fmb_status st =
        verdict ? verdict_pool_make(from, c, o->seed, o->pairs, r->fmb, &pool) : FMB_ERR_MEMORY;
    out->drawn = pool.drawn;
    if (st == FMB_OK && !qualify_watch_interrupted())
        st = run_cold(&pool, o, r, verdict, out);
    if (st == FMB_OK && !qualify_watch_interrupted())
        st = run_warm(&pool, o, r, verdict, out);
    out->complete &= !qualify_watch_interrupted();
    verdict_pool_free(&pool);
    free(verdict);
    return st;
}
