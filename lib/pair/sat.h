/* sat.h: verdicts by separating axes.
 *
 * Two convex polytopes are apart if and only if an axis separates them that is normal to a face of
 * one of them or to an edge of each (Gottschalk, Lin, Manocha 1996). B moving is B plus a segment,
 * whose direction counts as one more edge. All axes are tried, without a branch.
 *
 * Errors, with u = 2^-53. A number "good to k by X" is at most X, and off by at most k u X. Sums
 * are good to max(k, k') + 1 by X + X', products to k + k' + 1 by X X'; abs, min, max, doubling
 * and halving cost nothing; terms of u^2 are in what k is rounded up by. front.h: size, shift, e
 * and drift are good to 6.1 by S, C, E and V. Let
 *
 *     R = S + 3 (C + E + V)
 *     L = E + V (CC),  2 E + V (CT),  6 E + 3 V (TT)
 *
 * Then in sat_axes.h a and g are good to 12 by R, and edges and v, with all their coordinates, to
 * 10 by L. The classes of axes:
 *
 * 1. Normals of A. An overlap is a sum of at most five such numbers, 2 R in all, good to 15.
 *
 * 2. Images in a plane. A reaches at most 2 R L, good to 24. B's N_k are good to 15 and their sum
 *    to 18, differences of these to 19; B reaches at most 4 E L <= 4/3 R L (the largest N is 4 E^2
 *    for CC and, as a sum, 6 E^2 for CT and 12 E^2 for TT), and sweeps or reaches along the drift
 *    at most 6 E V <= 2 R L, good to 21. g is at most 2 R L, and 2 R L + 4/3 R L with its three
 *    terms across the edges of a simplex off the corner, good to 26. In all 8 R L, good to 30.
 *
 * 3. Normals of B, drift x edge of B. Their components are at most 2 L^2, good to 18. A reaches at
 *    most 6 R L^2, good to 33. B reaches and sweeps at most 3 R L^2 (its determinant is at most
 *    6 E^3 <= 2 R L^2, a product with v at most 6 E^2 V, and 9 E^2 V with the sum of all normals
 *    of a simplex). g is at most 6 R L^2, good to 36. In all 16 R L^2, good to 40.
 *
 * B flat: axes that vanish overlap by 0, and those that do not are enough. Then, and always, A is
 * not flat, so where all axes overlap, the relative interiors meet.
 */
#ifndef FMB_PAIR_SAT_H
#define FMB_PAIR_SAT_H

#include "pair/kernels.h"
#include "pair/sat_space.h"

/* Overlaps of one class, least of all, each certain to error. */
FMB_INLINE void sat_conclude(lane least, lane error, lane_mask *apart, lane_mask *meet)
{
    *apart = lane_or(*apart, lane_less(least, -error));
    *meet = lane_and(*meet, lane_less(error, least));
}

FMB_INLINE fmb_pair_bits sat_decide(sat_kind k, const double *block)
{
    const double u = 0x1p-53;
    front f = front_of(k.dim, k.moves, block);
    sat s = sat_of(k, &f);
    lane r = f.most_size + lane_of(3) * (f.most_shift + f.most_e + f.most_drift);
    lane l = lane_fma(lane_of(k.a_simplex   ? 6
                              : k.b_simplex ? 2
                                            : 1),
                      f.most_e, lane_of(k.a_simplex ? 3 : 1) * f.most_drift);
    lane error = lane_of(15 * 2 * u) * r;
    lane least = sat_normals_of_a(k, &s);
    lane_mask apart = lane_less(least, -error), meet = lane_less(error, least);
    lane rl = r * l;
    error = lane_of(30 * 8 * u) * rl;
    if (k.dim == 2) {
        sat_conclude(sat_flatland(k, &s), error, &apart, &meet);
    } else {
        sat_products x = sat_multiply(k, &s);
        sat_conclude(sat_faces(k, &s, &x), lane_of(40 * 16 * u) * rl * l, &apart, &meet);
        sat_conclude(sat_edges(k, &s, &x), error, &apart, &meet);
    }
    return (fmb_pair_bits){lane_bits(lane_and(apart, f.known)), lane_bits(lane_and(meet, f.known))};
}

static fmb_pair_bits sat_2d_cc(const double *block)
{
    return sat_decide((sat_kind){2, false, false, false}, block);
}

static fmb_pair_bits sat_2d_ct(const double *block)
{
    return sat_decide((sat_kind){2, false, false, true}, block);
}

static fmb_pair_bits sat_2d_tt(const double *block)
{
    return sat_decide((sat_kind){2, false, true, true}, block);
}

static fmb_pair_bits sat_2d_moving_cc(const double *block)
{
    return sat_decide((sat_kind){2, true, false, false}, block);
}

static fmb_pair_bits sat_2d_moving_ct(const double *block)
{
    return sat_decide((sat_kind){2, true, false, true}, block);
}

static fmb_pair_bits sat_2d_moving_tt(const double *block)
{
    return sat_decide((sat_kind){2, true, true, true}, block);
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

#define FMB_VERDICTS_BY_SAT                                                                        \
    {                                                                                              \
        {{sat_2d_cc, sat_2d_ct, sat_2d_tt},                                                        \
         {sat_2d_moving_cc, sat_2d_moving_ct, sat_2d_moving_tt}},                                  \
        {                                                                                          \
            {sat_3d_cc, sat_3d_ct, sat_3d_tt},                                                     \
            {                                                                                      \
                sat_3d_moving_cc, sat_3d_moving_ct, sat_3d_moving_tt                               \
            }                                                                                      \
        }                                                                                          \
    }

#endif
