/* ratio.c: see ratio.h. */
#include "study/clock/ratio.h"

#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

#include "study/draw/draft.h"

enum { RESAMPLES = 1000, BEYOND = 25, SEED = 1 }; /* BEYOND: ratios cut off at either end */

/* A statistic of n pairs; may sort each array by itself. */
typedef double statistic(double *a, double *b, size_t n);

static double divide_medians(double *a, double *b, size_t n)
{
    return gsl_stats_median(a, 1, n) / gsl_stats_median(b, 1, n);
}

static double take_median_ratio(double *a, double *b, size_t n)
{
    for (size_t i = 0; i < n; i++)
        a[i] /= b[i];
    return gsl_stats_median(a, 1, n);
}

static double divide_sums(double *a, double *b, size_t n)
{
    double sum[2] = {0, 0};
    for (size_t i = 0; i < n; i++) {
        sum[0] += a[i];
        sum[1] += b[i];
    }
    return sum[0] / sum[1];
}

/* room: for 2 n numbers and the ratios of all resamples. */
static void resample(const double *a, const double *b, size_t n, statistic *of, double *room,
                     study_ratio *out)
{
    uint64_t state;
    gsl_rng g = {&study_splitmix, &state};
    double *x = room, *y = room + n, *found = room + 2 * n;
    gsl_rng_set(&g, SEED);
    for (size_t k = 0; k < RESAMPLES; k++) {
        for (size_t i = 0; i < n; i++) {
            size_t from = gsl_rng_uniform_int(&g, n);
            x[i] = a[from];
            y[i] = b[from];
        }
        found[k] = of(x, y, n);
    }
    gsl_sort(found, 1, RESAMPLES);
    out->low = found[BEYOND];
    out->high = found[RESAMPLES - 1 - BEYOND];
}

static study_ratio estimate(const double *a, const double *b, size_t n, statistic *of)
{
    study_ratio out = {NAN, NAN, NAN, NAN, NAN};
    double *room = n > 0 ? malloc((2 * n + RESAMPLES) * sizeof *room) : NULL;
    for (size_t i = 0; i < n; i++) {
        out.least = fmin(out.least, a[i] / b[i]);
        out.most = fmax(out.most, a[i] / b[i]);
    }
    if (!room)
        return out;
    for (size_t i = 0; i < n; i++) {
        room[i] = a[i];
        room[n + i] = b[i];
    }
    out.ratio = of(room, room + n, n);
    resample(a, b, n, of, room, &out);
    free(room);
    return out;
}

study_ratio study_ratio_of_medians(const double *a, const double *b, size_t n)
{
    return estimate(a, b, n, divide_medians);
}

study_ratio study_median_of_ratios(const double *a, const double *b, size_t n)
{
    return estimate(a, b, n, take_median_ratio);
}

study_ratio study_ratio_of_sums(const double *a, const double *b, size_t n)
{
    return estimate(a, b, n, divide_sums);
}
