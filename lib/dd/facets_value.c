/* facets_value.c: normals times the generator at hand, first in doubles; see facets.h. */
#include <math.h>

#include "dd/facets_inside.h"
#include "num/gcd.h"

/* Sums of products of two numbers with so many bits together stay below 2^126, d being small. */
#define SAFE_BITS 120

static bool is_product_small(const fmb_facets *f, const fmb_vec *v)
{
    return !v->z && !f->g.z && v->bits + f->g.bits <= SAFE_BITS;
}

static fmb_i128 product_of_small(const fmb_facets *f, const fmb_vec *v)
{
    fmb_i128 sum = 0;
    for (size_t j = 0; j < f->d; j++)
        sum += (fmb_i128)v->s[j] * f->g.s[j];
    return sum;
}

/* In f->num.t. */
static void multiply_as_mpz(fmb_facets *f, const fmb_vec *v)
{
    fmb_num *k = &f->num;
    mpz_set_ui(k->t, 0);
    for (size_t j = 0; j < f->d; j++) {
        fmb_vec_get(v, j, k->p);
        fmb_vec_get(&f->g, j, k->q);
        mpz_addmul(k->t, k->p, k->q);
    }
}

int fmb_facets_sign(fmb_facets *f, const fmb_vec *v)
{
    if (is_product_small(f, v)) {
        fmb_i128 sum = product_of_small(f, v);
        return (sum > 0) - (sum < 0);
    }
    multiply_as_mpz(f, v);
    return mpz_sgn(f->num.t);
}

/* Entries are off by a factor within 1 +- 2^-51, products and sums round d + 1 times more: together
 * less than (d + 8) 2^-50 of the sum of all sizes. What underflows is below the least that is
 * believed. */
int fmb_facets_side(fmb_facets *f, const fmb_facet *a)
{
    double sum = 0, all = 0;
    for (size_t j = 0; j < f->d; j++) {
        double t = a->roughly[j] * f->near[j];
        sum += t;
        all += fabs(t);
    }
    if (fabs(sum) > all * (double)(f->d + 8) * 0x1p-50 + 1e-280)
        return sum > 0 ? 1 : -1;
    return fmb_facets_sign(f, &a->normal);
}

fmb_status fmb_facets_evaluate(fmb_facets *f, fmb_vec *v)
{
    if (is_product_small(f, v)) {
        fmb_i128 sum = product_of_small(f, v);
        fmb_u128 size = sum < 0 ? 0 - (fmb_u128)sum : (fmb_u128)sum;
        if (size >> FMB_SMALL_BITS == 0) {
            int bits = fmb_bits64((uint64_t)size);
            v->s[f->d] = (int64_t)sum;
            v->bits = bits > v->bits ? bits : v->bits;
            return FMB_OK;
        }
    }
    fmb_status st = fmb_vec_widen(v, f->d + 1, f->num.mem);
    if (st != FMB_OK)
        return st;
    multiply_as_mpz(f, v);
    mpz_set(v->z[f->d], f->num.t);
    return fmb_vec_settle(v, f->d + 1, f->num.mem);
}

/* Wide vectors are in lowest terms already; one that was wide for its last entry alone is so no
 * more. */
fmb_status fmb_facets_tidy(fmb_facets *f, fmb_vec *v)
{
    size_t bits = 0;
    if (!v->z) {
        v->s[f->d] = 0;
        return fmb_vec_reduce(v, f->d + 1, &f->num);
    }
    mpz_set_ui(v->z[f->d], 0);
    for (size_t j = 0; j < f->d; j++) {
        size_t b = mpz_sizeinbase(v->z[j], 2);
        bits = b > bits ? b : bits;
    }
    return bits > FMB_SMALL_BITS ? FMB_OK : fmb_vec_reduce(v, f->d + 1, &f->num);
}

void fmb_facets_round(const fmb_vec *v, size_t n, double *out)
{
    long most = 0;
    if (!v->z) {
        for (size_t j = 0; j < n; j++)
            out[j] = (double)v->s[j];
        return;
    }
    for (size_t j = 0; j < n; j++) {
        long bits = (long)mpz_sizeinbase(v->z[j], 2);
        most = bits > most ? bits : most;
    }
    for (size_t j = 0; j < n; j++) {
        long exponent;
        double mantissa = mpz_get_d_2exp(&exponent, v->z[j]);
        long shift = exponent - most < -1100 ? -1100 : exponent - most;
        out[j] = ldexp(mantissa, (int)shift);
    }
}
