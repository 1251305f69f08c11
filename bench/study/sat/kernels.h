/* kernels.h: verdicts by separating axes.
 *
 * Two convex polytopes are apart if and only if an axis separates them that is normal to a face of
 * one of them or to an edge of each (Gottschalk, Lin, Manocha 1996). B moving is B plus a segment,
 * whose direction counts as one more edge. All axes are tried, without a branch but for a block
 * whose pairs are all apart already.
 *
 * Errors: docs/error-bounds.md, "Axes".
 *
 * What if A or B is flat? An axis that vanishes has the overlap 0, so meeting is not certain. If
 * none vanishes, each frame spans a plane at least, and each direction in which a face of A - B may
 * look is among the axes; and if all of A - B lies in one plane, then on the normals of A, which
 * are normal to it, both frames have no width. So if all overlaps are positive, 0 is inside A - B,
 * and the relative interiors of A and B meet.
 */
#ifndef FMB_STUDY_SAT_KERNELS_H
#define FMB_STUDY_SAT_KERNELS_H

#include "pair/kernels/packed_kernels.h"
#include "study/sat/plane.h"
#include "study/sat/space.h"

FMB_INLINE fmb_pair_bits sat_bits(const sat_state *s)
{
    return (fmb_pair_bits){lane_bits(lane_and(s->apart, s->known)),
                           lane_bits(lane_and(s->meet, s->known))};
}

/* All lanes are decided: every pair is apart. */
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
    lane error = lane_of(16 * (k.b_simplex ? 12 : 4) * 0x1p-53) * r.reach;
    sat_learn(&s, sat_flat_a(k, &r), error * r.alpha);
    sat_learn(&s, sat_flat_b(k, &r), error * r.beta);
    if (k.moves)
        sat_learn(&s, sat_flat_drift(k, &r), error * (r.beta + r.omega));
    return sat_bits(&s);
}

FMB_INLINE fmb_pair_bits sat_decide(sat_kind k, fmb_asked asked, const double *block)
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
    if (asked == FMB_ASK_FACES)
        return (fmb_pair_bits){sat_bits(&s).apart, 0};
    if (sat_is_over(&s))
        return sat_bits(&s);
    sat_multiply_edges(k, &r, &x);
    if (k.moves)
        sat_learn(&s, sat_swept_b(k, &x), error * r.beta * gamma);
    sat_learn(&s, sat_edges_of_a(k, &x), error * r.alpha * gamma);
    return sat_bits(&s);
}

#endif
