/* contact_farthest.h: which of many points is farthest in a direction, several at a time.
 *
 * Products and sums are rounded as those of the loop over one after another (gjk.c) are, or fused:
 * what follows does not ask how a vertex was found.
 */
#ifndef FMB_PAIR_CONTACT_FARTHEST_H
#define FMB_PAIR_CONTACT_FARTHEST_H

#include <math.h>

#include "pair/contact/bodies.h"
#include "pair/kernels/lane/lane.h"

static int contact_farthest(const double *x, int n, const double *w)
{
    lane most = lane_of(-INFINITY), best = lane_of(0);
    double along[FMB_LANES], vertex[FMB_LANES];
    for (int v = 0; v < n; v += FMB_LANES) {
        lane at = lane_load(x + v) * lane_of(w[0]) +
                  lane_load(x + FMB_BODY_MOST + v) * lane_of(w[1]) +
                  lane_load(x + 2 * FMB_BODY_MOST + v) * lane_of(w[2]);
        best = lane_pick(lane_less(most, at), lane_of(v), best);
        most = lane_max(most, at);
    }
    lane_store(along, most);
    lane_store(vertex, best);
    FMB_UNROLL
    for (int half = FMB_LANES / 2; half > 0; half /= 2)
        FMB_UNROLL
    for (int k = 0; k < half; k++)
        along[k] = along[k + half] > along[k] ? along[k + half] : along[k];
    int first = __builtin_ctz(~lane_bits(lane_less(most, lane_of(along[0]))));
    return (int)vertex[first] + first;
}

#endif
