/* sat.h: verdicts by separating axes.
 *
 * Two convex polytopes are apart if and only if an axis separates them that is normal to a face of
 * one of them or to an edge of each (Gottschalk, Lin, Manocha 1996). B moving is B plus a segment,
 * whose direction counts as one more edge. All axes are tried, without a branch but for a block
 * whose pairs are all apart already.
 *
 * Errors, with u = 2^-53. A number "good to k by X" is at most X, and off by at most k u X. Sums
 * are good to max(k, k') + 1 by X + X', products to k + k' + 1 by X X'; abs, min, max and doubling
 * cost nothing. alpha, beta, delta and omega are those of front.h. With
 *
 *     reach = 3 alpha + 3 beta + 2 delta + omega
 *
 * the vectors corner, centre and origin of sat_rays are good to 4 by reach. In space cross products
 * of two axes are good to 2 by 2 alpha^2 or 2 beta^2, b x d to 3 by 2 beta omega, b x centre to 6
 * by 2 beta reach, d x corner to 7 by 2 omega reach; so
 *
 *     e, p, det     are good to 5 by 6 alpha^2 beta, 6 alpha beta^2, 6 alpha^3 or 6 beta^3
 *     d, tau, w     to 6 by 6 alpha^2 omega, 6 beta^2 omega, 6 alpha beta omega
 *     on_a, on_b, t to 9 by 6 alpha^2 reach, 6 beta^2 reach, 6 alpha beta reach
 *     z, on_drift   to 10 by 6 alpha omega reach, 6 beta omega reach
 *
 * An overlap is a sum of these. A difference of edges of B doubles what belongs to it, one of edges
 * of A likewise; the fourth coordinate and the fourth normal treble it. So the parts of an overlap
 * are at most, with r for reach,
 *
 *     on normals of A, over alpha^2      CC   6 alpha + 18 beta +  6 omega +  6 r <= 12 r
 *                                        CT   6 alpha + 24 beta +  6 omega +  6 r <= 14 r
 *                                        TT  18 alpha + 72 beta + 18 omega + 18 r <= 42 r
 *     on normals of B, over beta^2       CC  18 alpha +  6 beta +  6 omega +  6 r <= 12 r
 *                                        CT  54 alpha + 18 beta + 18 omega + 18 r <= 36 r
 *                                        TT  72 alpha + 18 beta + 18 omega + 18 r <= 42 r
 *     edge x edge, over alpha beta       CC  12 alpha + 12 beta +  6 omega +  6 r <= 12 r
 *                                        CT  24 alpha + 36 beta + 12 omega + 12 r <= 24 r
 *                                        TT  72 alpha + 72 beta + 24 omega + 24 r <= 48 r
 *     edge of A x d, over alpha omega    CC  12 alpha + 18 beta +  6 r <= 12 r
 *                                        CT  12 alpha + 24 beta +  6 r <= 14 r
 *                                        TT  36 alpha + 48 beta + 12 r <= 28 r
 *     edge of B x d, over beta omega     CC  18 alpha + 12 beta +  6 r <= 12 r
 *                                        CT  36 alpha + 36 beta + 12 r <= 24 r
 *                                        TT  48 alpha + 36 beta + 12 r <= 28 r
 *
 * and so at most 12, 36 or 48 reach. On the way from an overlap down to a number good to 10, 9 or 6
 * there are at most five, six or eight sums. So overlaps are good to 15, and terms of u^2 are less
 * than one more. As omega may be so small that products with it underflow, beta + omega stands in
 * its place: then errors are at least u 2^-300, far above what underflows (front.h).
 *
 * In the plane cross products of axes are good to 2 by 2 alpha beta and the like, and those with
 * corner, centre and origin to 6 by 2 alpha reach. Edges a_1 - a_0 double, and an overlap has parts
 * of at most 12 reach over alpha, beta or omega, and at most six sums: 16 is enough again.
 *
 * What if A is flat, or B? An axis that vanishes has the overlap 0, so they do not meet certainly.
 * If none vanishes, each frame spans a plane at least, and each direction in which a face of A - B
 * may look is among the axes; and if all of A - B lies in one plane, then on the normals of A,
 * which are normal to it, both frames have no width. So where all overlaps are positive 0 is inside
 * A - B, and the relative interiors of A and B meet.
 */
#ifndef FMB_PAIR_SAT_H
#define FMB_PAIR_SAT_H

#include "pair/kernels.h"
#include "pair/sat_flat.h"
#include "pair/sat_space.h"

/* What is certain so far, and of which lanes anything can be. */
typedef struct sat_state {
    lane_mask apart, meet, known;
} sat_state;

/* The least overlap of a class, certain to error. */
FMB_INLINE void sat_learn(sat_state *s, lane least, lane error)
{
    s->apart = lane_or(s->apart, lane_less(least, -error));
    s->meet = lane_and(s->meet, lane_less(error, least));
}

FMB_INLINE fmb_pair_bits sat_bits(const sat_state *s)
{
    return (fmb_pair_bits){lane_bits(lane_and(s->apart, s->known)),
                           lane_bits(lane_and(s->meet, s->known))};
}

/* Nothing is left to ask. */
FMB_INLINE bool sat_is_over(const sat_state *s)
{
    return lane_bits(lane_and(s->apart, s->known)) == (1u << FMB_LANES) - 1;
}

FMB_INLINE sat_state sat_begin(const sat_rays *r)
{
    lane_mask none = lane_less(lane_of(1), lane_of(0)), all = lane_less(lane_of(0), lane_of(1));
    return (sat_state){none, all, r->known};
}

FMB_INLINE fmb_pair_bits sat_decide_flat(sat_kind k, const double *block)
{
    sat_rays r = sat_load(k, block);
    sat_state s = sat_begin(&r);
    lane error = lane_of(16 * 12 * 0x1p-53) * r.reach;
    sat_learn(&s, sat_flat_a(k, &r), error * r.alpha);
    sat_learn(&s, sat_flat_b(k, &r), error * r.beta);
    if (k.moves)
        sat_learn(&s, sat_flat_drift(k, &r), error * (r.beta + r.omega));
    return sat_bits(&s);
}

FMB_INLINE fmb_pair_bits sat_decide(sat_kind k, const double *block)
{
    const double most = k.a_simplex ? 48 : k.b_simplex ? 36 : 12;
    sat_rays r = sat_load(k, block);
    sat_state s = sat_begin(&r);
    sat_products x;
    lane error = lane_of(16 * most * 0x1p-53) * r.reach, gamma = r.beta + r.omega;
    sat_multiply_a(k, &r, &x);
    sat_learn(&s, sat_normals_of_a(k, &x), error * r.alpha * r.alpha);
    if (sat_is_over(&s))
        return sat_bits(&s);
    sat_multiply_b(k, &r, &x);
    sat_learn(&s, sat_normals_of_b(k, &x), error * r.beta * r.beta);
    if (sat_is_over(&s))
        return sat_bits(&s);
    sat_multiply_edges(k, &r, &x);
    if (k.moves)
        sat_learn(&s, sat_swept_b(k, &x), error * r.beta * gamma);
    sat_learn(&s, sat_edges_of_a(k, &x), error * r.alpha * gamma);
    return sat_bits(&s);
}

static fmb_pair_bits sat_2d_cc(const double *block)
{
    return sat_decide_flat((sat_kind){2, false, false, false}, block);
}

static fmb_pair_bits sat_2d_ct(const double *block)
{
    return sat_decide_flat((sat_kind){2, false, false, true}, block);
}

static fmb_pair_bits sat_2d_tt(const double *block)
{
    return sat_decide_flat((sat_kind){2, false, true, true}, block);
}

static fmb_pair_bits sat_2d_moving_cc(const double *block)
{
    return sat_decide_flat((sat_kind){2, true, false, false}, block);
}

static fmb_pair_bits sat_2d_moving_ct(const double *block)
{
    return sat_decide_flat((sat_kind){2, true, false, true}, block);
}

static fmb_pair_bits sat_2d_moving_tt(const double *block)
{
    return sat_decide_flat((sat_kind){2, true, true, true}, block);
}

static fmb_pair_bits sat_3d_cc(const double *block)
{
    return sat_decide((sat_kind){3, false, false, false}, block);
}

static fmb_pair_bits sat_3d_ct(const double *block)
{
    return sat_decide((sat_kind){3, false, false, true}, block);
}

static fmb_pair_bits sat_3d_tt(const double *block)
{
    return sat_decide((sat_kind){3, false, true, true}, block);
}

static fmb_pair_bits sat_3d_moving_cc(const double *block)
{
    return sat_decide((sat_kind){3, true, false, false}, block);
}

static fmb_pair_bits sat_3d_moving_ct(const double *block)
{
    return sat_decide((sat_kind){3, true, false, true}, block);
}

static fmb_pair_bits sat_3d_moving_tt(const double *block)
{
    return sat_decide((sat_kind){3, true, true, true}, block);
}

/* A block (simplex, cuboid) is swapped. */
#define SAT_SHAPES(name)                                                                           \
    {                                                                                              \
        {name##_cc, name##_ct},                                                                    \
        {                                                                                          \
            name##_ct, name##_tt                                                                   \
        }                                                                                          \
    }
#define FMB_VERDICTS_BY_SAT                                                                        \
    {                                                                                              \
        {SAT_SHAPES(sat_2d), SAT_SHAPES(sat_2d_moving)},                                           \
        {                                                                                          \
            SAT_SHAPES(sat_3d), SAT_SHAPES(sat_3d_moving)                                          \
        }                                                                                          \
    }

#endif
