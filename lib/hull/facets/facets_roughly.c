/* facets_roughly.c: normals in doubles, with error bounds; see facets.h.
 *
 * Invariant: |roughly_j| <= 1, and for some s > 0, |s normal_j - roughly_j| + |roughly_j| (d + 8)
 * 2^-51 <= off_j <= MOST, where off_j is roughly_{d + j}; or some off_j is not finite.
 *
 * Underflow. A product that underflows has an error of at most 2^-1075; sums and differences are
 * exact if they are that small. A relevant entry of a normal or of near may have become 0: if
 * entries spread widely, as those of distant points do, the other entries are small, too.
 *
 * Theorem. Let near_j = t g_j up to a factor within 1 +- 2^-50, and up to 2^-1073, t > 0. Then the
 * computed sum_j roughly_j near_j and s t normal.g differ by no more than sum_j off_j |near_j| +
 * LEAST, computed with some room, if all of this is finite. Proof. Products and sums round d + 1
 * times, near has an error of eight times 2^-53: that is less than |roughly_j| (d + 8) 2^-51
 * |near_j|. The other error of near contributes less than (1 + MOST) d 2^-1073, and underflow in
 * the 2 d products less than d 2^-1074: both are less than LEAST, as d < 2^60. The bound itself, of
 * positive terms, rounds d + 2 times.
 *
 * Theorem. If n has errors e_n and the value p, with error w_p, and v likewise e_v, q and w_q, then
 * |q| n + p v has an error of (|q| + w_q) e_n + w_q |n| + (p + w_p) e_v + w_p |v|; its three
 * roundings an entry are less than the part of off_j beside e_j. Its own products and those of e_j
 * underflow by less than six times 2^-1075, less than LEAST beside e_j, and its scaling by 2^-1075,
 * less than LEAST beside off_j (a scale below 1 might shrink the other LEAST too much).
 */
#include "base/ways.h"
#include <math.h>

#include "hull/facets/facets_private.h"

/* Bounds are computed in doubles, too. */
#define ROOM (1 + 0x1p-40)
/* Smaller numbers cannot be distinguished from underflow. */
#define LEAST 0x1p-900
/* A larger multiple of an underflow might be distinguished from it. */
#define MOST 0x1p100

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
    bool lost = !(most > LEAST && most < INFINITY); /* underflow may matter */
    frexp(lost ? 1 : most, &exponent);
    double scale = ldexp(1, -exponent);
    for (size_t j = 0; j < f->d; j++) {
        r[j] *= scale;
        e[j] = ROOM * ((e[j] + LEAST) * scale + LEAST) + fabs(r[j]) * (double)(f->d + 8) * 0x1p-51;
        lost |= !(e[j] <= MOST);
    }
    e[0] = lost ? INFINITY : e[0];
}

bool fmb_facets_guess_side(const fmb_facets *f, fmb_facet *a, const double *near, int *side)
{
    double sum = 0, off = LEAST;
    if (!fmb_way(FMB_WAY_ROUGH))
        return false;
    for (size_t j = 0; j < f->d; j++) {
        sum += a->roughly[j] * near[j];
        off += a->roughly[f->d + j] * fabs(near[j]);
    }
    a->value = sum;
    a->off = off * (1 + (double)(f->d + 2) * 0x1p-51);
    *side = sum > 0 ? 1 : -1;
    bool sure = isfinite(sum) && fabs(sum) > a->off;
    fmb_way_answered(FMB_WAY_ROUGH, sure);
    return sure;
}
