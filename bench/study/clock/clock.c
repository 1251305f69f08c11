/* clock.c: see clock.h. */
#include "study/clock/clock.h"

#include <math.h>
#include <stdlib.h>

#include "base/clock.h"

double study_thread_seconds(void)
{
    return fmb_clock_seconds(CLOCK_THREAD_CPUTIME_ID);
}

/* ---- the passes ------------------------------------------------------------------------------ */

static size_t group_begin(const study_clock *c, size_t group)
{
    size_t rest = c->queries % c->groups;
    return c->queries / c->groups * group + (group < rest ? group : rest);
}

static double *seconds_at(const study_clock *c, int pass, size_t way)
{
    return c->seconds + ((size_t)pass * c->ways + way) * c->groups;
}

static fmb_status time_way(const study_clock *c, const study_timed *way, double *seconds)
{
    fmb_status st = FMB_OK;
    double then = study_thread_seconds();
    for (size_t g = 0; st == FMB_OK && g < c->groups; g++) {
        size_t first = group_begin(c, g);
        st = way->run(way->self, first, group_begin(c, g + 1) - first);
        double now = study_thread_seconds();
        seconds[g] = now - then;
        then = now;
    }
    return st;
}

/* One pass of each way. The first way changes from round to round, so that no way always follows
 * the same other one and finds its caches. */
static fmb_status one_round(const study_clock *c, size_t round, int pass, bool *goes_on)
{
    size_t all = (size_t)(c->passes + 1) * c->ways;
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && *goes_on && i < c->ways; i++) {
        size_t way = (i + round) % c->ways;
        if (c->step && !c->step(c->self, round * c->ways + i, all))
            *goes_on = false;
        else
            st = time_way(c, &c->way[way], seconds_at(c, pass, way));
    }
    return st;
}

fmb_status study_clock_run(study_clock *c)
{
    double begin = fmb_monotonic_seconds();
    bool goes_on = true;
    if (c->ways == 0 || c->passes < 1 || c->passes > STUDY_CLOCK_MOST_PASSES || c->groups < 1 ||
        c->groups > c->queries)
        return FMB_ERR_ARG;
    c->complete = 0;
    c->seconds = calloc((size_t)c->passes * c->ways * c->groups, sizeof *c->seconds);
    if (!c->seconds)
        return FMB_ERR_MEMORY;
    fmb_status st = one_round(c, 0, 0, &goes_on);
    while (st == FMB_OK && goes_on && c->complete < c->passes) {
        st = one_round(c, 1 + (size_t)c->complete, c->complete, &goes_on);
        c->complete += st == FMB_OK && goes_on;
        if (c->max_seconds > 0 && fmb_monotonic_seconds() - begin > c->max_seconds)
            goes_on = false;
    }
    return st;
}

void study_clock_clear(study_clock *c)
{
    free(c->seconds);
    c->seconds = NULL;
    c->complete = 0;
}

/* ---- the results ----------------------------------------------------------------------------- */

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

study_spread study_spread_of(double *x, size_t n)
{
    if (n == 0)
        return (study_spread){NAN, NAN, NAN};
    qsort(x, n, sizeof *x, by_size);
    return (study_spread){x[0], n % 2 ? x[n / 2] : (x[n / 2 - 1] + x[n / 2]) / 2, x[n - 1]};
}

/* Seconds of groups first ... first + n - 1 of a pass. */
static double sum(const study_clock *c, int pass, size_t way, size_t first, size_t n)
{
    double total = 0;
    const double *seconds = seconds_at(c, pass, way);
    for (size_t g = first; g < first + n; g++)
        total += seconds[g];
    return total;
}

/* Likewise for each complete pass. Returns the number of passes. */
static size_t sum_passes(const study_clock *c, size_t way, size_t first, size_t n,
                         double out[STUDY_CLOCK_MOST_PASSES])
{
    for (int pass = 0; pass < c->complete; pass++)
        out[pass] = sum(c, pass, way, first, n);
    return (size_t)c->complete;
}

/* From seconds of all queries to nanoseconds of one. */
static study_spread per_query(study_spread s, size_t queries)
{
    double scale = 1e9 / (double)queries;
    return (study_spread){s.least * scale, s.median * scale, s.most * scale};
}

study_spread study_clock_ns(const study_clock *c, size_t way)
{
    double x[STUDY_CLOCK_MOST_PASSES];
    size_t passes = sum_passes(c, way, 0, c->groups, x);
    return per_query(study_spread_of(x, passes), c->queries);
}

study_ratio study_clock_ratio(const study_clock *c, size_t a, size_t b)
{
    double x[STUDY_CLOCK_MOST_PASSES], y[STUDY_CLOCK_MOST_PASSES];
    size_t passes = sum_passes(c, a, 0, c->groups, x);
    sum_passes(c, b, 0, c->groups, y);
    return study_ratio_of_medians(x, y, passes);
}

/* The time of a query of each group, median of the passes [ns]. Returns the number of groups. */
static size_t group_medians(const study_clock *c, size_t way, double *out)
{
    double x[STUDY_CLOCK_MOST_PASSES];
    for (size_t g = 0; c->complete > 0 && g < c->groups; g++) {
        size_t passes = sum_passes(c, way, g, 1, x);
        out[g] =
            per_query(study_spread_of(x, passes), group_begin(c, g + 1) - group_begin(c, g)).median;
    }
    return c->complete > 0 ? c->groups : 0;
}

fmb_status study_clock_group_ns(const study_clock *c, size_t way, study_spread *out)
{
    double *x = malloc(c->groups * sizeof *x);
    if (!x)
        return FMB_ERR_MEMORY;
    *out = study_spread_of(x, group_medians(c, way, x));
    free(x);
    return FMB_OK;
}

fmb_status study_clock_group_ratio(const study_clock *c, size_t a, size_t b, study_ratio *out)
{
    double *x = malloc(2 * c->groups * sizeof *x);
    if (!x)
        return FMB_ERR_MEMORY;
    size_t n = group_medians(c, a, x);
    group_medians(c, b, x + c->groups);
    *out = study_ratio_of_medians(x, x + c->groups, n);
    free(x);
    return FMB_OK;
}
