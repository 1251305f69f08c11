/* cell.c: one cell of Table 1, measured; see article.h. */
#include <math.h>
#include <stdlib.h>

#include <fmb/frames.h>

#include "fmb-qualify/article/article.h"
#include "fmb-qualify/watch.h"
#include "study/rivals/article.h"
#include "study/rivals/sat_plain.h"

enum {
    REPEATED_PAIRS = 512,
    MOST_REPEATS = 1500, /* the article's, in the plane */
    REPEATED_NS = 50000, /* one reading of the clock costs about 1000 ns at worst */
    MORE_PASSES = 8      /* of ours, which are much shorter than the article's */
};

/* The pairs of a cell, and everything needed to answer them. */
typedef struct bench {
    verdict_pool pool;
    verdict_rivals ours;
    study_article *listing;
    study_sat_records_meet *program;
    study_sat_record *record[2]; /* [n] the pool's frames in the format of the article's SAT */
    fmb_frames *a, *b;           /* and ours */
    fmb_frames_pair *number;     /* [n] pair i: frame i of each */
    fmb_verdict *verdict;        /* [2][n] FMB, SAT */
    int repeats;
} bench;

/* One way over the pairs: the self of a study_timed. */
typedef struct asker {
    bench *of;
    fmb_pair *k;
    fmb_verdict *verdict;
} asker;

/* ---- the ways -------------------------------------------------------------------------------- */

static fmb_status run_listed_fmb(void *self, size_t first, size_t n)
{
    asker *s = self;
    const verdict_pool *pool = &s->of->pool;
    fmb_status st = FMB_OK;
    for (size_t i = first; i < first + n; i++)
        for (int r = 0; st == FMB_OK && r < s->of->repeats; r++)
            st = study_article_test(s->of->listing, &pool->p[i], &pool->q[i],
                                    STUDY_ARTICLE_PUBLISHED, NULL, &s->verdict[i]);
    return st;
}

static fmb_status run_listed_sat(void *self, size_t first, size_t n)
{
    asker *s = self;
    study_sat_record *const *record = s->of->record;
    study_sat_records_meet *meet = s->of->program;
    for (size_t i = first; i < first + n; i++)
        for (int r = 0; r < s->of->repeats; r++)
            s->verdict[i] = meet(&record[0][i], &record[1][i]) ? FMB_FEASIBLE : FMB_INFEASIBLE;
    return FMB_OK;
}

static fmb_status run_asked(void *self, size_t first, size_t n)
{
    asker *s = self;
    verdict_way way = {s->k, s->of->pool.p, s->of->pool.q, s->verdict};
    return verdict_way_all(&way, first, n);
}

static fmb_status run_packed(void *self, size_t first, size_t n)
{
    asker *s = self;
    return fmb_frames_test(
        s->k, s->of->a, s->of->b, n, s->of->number + first,
        &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = s->verdict + first});
}

/* ---- measuring ------------------------------------------------------------------------------- */

static size_t count_wrong_verdicts(const article_cell *cell, const fmb_verdict *verdict)
{
    fmb_verdict right = cell->class.meets ? FMB_FEASIBLE : FMB_INFEASIBLE;
    size_t wrong = 0;
    for (size_t i = 0; i < cell->queries; i++)
        wrong += verdict[i] != right;
    return wrong;
}

/* FMB and SAT in turn, with nothing else between: each finds the caches as the other left them. */
static fmb_status time_duel(bench *b, article_way way, const qualify_setup *o, article_cell *cell)
{
    static fmb_status (*const RUN[ARTICLE_WAYS][2])(void *, size_t, size_t) = {
        [ARTICLE_LISTED] = {run_listed_fmb, run_listed_sat},
        [ARTICLE_ASKED] = {run_asked, run_asked},
        [ARTICLE_PACKED] = {run_packed, run_packed}};
    asker self[2] = {{b, b->ours.fmb, b->verdict}, {b, b->ours.sat, b->verdict + cell->queries}};
    const study_timed rival[2] = {{RUN[way][0], &self[0]}, {RUN[way][1], &self[1]}};
    article_duel *d = &cell->duel[way];
    int passes = way == ARTICLE_LISTED ? o->passes : MORE_PASSES * o->passes;
    passes = passes < STUDY_CLOCK_MOST_PASSES ? passes : STUDY_CLOCK_MOST_PASSES;
    study_clock c = {.way = rival,
                     .ways = 2,
                     .queries = cell->queries,
                     .groups = 1,
                     .passes = passes,
                     .step = qualify_watch_step_within};
    b->repeats = 1;
    fmb_status st = study_clock_run(&c);
    cell->complete &= c.complete == passes;
    d->fmb = study_clock_ns(&c, 0);
    d->sat = study_clock_ns(&c, 1);
    d->fmb_sat = study_clock_ratio(&c, 0, 1);
    d->wrong =
        count_wrong_verdicts(cell, self[0].verdict) + count_wrong_verdicts(cell, self[1].verdict);
    study_clock_clear(&c);
    return st;
}

/* The time of way for a query of a group, the median of the passes [ns]. */
static double median_of_passes(const study_clock *c, int repeats, size_t way, size_t group)
{
    double x[STUDY_CLOCK_MOST_PASSES];
    for (size_t pass = 0; pass < (size_t)c->complete; pass++)
        x[pass] = c->seconds[(pass * c->ways + way) * c->groups + group];
    return 1e9 * study_spread_of(x, (size_t)c->complete).median / repeats;
}

static void conclude_repeated(const study_clock *c, const bench *b, article_repeated *r)
{
    double pairs[2] = {0, 0}, sum[2] = {0, 0};
    r->least = INFINITY;
    for (size_t i = 0; i < r->pairs; i++) {
        double fmb = median_of_passes(c, b->repeats, 0, i), n = (double)r->pairs;
        double sat = median_of_passes(c, b->repeats, 1, i);
        int first = b->pool.p[i].shape == FMB_SIMPLEX;
        pairs[first]++;
        sum[first] += fmb / sat;
        r->fmb += fmb / n;
        r->sat += sat / n;
        r->best += fmin(fmb, sat) / n;
        r->mean += fmb / sat / n;
        r->least = fmin(r->least, fmb / sat);
        r->most = fmax(r->most, fmb / sat);
    }
    for (int first = 0; first < 2; first++)
        r->first[first] = sum[first] / pairs[first];
}

static fmb_status time_repeated_pairs(bench *b, const qualify_setup *o, article_cell *cell)
{
    asker self = {b, NULL, b->verdict};
    const study_timed way[] = {{run_listed_fmb, &self}, {run_listed_sat, &self}};
    size_t n = cell->queries < REPEATED_PAIRS ? cell->queries : REPEATED_PAIRS;
    study_clock c = {.way = way,
                     .ways = 2,
                     .queries = n,
                     .groups = n,
                     .passes = o->passes,
                     .step = qualify_watch_step_within};
    const article_duel *listed = &cell->duel[ARTICLE_LISTED];
    double once = fmax(fmin(listed->fmb.median, listed->sat.median), 1);
    b->repeats = (int)fmax(1, fmin(MOST_REPEATS, REPEATED_NS / once));
    fmb_status st = study_clock_run(&c);
    cell->complete &= c.complete == o->passes;
    cell->repeated = (article_repeated){.pairs = n};
    if (st == FMB_OK && cell->complete)
        conclude_repeated(&c, b, &cell->repeated);
    study_clock_clear(&c);
    return st;
}

/* ---- a cell ---------------------------------------------------------------------------------- */

static fmb_status bench_open(const verdict_class *c, const qualify_setup *o, bench *b)
{
    size_t n = o->pairs;
    b->number = malloc(n * sizeof *b->number);
    b->verdict = calloc(2 * n, sizeof *b->verdict);
    b->program = study_sat_program(c->dim, c->moves);
    for (int side = 0; side < 2; side++)
        b->record[side] = malloc(n * sizeof *b->record[side]);
    if (!b->number || !b->verdict || !b->record[0] || !b->record[1])
        return FMB_ERR_MEMORY;
    for (size_t i = 0; i < n; i++)
        b->number[i] = (fmb_frames_pair){(uint32_t)i, (uint32_t)i};
    fmb_status st = verdict_rivals_open(&b->ours, c->dim, o->simd);
    if (st == FMB_OK)
        st = study_article_new(&b->listing);
    if (st == FMB_OK)
        st = verdict_pool_make(&(verdict_source){0}, c, o->seed, n, b->ours.fmb, &b->pool);
    for (size_t i = 0; st == FMB_OK && i < n; i++) {
        study_sat_record_make(&b->pool.p[i], &b->record[0][i]);
        study_sat_record_make(&b->pool.q[i], &b->record[1][i]);
    }
    if (st == FMB_OK)
        st = fmb_frames_new(c->dim, n, b->pool.p, NULL, &b->a);
    return st == FMB_OK ? fmb_frames_new(c->dim, n, b->pool.q, NULL, &b->b) : st;
}

static void bench_close(bench *b)
{
    fmb_frames_free(b->a);
    fmb_frames_free(b->b);
    verdict_pool_free(&b->pool);
    study_article_free(b->listing);
    verdict_rivals_close(&b->ours);
    free(b->record[0]);
    free(b->record[1]);
    free(b->number);
    free(b->verdict);
}

fmb_status article_cell_run(const verdict_class *c, const qualify_setup *o, article_cell *out)
{
    bench b = {0};
    *out = (article_cell){.class = *c, .queries = o->pairs, .complete = true};
    fmb_status st = bench_open(c, o, &b);
    out->drawn = b.pool.drawn;
    for (int way = 0; st == FMB_OK && way < ARTICLE_WAYS && !qualify_watch_interrupted(); way++)
        st = time_duel(&b, (article_way)way, o, out);
    if (st == FMB_OK && !qualify_watch_interrupted())
        st = time_repeated_pairs(&b, o, out);
    out->complete &= !qualify_watch_interrupted();
    bench_close(&b);
    return st;
}
