/* rough_overlap.c: what doubles tell of the overlap along a normal; see normal_search.h. */
#include <math.h>

#include "proximity/normal_search.h"

#define ABOVE (1 + 0x1p-40)

/* ---- numbers --------------------------------------------------------------------------------- */

/* What all numbers of a direction share of powers of 2 goes out of it. */
static void shorten(fmb_normal_search *x, fmb_normal_direction *d)
{
    mpz_set_ui(x->t, 0);
    for (int j = 0; j < x->m->dim; j++)
        mpz_ior(x->t, x->t, d->exact[j]);
    d->power = mpz_sgn(x->t) == 0 ? 0 : mpz_scan1(x->t, 0);
    for (int j = 0; j < x->m->dim; j++)
        mpz_tdiv_q_2exp(d->exact[j], d->exact[j], d->power);
}

static size_t most_bits(mpz_t *v, int dim)
{
    size_t most = 1;
    for (int j = 0; j < dim; j++) {
        size_t bits = mpz_sizeinbase(v[j], 2);
        most = bits > most ? bits : most;
    }
    return most;
}

/* 0 where doubles end */
static double power_of_two(long exponent)
{
    return exponent < -1100 ? 0 : ldexp(1, (int)exponent);
}

static double scaled(const mpz_t z, size_t top)
{
    long exponent;
    double x = mpz_get_d_2exp(&exponent, z);
    return x * power_of_two(exponent - (long)top);
}

void fmb_normal_search_scale(fmb_normal_search *x)
{
    int dim = x->m->dim;
    size_t bits[FMB_NORMAL_MOST_DIRECTIONS], top = most_bits(x->away, dim);
    mp_bitcnt_t finest = x->unit[0];
    for (int j = 0; j < dim; j++) {
        x->coarsest = x->unit[j] > x->coarsest ? x->unit[j] : x->coarsest;
        finest = x->unit[j] < finest ? x->unit[j] : finest;
    }
    for (int i = 0; i < x->directions; i++) {
        shorten(x, &x->direction[i]);
        bits[i] = most_bits(x->direction[i].exact, dim);
        if (bits[i] + x->direction[i].power > top)
            top = bits[i] + x->direction[i].power;
    }
    for (int j = 0; j < dim; j++) {
        x->near[j] = scaled(x->away[j], top);
        x->weight[j] = fabs(x->near[j]);
        x->share[j] = power_of_two((long)finest - (long)x->unit[j]);
    }
    for (fmb_normal_direction *d = x->direction; d < x->direction + x->directions; d++) {
        size_t most = bits[d - x->direction];
        d->length = power_of_two((long)(most + d->power) - (long)top);
        for (int j = 0; j < dim; j++) {
            d->x[j] = scaled(d->exact[j], most);
            x->weight[j] += d->group == 0 ? d->length * fabs(d->x[j]) : 0;
        }
    }
}

/* ---- overlaps -------------------------------------------------------------------------------- */

/* Coordinates beyond those of the space are 0. */
static double along(const double *n, const double *v)
{
    double sum[2] = {0, 0};
    for (int j = 0; j < FMB_NORMALS_MOST_DIM; j += 2) {
        sum[0] += n[j] * v[j];
        sum[1] += n[j + 1] * v[j + 1];
    }
    return sum[0] + sum[1];
}

/* What M spans along n. */
static void find_ends(const fmb_normal_search *x, const double *n, double end[2])
{
    end[0] = end[1] = along(n, x->near);
    for (const fmb_normal_summand *f = x->of; f < x->of + 3; f++) {
        double span[2] = {0, 0};
        for (int i = 0; i < f->axes; i++) {
            const fmb_normal_direction *d = &x->direction[f->first + i];
            double at = along(n, d->x) * d->length, *most = &span[at > 0];
            *most = !f->simplex ? *most + at : fabs(at) > fabs(*most) ? at : *most;
        }
        end[0] += span[0];
        end[1] += span[1];
    }
}

/* The length of n >= 0: of a minor as small as 2^-944 (FMB_NORMAL_SHARE times FMB_NORMAL_LEAST) the
 * square would be lost.
 */
static double length_of_doubles(const double *n, int dim)
{
    double top = 0, sum = 0;
    int exponent;
    for (int j = 0; j < dim; j++)
        top = fmax(top, n[j]);
    (void)frexp(top, &exponent);
    for (int j = 0; j < dim; j++) {
        double part = ldexp(n[j], -exponent);
        sum += part * part;
    }
    return ldexp(sqrt(sum), exponent);
}

static double size_of_doubles(const fmb_normal_search *x, const double *n)
{
    double sum = 0;
    if (x->norm == FMB_NORM_EUCLIDEAN)
        return length_of_doubles(n, x->m->dim);
    for (int j = 0; j < x->m->dim; j++)
        sum += n[j];
    return sum;
}

bool fmb_normal_is_surely_more(const fmb_normal_search *x, double *bound)
{
    int dim = x->m->dim, all = (1 << dim) - 1;
    double n[FMB_NORMALS_MOST_DIM] = {0}, up[FMB_NORMALS_MOST_DIM], down[FMB_NORMALS_MOST_DIM],
           end[2], off = FMB_NORMAL_LEAST;
    for (int j = 0; j < dim; j++) {
        double fuzz = FMB_NORMAL_SHARE * x->size[all & ~(1 << j)];
        n[j] = (j & 1 ? -1 : 1) * x->minor[all & ~(1 << j)];
        up[j] = (fabs(n[j]) + fuzz) * x->share[j];
        down[j] = fmax(fabs(n[j]) - fuzz, 0) * x->share[j];
        off += 2 * fuzz * x->weight[j];
    }
    find_ends(x, n, end);
    double overlap = fmin(end[1], -end[0]);
    *bound = ABOVE * (fmax(overlap, 0) + off) / size_of_doubles(x, down);
    return overlap - off > x->best * size_of_doubles(x, up);
}
