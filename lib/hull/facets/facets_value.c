/* facets_value.c: normals times generators, exactly; see facets.h. */
#include "hull/facets/facets_private.h"
#include "num/gcd.h"

/* Sums of products of two numbers with so many bits together stay below 2^126, d being small. */
#define SAFE_BITS 120

static bool is_product_small(const fmb_vec *v, const fmb_vec *g)
{
    return !v->z && !g->z && v->bits + g->bits <= SAFE_BITS;
}

static fmb_i128 product_of_small(const fmb_facets *f, const fmb_vec *v, const fmb_vec *g)
{
    fmb_i128 sum = fmb_i128_of(0);
    for (size_t j = 0; j < f->d; j++)
        sum = fmb_i128_plus_product(sum, v->s[j], g->s[j]);
    return sum;
}

/* In k->t. */
static void multiply_as_mpz(const fmb_facets *f, const fmb_vec *v, const fmb_vec *g, fmb_num *k)
{
    mpz_set_ui(k->t, 0);
    for (size_t j = 0; j < f->d; j++) {
        fmb_vec_get(v, j, k->p);
        fmb_vec_get(g, j, k->q);
        mpz_addmul(k->t, k->p, k->q);
    }
}

int fmb_facets_sign_by(const fmb_facets *f, const fmb_vec *v, const fmb_vec *g, fmb_num *num)
{
    if (is_product_small(v, g)) {
        return fmb_i128_sign(product_of_small(f, v, g));
    }
    multiply_as_mpz(f, v, g, num);
    return mpz_sgn(num->t);
}

int fmb_facets_sign(fmb_facets *f, const fmb_vec *v, const fmb_vec *g)
{
    return fmb_facets_sign_by(f, v, g, &f->num);
}

fmb_status fmb_facets_evaluate(fmb_facets *f, fmb_vec *v)
{
    if (is_product_small(v, &f->g)) {
        fmb_i128 sum = product_of_small(f, v, &f->g);
        int bits = fmb_u128_bits(fmb_i128_size(sum));
        if (bits <= FMB_SMALL_BITS) {
            v->s[f->d] = fmb_i128_low(sum);
            v->bits = bits > v->bits ? bits : v->bits;
            return FMB_OK;
        }
    }
    fmb_status st = fmb_vec_widen(v, f->d + 1, f->num.mem);
    if (st != FMB_OK)
        return st;
    multiply_as_mpz(f, v, &f->g, &f->num);
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

void fmb_facets_negate(fmb_vec *v, size_t n)
{
    for (size_t j = 0; j < n; j++) {
        if (v->z)
            mpz_neg(v->z[j], v->z[j]);
        else
            v->s[j] = -v->s[j];
    }
}
