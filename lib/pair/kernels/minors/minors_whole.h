/* minors_whole.h: cuboids whose numbers are whole, of few bits, decide what errors leave open: that
 * edges are parallel, or that the two touch.
 *
 * Let all numbers of both frames be multiples of a grain; let w, a whole number times the grain of
 * A's axes, be such that w times the inverse of these is whole (record: minors_kernels.h). With
 * unit = w / grain, a whole number, coordinates times unit are sums of products of whole numbers:
 * entries, the center, and |z_r| <= unit. So where what was computed times unit is off by less than
 * 1/2, rounding finds them. Then all minors are whole, and all gaps: one that is less than 1 is
 * none. Without a positive gap closed cuboids meet, as then no facet of B - A keeps 0 out strictly;
 * rows that are 0 = 0 say nothing, and their gap is 0.
 *
 * The errors of gaps remain those of docs/error-bounds.md, with bounds times unit: less than 1/2,
 * they tell gaps of 0 from those of 1.
 */
#ifndef FMB_PAIR_MINORS_WHOLE_H
#define FMB_PAIR_MINORS_WHOLE_H

#include "pair/kernels/minors/minors_mixed.h"

/* |x| < 2^51, to the next whole number. */
FMB_INLINE lane minors_nearest(lane x)
{
    const lane high = lane_of(0x1.8p52);
    return (x + high) - high;
}

/* What is seen becomes whole, where that is certain; `from` and `to`: what records have behind
 * their sizes. Few pairs get here: not in the kernels, and once for all dimensions. */
static FMB_NEVER_CLONED lane_mask minors_round(minors_kind d, const lane *from, const lane *to,
                                               minors_view *v)
{
    const lane grain = lane_min(from[2], to[2]);
    const lane_mask whole = lane_less(lane_of(0), grain);
    const lane error = lane_of(1.01 * 0x1p-53 * minors_center_error(d));
    lane most = lane_of(0);
    v->unit = lane_pick(whole, from[1], lane_of(1)) / lane_pick(whole, grain, lane_of(1));
    for (int r = 0; r < d.dim; r++) {
        v->g[r] = v->g[r] * v->unit;
        v->center[r] = minors_nearest(v->center[r] * v->unit);
        for (int j = 0; j < d.n; j++)
            v->e[r * d.n + j] = minors_nearest(v->e[r * d.n + j] * v->unit);
        most = lane_max(most, error * v->g[r]);
    }
    if (d.from_simplex)
        minors_add_last_barycentric(d, v);
    return lane_and(whole, lane_less(most, lane_of(0.5)));
}

#endif
