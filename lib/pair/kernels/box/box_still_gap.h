/* box_still_gap.h: bounds of how far ends of boxes exceed the exact ones, for frames that do not
 * move.
 *
 * An end of a part (box_still_edges.h) moved in by 2 margin_i is certainly within the exact part,
 * if the part is not empty then. So if a part is empty, the exact one is, too; and if it is longer
 * than 2^-36 while no end moves by more than 2^-38, there is an exact one. Parts in between are
 * undecided. Ends exceed the exact ones by at most `gap`, the largest 2 margin_i over the values i
 * that may cut off anything: those where some y_i comes within |d_i| + 2 wide_i of a bound (for a
 * cuboid ||y_i| - half| = |y_i^2 - half^2| / (|y_i| + half)). That is good enough in most lanes; if
 * it is not, an edge is nearly parallel to a face. One unit of wide_i is left for rounding.
 *
 * Ends of boxes exceed the exact ones by:
 * - in the world gap |edge|, and roundings (box_still.h);
 * - in B's coordinates gap for edges of B, and 8 u for the rounding of 1 - s;
 * - and (gap |d_j| + 2 wide_j) / size for edges of A, as points y_j + s d_j are off by wide_j, and
 *   8 u for the quotient.
 * `excess` is the largest of these (and of gap, to compare it with 2^-38) as a part of what is
 * allowed.
 */
#ifndef FMB_PAIR_BOX_STILL_GAP_H
#define FMB_PAIR_BOX_STILL_GAP_H

#include "pair/kernels/box/box_still_edges.h"

/* Reciprocals of what is allowed: of gap |edge| in the world, of gap |d_j| for edges of A. */
typedef struct still_limits {
    lane world, guest;
} still_limits;

/* The least |y_i|, or |y_i^2 - half^2|, over these corners. */
FMB_BOX_INLINE lane still_distance(const box_kind *k, lane half, int corners, lane y[][BOX_VALUES],
                                   int i)
{
    lane least = lane_of(HUGE_VAL);
    FMB_UNROLL
    for (int c = 0; c < corners; c++) {
        lane from = y[c][i];
        if (k->shape[STILL_HOST] == FMB_CUBOID)
            from = lane_abs(from) - half;
        least = lane_min_abs(least, from);
    }
    return least;
}

FMB_BOX_INLINE lane still_weight(const box_kind *k, bool own, const still_direction *e,
                                 const still_limits *limit)
{
    lane far = e->far[0], most = lane_abs(e->d[0]);
    FMB_UNROLL
    for (int j = 1; j < k->dim; j++) {
        far = lane_max(far, e->far[j]);
        most = lane_max_abs(most, e->d[j]);
    }
    lane world = (far + far) * limit->world;
    if (own)
        return lane_max(world, lane_of(1 / 9.9e-13));
    return lane_max(world, lane_max(most * limit->guest, lane_of(0x1p38)));
}

/* A direction whose edges start at corners with values y. */
FMB_BOX_INLINE void still_measure(const box_kind *k, bool own, const still_view *v,
                                  const still_direction *e, const still_slabs *b, int corners,
                                  lane y[][BOX_VALUES], const still_limits *limit, still_hull *h)
{
    lane margin = lane_of(0);
    FMB_UNROLL
    for (int i = 0; i < box_values(k, STILL_HOST); i++) {
        lane near = lane_fma(lane_of(3), v->wide[i], lane_abs(e->d[i]));
        lane_mask cuts = lane_less(still_distance(k, v->half, corners, y, i), near);
        margin = lane_max_where(cuts, margin, b->margin[i]);
    }
    h->excess = lane_max((margin + margin) * still_weight(k, own, e, limit), h->excess);
}

FMB_BOX_INLINE lane still_most(int n, const lane *x)
{
    lane most = x[0];
    FMB_UNROLL
    for (int i = 1; i < n; i++)
        most = lane_max(x[i], most);
    return most;
}

#endif
