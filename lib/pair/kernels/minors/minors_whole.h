/* minors_whole.h: for cuboids with integers of few bits, decides cases that errors leave open:
 * parallel edges, and cuboids that touch.
 *
 * Let all numbers of both frames be multiples of a grain; let w, an integer times the grain of A's
 * axes, be such that w times the inverse of these has integers only (record: minors_kernels.h).
 * With unit = w / grain, an integer, coordinates times unit are sums of products of integers:
 * entries, the center, and |z_r| <= unit. So if the computed numbers times unit have errors of less
 * than 1/2, rounding makes them exact. Then all minors and gaps are integers: a gap less than 1 is
 * not positive. Without a positive gap closed cuboids meet, as then no facet of B - A strictly
 * excludes 0; rows that read 0 = 0 have gap 0 and exclude nothing.
 *
 * The errors of gaps remain those of docs/error-bounds.md, with bounds times unit: less than 1/2,
 * they distinguish gaps of 0 from gaps of 1.
 */
#ifndef FMB_PAIR_MINORS_WHOLE_H
#define FMB_PAIR_MINORS_WHOLE_H

#include "pair/kernels/minors/minors_mixed.h"

/* x, with |x| < 2^51, rounded to the nearest integer. */
FMB_INLINE lane minors_nearest(lane x)
{
    const lane high = lane_of(0x1.8p52);
    return (x + high) - high;
}

/* Round a view to integers; returns the lanes where it is exact then. `from`, `to`: records from
 * their sizes on. Few pairs get here: not inlined, and compiled once for all dimensions. */
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
