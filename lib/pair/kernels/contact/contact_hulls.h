/* contact_hulls.h: vectorized loops over hulls of many points: the farthest point in a direction,
 * and the conversion of points to vertices (bodies.h).
 *
 * Products and sums are rounded as in the scalar loops (gjk.c, bodies.c), or fused: later proofs do
 * not depend on how a vertex was found.
 */
#ifndef FMB_PAIR_CONTACT_HULLS_H
#define FMB_PAIR_CONTACT_HULLS_H

#include <math.h>

#include "pair/contact/bodies.h"
#include "pair/kernels/lane/transpose.h"

static int contact_farthest(const double *x, int n, const double *w)
{
    lane most = lane_of(-INFINITY), best = lane_of(0);
    double vertex[FMB_LANES];
    for (int v = 0; v < n; v += FMB_LANES) {
        lane at = lane_load(x + v) * lane_of(w[0]) +
                  lane_load(x + FMB_BODY_MOST + v) * lane_of(w[1]) +
                  lane_load(x + 2 * FMB_BODY_MOST + v) * lane_of(w[2]);
        best = lane_pick(lane_less(most, at), lane_of(v), best);
        most = lane_max(most, at);
    }
    const int first = __builtin_ctz(~lane_bits(lane_less(most, lane_largest(most))));
    lane_store(vertex, best);
    return n > FMB_LANES ? (int)vertex[first] + first : first;
}

/* Vertices v ... of n points, then of `first` alone. */
FMB_INLINE lane contact_place_some(const double *points, int n, int v, const double factor[2],
                                   const double *from, const double *first, double *x, lane most)
{
    static const double number[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    const lane_mask there = lane_less(lane_load(number), lane_of(n - v));
    lane row[3], at[3];
    for (int k = 0; k < 3; k++)
        row[k] = lane_load_some(points + 3 * v + k * FMB_LANES, 3 * (n - v) - k * FMB_LANES);
    transpose_points(row, at);
    for (int j = 0; j < 3; j++) {
        at[j] = at[j] * lane_of(factor[0]) * lane_of(factor[1]) - lane_of(from[j]);
        at[j] = lane_pick(there, at[j], lane_of(first[j]));
        lane_store(x + j * FMB_BODY_MOST + v, at[j]);
        most = lane_max_abs(most, at[j] - lane_of(first[j]));
    }
    return most;
}

static double contact_place(const double *points, int n, const double factor[2], const double *from,
                            const double *first, double *x)
{
    double size[FMB_LANES], longest = 0;
    lane most = lane_of(0);
    for (int v = 0; v <= n; v += FMB_LANES)
        most = contact_place_some(points, n, v, factor, from, first, x, most);
    lane_store(size, most);
    for (int l = 0; l < FMB_LANES; l++)
        longest = size[l] > longest ? size[l] : longest;
    return longest;
}

#endif
