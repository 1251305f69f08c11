/* box_hull.h: the hull of points in the world, in coordinates of B, and in time.
 *
 * A lane where there is no point has NaN in its place: lane_min(x, y) is y where x is a NaN (x < y
 * ? x : y), on every processor, and so is lane_max.
 */
#ifndef FMB_PAIR_BOX_HULL_H
#define FMB_PAIR_BOX_HULL_H

#include "pair/kernels/box/box_view.h"

/* Is there no point in any lane? */
FMB_BOX_INLINE bool box_is_nowhere(lane x)
{
    return lane_bits(lane_less(-lane_of(HUGE_VAL), x)) == 0;
}

typedef struct box_hull {
    lane world[2][3], inside[2][3], time[2]; /* lower, upper */
    lane sum[3], points;                     /* of points in the world; their mean is the witness */
    lane gap, inside_gap; /* bounds of how far an end exceeds the exact one: for a parameter of an
                             edge or of time, and for a coordinate in B */
} box_hull;

FMB_BOX_INLINE void box_hull_empty(box_hull *h)
{
    const lane most = lane_of(HUGE_VAL), least = lane_of(-HUGE_VAL), zero = lane_of(0);
    h->points = h->gap = h->inside_gap = zero;
    for (int j = 0; j < 3; j++) {
        h->world[0][j] = h->inside[0][j] = most;
        h->world[1][j] = h->inside[1][j] = least;
        h->sum[j] = zero;
    }
    h->time[0] = most;
    h->time[1] = least;
}

FMB_BOX_INLINE void box_cover(lane x, lane *lower, lane *upper)
{
    *lower = lane_min(x, *lower);
    *upper = lane_max(x, *upper);
}

/* The points from + s along, with s at most `half` from `middle`. */
FMB_BOX_INLINE void box_cover_span(lane from, lane along, lane middle, lane half, lane *lower,
                                   lane *upper)
{
    lane at = lane_fma(middle, along, from), far = half * lane_abs(along);
    *lower = lane_min(at - far, *lower);
    *upper = lane_max(at + far, *upper);
}

/* Cover these points in the world. */
FMB_BOX_INLINE void box_cover_world(const box_kind *k, box_hull *h, const lane *from,
                                    const lane *along, lane middle, lane half)
{
    const lane_mask some = lane_less(lane_of(-1), middle);
    for (int j = 0; j < k->dim; j++) {
        box_cover_span(from[j], along[j], middle, half, &h->world[0][j], &h->world[1][j]);
        h->sum[j] = lane_pick(some, h->sum[j] + lane_fma(middle, along[j], from[j]), h->sum[j]);
    }
    h->points = lane_pick(some, h->points + lane_of(1), h->points);
}

/* Cover coordinates in B of points on an edge of B: from + s along, both integers. */
FMB_BOX_INLINE void box_cover_own(const box_kind *k, box_hull *h, const int *from, const int *along,
                                  lane lo, lane hi)
{
    const lane some = lo - lo;
    for (int j = 0; j < k->dim; j++) {
        lane *lower = &h->inside[0][j], *upper = &h->inside[1][j];
        if (along[j] > 0) {
            *lower = lane_min(lo, *lower);
            *upper = lane_max(hi, *upper);
        } else if (along[j] < 0) {
            *lower = lane_min(lane_of(1) - hi, *lower);
            *upper = lane_max(lane_of(1) - lo, *upper);
        } else {
            box_cover(some + lane_of(from[j]), lower, upper);
        }
    }
}

/* Corner c of a frame in its own coordinates. */
FMB_BOX_INLINE void box_own_corner(const box_kind *k, int guest, int c, int *own)
{
    for (int j = 0; j < k->dim; j++)
        own[j] = k->shape[guest] == FMB_SIMPLEX ? c == j + 1 : c >> j & 1;
}

#endif
