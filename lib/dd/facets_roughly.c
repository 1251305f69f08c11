/* facets_roughly.c: normals in doubles, with error bounds; see facets.h.
 *
 * Invariant: for some s > 0, |s normal_j - roughly_j| + |roughly_j| (d + 8) 2^-51 <= off_j, if
 * off_j is roughly_{d + j}; or off_j is not finite.
 *
 * Theorem. Let near_j = t g_j up to a factor within 1 +- 2^-50, t > 0. Then sum_j roughly_j near_j,
 * as it is computed, and s t normal.g differ by no more than sum_j off_j |near_j|, computed with
 * some room: products and sums round d + 1 times, near is off by eight times 2^-53, and bounds
 * have been made larger by 2^-40. What underflows is below the least that is believed.
 *
 * Theorem. If n is off by e_n and has the value p, off by w_p, and v likewise e_v, q and w_q, then
 * |q| n + p v is off by (|q| + w_q) e_n + w_q |n| + (p + w_p) e_v + w_p |v|; its three roundings
 * an entry are what off_j has beside e_j, and more.
 */
#include <math.h>

#include "dd/facets_inside.h"

/* Bounds are computed in doubles, too. */
#define ROOM (1 + 0x1p-40)
/* Less than this is not told from what underflowed. */
#define LEAST 1e-280

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

void fmb_facets_round_normal(const fmb_facets *f, fmb_facet *a)
{
    double most = 0;
    int exponent;
    fmb_facets_round(&a->normal, f->d, a->roughly);
    for (size_t j = 0; j < f->d; j++)
        most = fmax(most, fabs(a->roughly[j]));
    frexp(most, &exponent);
    double scale = ldexp(1, -exponent);
    for (size_t j = 0; j < f->d; j++) {
        a->roughly[j] *= scale;
        a->roughly[f->d + j] = fabs(a->roughly[j]) * (double)(f->d + 10) * 0x1p-51 + LEAST;
    }
}

void fmb_facets_combine_roughly(fmb_facets *f, fmb_facet *a, const fmb_facet *n, const fmb_facet *v)
{
    const double *rn = n->roughly, *rv = v->roughly, *en = rn + f->d, *ev = rv + f->d;
    double p = fabs(n->value), q = fabs(v->value), most = 0, *r = a->roughly, *e = r + f->d;
    int exponent;
    for (size_t j = 0; j < f->d; j++) {
        r[j] = q * rn[j] + p * rv[j];
        e[j] = (q + v->off) * en[j] + v->off * fabs(rn[j]) + (p + n->off) * ev[j] +
               n->off * fabs(rv[j]);
        most = fmax(most, fabs(r[j]));
    }
    frexp(most, &exponent);
    bool lost = !(most > LEAST); /* what underflows may count */
    double scale = ldexp(1, lost ? 0 : -exponent);
    for (size_t j = 0; j < f->d; j++) {
        r[j] *= scale;
        e[j] = lost ? INFINITY : ROOM * e[j] * scale + fabs(r[j]) * (double)(f->d + 8) * 0x1p-51;
    }
}

bool fmb_facets_guess_side(const fmb_facets *f, fmb_facet *a, const double *near, int *side)
{
    double sum = 0, off = LEAST;
    for (size_t j = 0; j < f->d; j++) {
        sum += a->roughly[j] * near[j];
        off += a->roughly[f->d + j] * fabs(near[j]);
    }
    a->value = sum;
    a->off = off * ROOM;
    *side = sum > 0 ? 1 : -1;
    return fabs(sum) > a->off;
}
