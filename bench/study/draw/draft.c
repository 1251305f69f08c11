/* draft.c: see draft.h. */
#include "study/draw/draft.h"

#include <limits.h>

/* ---- random numbers -------------------------------------------------------------------------- */

static void set(void *state, unsigned long seed)
{
    *(uint64_t *)state = seed;
}

static uint64_t next(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static unsigned long get(void *state)
{
    return (unsigned long)next(state);
}

static double get_double(void *state)
{
    return (double)(next(state) >> 11) * 0x1p-53;
}

const gsl_rng_type study_splitmix = {
    "splitmix64", ULONG_MAX, 0, sizeof(uint64_t), set, get, get_double,
};

void study_draw_even(study_draft *d, double most, double *out, int n)
{
    for (int i = 0; i < n; i++)
        out[i] = most * (2 * gsl_rng_uniform(d->g) - 1);
}

void study_draw_whole(study_draft *d, int most, double *out, int n)
{
    for (int i = 0; i < n; i++)
        out[i] = study_choice(d, 2 * most + 1) - most;
}

/* ---- points ---------------------------------------------------------------------------------- */

/* Normalizes the weights of a point of a simplex, the origin's weight included, to sum 1. */
static void weigh(double *c, int n, double of_origin)
{
    double sum = of_origin;
    for (int i = 0; i < n; i++)
        sum += c[i];
    for (int i = 0; sum > 0 && i < n; i++)
        c[i] /= sum;
}

void study_draw_inside(study_draft *d, int f, double *c)
{
    int n = d->naxes[f];
    for (int i = 0; i < n; i++)
        c[i] = gsl_rng_uniform(d->g);
    if (d->shape[f] == FMB_SIMPLEX)
        weigh(c, n, gsl_rng_uniform(d->g));
}

void study_draw_boundary(study_draft *d, int f, double *c)
{
    int n = d->naxes[f];
    study_draw_inside(d, f, c);
    if (n == 0)
        return;
    int i = study_choice(d, n + 1);
    if (d->shape[f] == FMB_CUBOID)
        c[i % n] = study_coin(d);
    else if (i < n)
        c[i] = 0;
    else
        weigh(c, n, 0);
}

void study_place(study_draft *d, const double *cp, const double *cq, double t, const double *off)
{
    for (int j = 0; j < d->dim; j++) {
        double x = d->origin[0][j] + off[j];
        for (int i = 0; i < d->naxes[0]; i++)
            x += cp[i] * d->axes[0][i * d->dim + j];
        for (int i = 0; i < d->naxes[1]; i++)
            x -= cq[i] * d->axes[1][i * d->dim + j];
        if (d->moves)
            x -= t * (d->speed[1][j] - d->speed[0][j]);
        d->origin[1][j] = x;
    }
}
