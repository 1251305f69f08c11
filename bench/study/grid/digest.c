/* digest.c: see digest.h. */
#include "study/grid/digest.h"

#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_cdf.h>

/* Sums on the way to ratios. */
typedef struct sums {
    double kept[2], lived[2]; /* of base, of the way, where both decided */
    double *base, *way;       /* [s], one for each system timed */
    size_t gains, losses;
} sums;

static void add_counts(study_digest *d, const study_run *r)
{
    d->decided++;
    d->pairs += (double)r->pairs;
    d->made += (double)r->made;
    d->kept += (double)r->kept;
    d->lived += (double)r->lived;
    d->peak += (double)r->peak;
    d->held += (double)r->held;
    for (int i = 0; i < STUDY_MOST_NAMES; i++)
        d->dropped[i] += (double)r->dropped[i];
}

static void add_pair(study_digest *d, sums *s, const study_run *plain, const study_run *r)
{
    if (r->outcome != STUDY_DECIDED)
        return;
    if (plain->outcome != STUDY_DECIDED) {
        d->only++;
        return;
    }
    d->both++;
    s->kept[0] += (double)plain->kept;
    s->kept[1] += (double)r->kept;
    s->lived[0] += (double)plain->lived;
    s->lived[1] += (double)r->lived;
}

static void add_time(study_digest *d, sums *s, const study_run *plain, const study_run *r)
{
    bool solved = r->solved == STUDY_DECIDED, base_solved = plain->solved == STUDY_DECIDED;
    bool ran = solved || r->solved == STUDY_STOPPED;
    bool base_ran = base_solved || plain->solved == STUDY_STOPPED;
    if (!ran || !base_ran || !(solved || base_solved) || plain->seconds <= 0)
        return;
    s->base[d->timed] = plain->seconds;
    s->way[d->timed++] = r->seconds;
    d->base_gave_up += !base_solved;
    d->gave_up += !solved;
    s->gains += solved && r->seconds < plain->seconds;
    s->losses += !solved || r->seconds > plain->seconds;
}

static void add_run(study_digest *d, sums *s, const study_run *plain, const study_run *r)
{
    if (r->outcome == STUDY_NOT_RUN)
        return;
    d->systems++;
    d->wrong += r->outcome == STUDY_WRONG || r->solved == STUDY_WRONG;
    d->stopped += r->outcome == STUDY_STOPPED;
    d->refused += r->outcome == STUDY_REFUSED;
    if (r->outcome == STUDY_DECIDED)
        add_counts(d, r);
    add_pair(d, s, plain, r);
    add_time(d, s, plain, r);
}

static void make_means(study_digest *d)
{
    double n = d->decided > 0 ? (double)d->decided : 1;
    double *mean[] = {&d->pairs, &d->made, &d->kept, &d->lived, &d->peak, &d->held};
    for (size_t i = 0; i < sizeof mean / sizeof *mean; i++)
        *mean[i] /= n;
    for (int i = 0; i < STUDY_MOST_NAMES; i++)
        d->dropped[i] /= n;
}

static double ratio(const double *sum)
{
    return sum[0] > 0 ? sum[1] / sum[0] : (double)NAN;
}

static void make_ratios(study_digest *d, const sums *s)
{
    unsigned tries = (unsigned)(s->gains + s->losses);
    d->kept_ratio = ratio(s->kept);
    d->lived_ratio = ratio(s->lived);
    d->total = study_ratio_of_sums(s->way, s->base, d->timed);
    d->median = study_median_of_ratios(s->way, s->base, d->timed);
    d->chance = s->gains > 0 ? gsl_cdf_binomial_Q((unsigned)s->gains - 1, 0.5, tries) : 1;
}

fmb_status study_digest_make(const study_grid *g, size_t way, size_t base, study_filter *filter,
                             const void *self, study_digest *out)
{
    study_digest d = {0};
    size_t most = g->complete * g->most + 1;
    sums s = {.base = malloc(2 * most * sizeof *s.base)};
    if (!s.base)
        return FMB_ERR_MEMORY;
    s.way = s.base + most;
    for (size_t k = 0; k < g->complete; k++)
        for (size_t i = 0; filter(self, &g->sample[k]) && i < g->sample[k].size; i++)
            add_run(&d, &s, study_grid_at(g, k, i, base), study_grid_at(g, k, i, way));
    make_means(&d);
    make_ratios(&d, &s);
    free(s.base);
    *out = d;
    return FMB_OK;
}
