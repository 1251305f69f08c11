/* contact_overlap.h: the overlap of two frames along a normal of flat.h: minus the gap of
 * verdict_flat.h, with fewer operations for cuboids.
 */
#ifndef FMB_PAIR_CONTACT_OVERLAP_H
#define FMB_PAIR_CONTACT_OVERLAP_H

#include "pair/kernels/verdict/verdict_flat.h"

/* Lengths of normals are off by this many u times the sizes of their directions; overlaps by as
 * much as gaps. */
enum { CONTACT_LENGTH_PLANE = 8, CONTACT_LENGTH_SPACE = 32 };

/* Twice the vector from the centre of the cuboid A to that of B. */
FMB_INLINE void contact_between_middles(int dim, const flat_pair *p, lane *out)
{
    for (int j = 0; j < dim; j++) {
        out[j] = p->shift[j] + p->shift[j];
        for (int i = 0; i < dim; i++)
            out[j] = out[j] + (p->direction[FMB_FLAT_MOST_EDGES + i][j] - p->direction[i][j]);
    }
}

/* The overlap of two cuboids along n, and a number that is negative where B lies in the direction
 * of -n. */
FMB_INLINE lane contact_of_cuboids(int dim, const flat_pair *p, const lane *middle, const lane *n,
                                   lane *side)
{
    lane reach = lane_of(0);
#pragma GCC unroll 3
    for (int i = 0; i < dim; i++)
        reach = reach + lane_abs(local_frame_dot(dim, n, p->direction[i])) +
                lane_abs(local_frame_dot(dim, n, p->direction[FMB_FLAT_MOST_EDGES + i]));
    *side = local_frame_dot(dim, n, middle);
    return lane_of(0.5) * (reach - lane_abs(*side));
}

/* That overlap for any frames. */
FMB_INLINE lane contact_of_any(int dim, const fmb_flat_kind *k, const flat_pair *p, const lane *n,
                               lane *side)
{
    flat_spans s = flat_spans_along(dim, k, p, n);
    lane forth = s.a.high - (s.away + s.b.low), back = (s.away + s.b.high) - s.a.low;
    *side = back - forth;
    return lane_min(forth, back);
}

#endif
