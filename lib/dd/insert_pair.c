/* insert_pair.c: computes the ray of one pair, and counts of rays; see insert.h. */
#include "dd/insert.h"

fmb_status fmb_insertion_combine(const fmb_cone *c, size_t at, uint32_t a, uint32_t b, fmb_num *num)
{
    const fmb_rays *r = &c->ray;
    uint64_t *to = fmb_rays_support(r, at);
    const uint64_t *x = fmb_rays_support(r, a), *y = fmb_rays_support(r, b);
    for (size_t k = 0; k < r->words; k++)
        to[k] = x[k] | y[k];
    return fmb_vec_cancel(&r->v[at], &r->v[a], &r->v[b], r->width, c->at->entry, num);
}

/* A ray of GMP integers takes as long as so many small rays. */
#define WIDE_RAY 16

uint64_t fmb_ray_price(const fmb_vec *v)
{
    return v->z ? WIDE_RAY : 1;
}

void fmb_cone_count_negatives(const fmb_cone *c, const fmb_vec *v, int sign, size_t *negatives)
{
    if (v->z)
        for (size_t k = 0; k < c->lefts; k++)
            negatives[k] += (size_t)(sign * (mpz_sgn(v->z[c->coords + k]) < 0));
    else
        for (size_t k = 0; k < c->lefts; k++)
            negatives[k] += (size_t)(sign * (v->s[c->coords + k] < 0));
}
