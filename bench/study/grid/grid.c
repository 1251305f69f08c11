/* grid.c: see grid.h. */
#include "study/grid/grid.h"

#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

enum { MOST_PASSES = 10 }; /* with the one that does not count */

/* Time limit of the reference for one question [s]. */
static const double REFERENCE_SECONDS = 20;

/* The state of a running study. */
typedef struct bench {
    study_grid *g;
    study_reference reference;
    study_engine *engine; /* [ways] */
    size_t done, all;     /* steps */
} bench;

/* May the next query begin? v is the solver that it goes to. */
static bool go_on(bench *b, fmb_solver *v)
{
    if (b->g->running)
        *b->g->running = v;
    return !b->g->step || b->g->step(b->g->self, b->done++, b->all);
}

/* Systems are dealt to the shards in turn; those of other shards are drawn and skipped. */
static bool is_mine(const study_grid *g, size_t k, size_t i)
{
    return g->shards == 0 || (k + i) % g->shards == g->shard - 1;
}

/* ---- samples --------------------------------------------------------------------------------- */

fmb_status study_grid_add(study_grid *g, const study_sample *sample)
{
    if (g->samples == g->sample_capacity) {
        size_t capacity = g->sample_capacity ? 2 * g->sample_capacity : 64;
        study_sample *p = realloc(g->sample, capacity * sizeof *p);
        if (!p)
            return FMB_ERR_MEMORY;
        g->sample = p;
        g->sample_capacity = capacity;
    }
    g->sample[g->samples++] = *sample;
    return FMB_OK;
}

fmb_status study_sample_put(study_sample *sample, fmb_system *s, int *keep, int kept)
{
    if (sample->size == sample->capacity) {
        size_t capacity = sample->capacity ? 2 * sample->capacity : 8;
        study_case *p = realloc(sample->item, capacity * sizeof *p);
        if (!p) {
            fmb_system_free(s);
            free(keep);
            return FMB_ERR_MEMORY;
        }
        sample->item = p;
        sample->capacity = capacity;
    }
    sample->item[sample->size++] = (study_case){.s = s, .keep = keep, .kept = kept};
    return FMB_OK;
}

/* All but the last variable are eliminated. */
static fmb_status put_drawn(study_sample *sample, fmb_system *s, fmb_verdict truth)
{
    int *keep = malloc(sizeof *keep);
    if (!keep) {
        fmb_system_free(s);
        return FMB_ERR_MEMORY;
    }
    *keep = fmb_system_dim(s) - 1;
    fmb_status st = study_sample_put(sample, s, keep, 1);
    if (st == FMB_OK)
        sample->item[sample->size - 1].truth = truth;
    return st;
}

/* Draw until the sample is full of meeting or of disjoint pairs, as its class says. If that takes
 * more than a thousand draws for each wanted pair, the sample stays smaller. */
static fmb_status draw_sample(bench *b, study_sample *sample)
{
    size_t wanted = b->g->per_class, draws = 1000 * wanted;
    gsl_rng *rng = study_draw_begin(&sample->class, b->g->seed);
    fmb_status st = rng ? FMB_OK : FMB_ERR_MEMORY;
    while (st == FMB_OK && sample->size < wanted && draws-- > 0) {
        fmb_system *s = NULL;
        fmb_verdict truth;
        st = study_draw_pair(rng, &sample->class, &s);
        if (st == FMB_OK)
            st = study_reference_verdict(&b->reference, s, &truth);
        bool fits = st == FMB_OK && (truth == FMB_FEASIBLE) == sample->class.meets;
        if (fits)
            st = put_drawn(sample, s, truth);
        else
            fmb_system_free(s);
    }
    gsl_rng_free(rng);
    return st;
}

static fmb_status answer_sample(bench *b, size_t k)
{
    fmb_status st = FMB_OK;
    const study_sample *sample = &b->g->sample[k];
    for (size_t i = 0; st == FMB_OK && i < sample->size; i++) {
        study_case *c = &sample->item[i];
        if (!is_mine(b->g, k, i))
            continue;
        if (c->truth == FMB_UNKNOWN)
            st = study_reference_verdict(&b->reference, c->s, &c->truth);
        if (st == FMB_OK && !c->projection && c->keep)
            st = study_reference_projection(&b->reference, c->s, c->keep, c->kept, &c->projection);
    }
    return st;
}

static fmb_status prepare(bench *b)
{
    fmb_status st = FMB_OK;
    study_grid *g = b->g;
    g->most = 1;
    for (size_t k = 0; st == FMB_OK && k < g->samples; k++) {
        study_sample *sample = &g->sample[k];
        if (!go_on(b, b->reference.oracle))
            break;
        if (!sample->file)
            st = draw_sample(b, sample);
        if (st == FMB_OK)
            st = answer_sample(b, k);
        g->most = sample->size > g->most ? sample->size : g->most;
        g->prepared = k + 1;
    }
    return st;
}

/* ---- runs ------------------------------------------------------------------------------------ */

fmb_status study_case_count(study_reference *reference, study_engine *engine, const study_case *c,
                            study_run *run)
{
    fmb_system *projection;
    char *words = NULL;
    const int *keep = c->truth == FMB_INFEASIBLE ? NULL : c->keep;
    fmb_status st = study_engine_count(engine, c->s, keep, c->kept, run, &projection);
    bool decided = st == FMB_OK && run->outcome == STUDY_DECIDED;
    bool wrong = decided && c->truth != FMB_UNKNOWN && run->verdict != c->truth;
    if (decided && !wrong && projection && c->projection) {
        st = study_reference_words(reference, projection, &words);
        wrong = st == FMB_OK && words && strcmp(words, c->projection) != 0;
    }
    if (wrong)
        run->outcome = STUDY_WRONG;
    free(words);
    fmb_system_free(projection);
    return st;
}

/* How far a sample has come. */
typedef enum progress { ENDED, COMPLETE } progress;

static fmb_status count_sample(bench *b, size_t k, progress *how)
{
    const study_sample *sample = &b->g->sample[k];
    fmb_status st = FMB_OK;
    for (size_t w = 0; w < b->g->ways; w++)
        for (size_t i = 0; b->g->known[w] && i < sample->size; i++) {
            if (!is_mine(b->g, k, i))
                continue;
            if (!go_on(b, b->engine[w].counting))
                return FMB_OK;
            st = study_case_count(&b->reference, &b->engine[w], &sample->item[i],
                                  study_grid_at(b->g, k, i, w));
            if (st != FMB_OK)
                return st;
        }
    *how = COMPLETE;
    return FMB_OK;
}

size_t study_grid_turn(const study_grid *g, size_t sample, size_t pass, size_t place)
{
    size_t n = g->ways, row = sample + pass + g->turn;
    if (n % 2 == 1 && row / n % 2 == 1)
        place = n - 1 - place;
    return (row + (place % 2 == 1 ? (place + 1) / 2 : n - place / 2)) % n;
}

/* One pass of one way over all systems of a sample; a query that was stopped once is not repeated.
 * Infeasible systems are not projected. */
static fmb_status time_pass(bench *b, size_t k, size_t way, size_t pass, double *seconds,
                            progress *how)
{
    const study_sample *sample = &b->g->sample[k];
    fmb_status st = FMB_OK;
    *how = ENDED;
    for (size_t i = 0; st == FMB_OK && i < sample->size; i++) {
        study_run *run = study_grid_at(b->g, k, i, way);
        if (!is_mine(b->g, k, i))
            continue;
        if (!go_on(b, b->engine[way].timing))
            return FMB_OK;
        const study_case *c = &sample->item[i];
        const int *keep = b->g->projects && c->truth != FMB_INFEASIBLE ? c->keep : NULL;
        if (pass == 0 || run->solved == STUDY_DECIDED)
            st = study_engine_time(&b->engine[way], c->s, keep, c->kept, c->truth, run);
        seconds[(i * b->g->ways + way) * MOST_PASSES + pass] = run->seconds;
    }
    *how = COMPLETE;
    return st;
}

/* Every run of the sample takes the median of its passes but the first. */
static void take_medians(study_grid *g, size_t k, size_t passes, double *seconds)
{
    for (size_t i = 0; i < g->sample[k].size * g->ways; i++) {
        double *counted = seconds + i * MOST_PASSES + 1;
        gsl_sort(counted, 1, passes - 1);
        study_grid_at(g, k, 0, 0)[i].seconds =
            gsl_stats_median_from_sorted_data(counted, 1, passes - 1);
    }
}

static fmb_status time_sample(bench *b, size_t k, progress *how)
{
    study_grid *g = b->g;
    size_t passes = g->passes == 0                ? 0
                    : g->passes + 1 < MOST_PASSES ? (size_t)g->passes + 1
                                                  : MOST_PASSES;
    double *seconds = calloc(g->most * g->ways * MOST_PASSES, sizeof *seconds);
    fmb_status st = seconds ? FMB_OK : FMB_ERR_MEMORY;
    *how = COMPLETE;
    for (size_t pass = 0; pass < passes; pass++)
        for (size_t w = 0; st == FMB_OK && *how == COMPLETE && w < g->ways; w++) {
            size_t way = study_grid_turn(g, k, pass, w);
            if (g->known[way])
                st = time_pass(b, k, way, pass, seconds, how);
        }
    if (st == FMB_OK && *how == COMPLETE && passes > 0)
        take_medians(g, k, passes, seconds);
    free(seconds);
    return st;
}

static fmb_status run_samples(bench *b)
{
    study_grid *g = b->g;
    fmb_status st = FMB_OK;
    progress how = COMPLETE;
    g->run = calloc(g->prepared * g->most * g->ways + 1, sizeof *g->run);
    if (!g->run)
        return FMB_ERR_MEMORY;
    for (size_t k = 0; st == FMB_OK && how == COMPLETE && k < g->prepared; k++) {
        how = ENDED;
        st = count_sample(b, k, &how);
        if (st == FMB_OK && how == COMPLETE)
            st = time_sample(b, k, &how);
        if (st == FMB_OK && how == COMPLETE)
            g->complete = k + 1;
    }
    return st;
}

static fmb_status open_engines(bench *b)
{
    study_grid *g = b->g;
    b->engine = calloc(g->ways, sizeof *b->engine);
    g->known = calloc(g->ways, sizeof *g->known);
    fmb_status st = b->engine && g->known ? FMB_OK : FMB_ERR_MEMORY;
    for (size_t w = 0; st == FMB_OK && w < g->ways; w++) {
        st = study_engine_open(&b->engine[w], &g->way[w], &g->limits, &g->names);
        g->known[w] = st == FMB_OK;
        if (st == FMB_ERR_RULE)
            st = FMB_OK;
    }
    return st;
}

fmb_status study_grid_run(study_grid *g)
{
    bench b = {.g = g};
    for (size_t k = 0; k < g->samples; k++)
        b.all += 1 + (g->sample[k].file ? g->sample[k].size : g->per_class) * g->ways *
                         (size_t)(g->passes > 0 ? 2 + g->passes : 1);
    fmb_status st = study_reference_open(&b.reference, REFERENCE_SECONDS);
    if (st == FMB_OK)
        st = open_engines(&b);
    if (st == FMB_OK)
        st = prepare(&b);
    if (st == FMB_OK)
        st = run_samples(&b);
    g->rejected = b.reference.rejected;
    if (g->running)
        *g->running = NULL;
    for (size_t w = 0; b.engine && w < g->ways; w++)
        study_engine_close(&b.engine[w]);
    free(b.engine);
    study_reference_close(&b.reference);
    return st;
}

void study_grid_clear(study_grid *g)
{
    for (size_t k = 0; k < g->samples; k++) {
        for (size_t i = 0; i < g->sample[k].size; i++) {
            fmb_system_free(g->sample[k].item[i].s);
            free(g->sample[k].item[i].keep);
            free(g->sample[k].item[i].projection);
        }
        free(g->sample[k].item);
    }
    free(g->sample);
    free(g->known);
    free(g->run);
}
