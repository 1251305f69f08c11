/* mix.c: FMB over SAT by the share of meeting pairs; see duel.h. */
#include <stdlib.h>

#include <gsl/gsl_randist.h>

#include "fmb-qualify/verdicts/duel.h"
#include "fmb-qualify/watch.h"

enum { GROUP = 1024 }; /* pairs; reading the clock is less than 1 % of it */

/* A sequence of pairs of which a share meets. */
typedef struct sequence {
    size_t n;
    fmb_frame *p, *q;     /* [n] */
    fmb_verdict *verdict; /* [n] */
    unsigned char *meets; /* [n] */
} sequence;

static fmb_status sequence_open(sequence *s, size_t n)
{
    *s = (sequence){n, calloc(n, sizeof *s->p), calloc(n, sizeof *s->q),
                    calloc(n, sizeof *s->verdict), calloc(n, sizeof *s->meets)};
    return s->p && s->q && s->verdict && s->meets ? FMB_OK : FMB_ERR_MEMORY;
}

static void sequence_close(sequence *s)
{
    free(s->p);
    free(s->q);
    free(s->verdict);
    free(s->meets);
}

/* step tenths of the pairs meet, at random places. */
static void sequence_fill(sequence *s, const verdict_pool *pool, int step, gsl_rng *g)
{
    size_t used[2] = {0, 0};
    for (size_t i = 0; i < s->n; i++)
        s->meets[i] = i * (VERDICT_SHARES - 1) < (size_t)step * s->n;
    gsl_ran_shuffle(g, s->meets, s->n, sizeof *s->meets);
    for (size_t i = 0; i < s->n; i++) {
        int meets = s->meets[i];
        size_t k = used[meets]++;
        s->p[i] = pool[meets].p[k];
        s->q[i] = pool[meets].q[k];
    }
}

static fmb_status time_share(const sequence *s, const qualify_setup *o, const verdict_rivals *r,
                             int step, verdict_mix *mix)
{
    verdict_way self[] = {{r->fmb, s->p, s->q, s->verdict}, {r->sat, s->p, s->q, s->verdict}};
    const study_timed way[] = {{verdict_way_all, &self[0]}, {verdict_way_all, &self[1]}};
    study_clock c = {.way = way,
                     .ways = 2,
                     .queries = s->n,
                     .groups = mix->groups,
                     .passes = o->passes,
                     .step = qualify_watch_step_within};
    fmb_status st = study_clock_run(&c);
    mix->complete &= c.complete == o->passes;
    mix->total[step] = study_clock_ratio(&c, 0, 1).ratio;
    if (st == FMB_OK)
        st = study_clock_group_ratio(&c, 0, 1, &mix->group[step]);
    study_clock_clear(&c);
    return st;
}

static fmb_status time_shares(const verdict_pool *pool, const qualify_setup *o,
                              const verdict_rivals *r, verdict_mix *mix)
{
    sequence s;
    gsl_rng *g = gsl_rng_alloc(gsl_rng_mt19937);
    fmb_status st = sequence_open(&s, o->pairs);
    if (!g)
        st = FMB_ERR_MEMORY;
    for (int step = 0; st == FMB_OK && mix->complete && step < VERDICT_SHARES; step++) {
        gsl_rng_set(g, (unsigned long)o->seed);
        sequence_fill(&s, pool, step, g);
        st = time_share(&s, o, r, step, mix);
    }
    if (g)
        gsl_rng_free(g);
    sequence_close(&s);
    return st;
}

fmb_status verdict_mix_run(const verdict_source *from, const qualify_setup *o, verdict_rivals *r,
                           verdict_mix *mix)
{
    verdict_pool pool[2] = {{0}, {0}};
    fmb_status st = FMB_OK;
    mix->queries = o->pairs;
    mix->groups = (o->pairs + GROUP - 1) / GROUP;
    for (int meets = 0; st == FMB_OK && meets < 2; meets++) {
        verdict_class c = {mix->dim, mix->moves, meets, VERDICT_ANY};
        st = verdict_pool_make(from, &c, o->seed, o->pairs, r->fmb, &pool[meets]);
    }
    mix->complete = st == FMB_OK && !qualify_watch_interrupted();
    if (mix->complete)
        st = time_shares(pool, o, r, mix);
    verdict_pool_free(&pool[0]);
    verdict_pool_free(&pool[1]);
    return st;
}
