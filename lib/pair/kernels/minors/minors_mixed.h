/* minors_mixed.h: do a simplex and a cuboid of four to six dimensions meet?
 *
 * Here A is the simplex: its rows are the n = D + 1 barycentric coordinates, all times 2 so that
 * those of a point of B are center + sum x_j g_j, |x_j| <= 1, as in minors_kernel.h. Eliminating x
 * is the same, too: k columns S and k + 1 rows R leave the direction y of minors of S in R less r.
 * The values of A's corners along it are 2 y_r, and 0 for the rows that are not in R. With M and m
 * the largest and the least of these y_r and 0, B is beyond A iff
 *
 *     |minor of S, center - (M + m)| > (M - m) + sum over j not in S of |minor of S, j|
 *
 * where the first bars hold the minor of R with the center less M + m. From B, A's corners are
 * compared with B's faces alone: a row of B's frame, where A lasts from least to largest corner.
 *
 * Complete: as in minors_kernel.h, a facet of B - A that keeps 0 out is parallel to p edges of A
 * and q of B, and perhaps the drift (d = 1, else 0), p + q + d = D - 1. All there are levels of q +
 * d columns, and of p + d columns in B's frame. K + K' + 2 > D - 1 + d with K' = 0 is K = D - 2, or
 * D - 1 if the pair moves; there a row without the drift is parallel to D - 1 edges of B, and a
 * face of it. A direction of q columns is parallel to p edges of A iff p + 1 of its y_r and 0s are
 * the same: adding a number to all barycentric coordinates of a direction changes nothing, as they
 * sum to what is constant, and so makes 0 of these; D + 1 - (p + 1) = q + 1 rows R (+ d) are left.
 */
#ifndef FMB_PAIR_MINORS_MIXED_H
#define FMB_PAIR_MINORS_MIXED_H

#include "pair/kernels/minors/minors_rows.h"

typedef struct minors_span {
    lane most, least;
} minors_span;

/* The largest and the least of some numbers and 0. */
FMB_INLINE minors_span minors_no_span(void)
{
    return (minors_span){lane_of(0), lane_of(0)};
}
FMB_INLINE minors_span minors_widen(minors_span s, lane x)
{
    return (minors_span){lane_max(s.most, x), lane_min(s.least, x)};
}

/* The span of a coordinate of a simplex's corners, relative to its origin. */
FMB_INLINE minors_span minors_span_of_corners(minors_kind d, const lane *e)
{
    minors_span s = minors_no_span();
#pragma GCC unroll 8
    for (int j = 0; j < d.dim; j++)
        s = minors_widen(s, e[j]);
    return s;
}

/* The span of the coefficients of a row, negated in odd places. */
FMB_INLINE minors_span minors_span_of_row(int k, const minors_rows *rows, int s)
{
    minors_span even = minors_no_span(), odd = even;
#pragma GCC unroll 5
    for (int i = 0; i <= k; i += 2)
        even = minors_widen(even, rows->less[i][s]);
#pragma GCC unroll 5
    for (int i = 1; i <= k; i += 2)
        odd = minors_widen(odd, rows->less[i][s]);
    return (minors_span){lane_max(even.most, lane_of(0) - odd.least),
                         lane_min(even.least, lane_of(0) - odd.most)};
}

/* The last row: the barycentric coordinates of the center sum to `unit` times 2. */
FMB_INLINE void minors_add_last_barycentric(minors_kind d, minors_view *v)
{
    lane center = v->unit + v->unit;
#pragma GCC unroll 8
    for (int r = 0; r < d.dim; r++)
        center = center - v->center[r];
    v->center[d.dim] = center;
    minors_add_last_row(d, v);
}

#endif
