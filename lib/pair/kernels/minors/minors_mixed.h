/* minors_mixed.h: do a simplex and a cuboid of four to six dimensions meet?
 *
 * With A the simplex, rows are made as in minors_kernel.h, except that z are the D + 1 barycentric
 * coordinates in A, all times 2, so that B is center + sum x_j g_j, |x_j| <= 1. A set R of k + 1
 * rows and a set S of k columns leave the form y of minors of S in R - r. Its value is 2 y_r at
 * corner r of A, and 0 at the corners outside R (there are some, as k < D). With M and m the
 * largest and the least of 0 and all y_r, A reaches from 2 m to 2 M, and y separates A and B iff
 *
 *     |y center - (M + m)| > (M - m) + sum over j not in S of |y g_j|,
 *
 * where y v is the minor of S + v in R. In B's view only B's faces are tested (k = 0), against the
 * least and the largest coordinate of A's corners.
 *
 * Completeness: as in minors_kernel.h, the normal of a facet of B - A that is parallel to p edges
 * of A, q of B and perhaps the drift (d = 1, else 0), p + q + d = D - 1, is a row of q + d columns:
 * y has the same value at the p + 1 corners of a face of A. As barycentric coordinates of
 * directions sum to 0, this value may be subtracted from all of y: then y is 0 at p + 1 corners,
 * and the other D + 1 - (p + 1) = q + d + 1 rows are R. In B's view the row has p + d columns. With
 * K' = 0 all rows are tested if K + 2 > D - 1 + d: K = D - 2, or K = D - 1 if the pair moves; there
 * a row without the drift is parallel to D - 1 edges of B, so it is a face of B.
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
