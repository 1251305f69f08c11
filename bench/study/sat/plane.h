/* plane.h: separating axes in the plane: the normals of the edges of A, of B, and of the drift.
 *
 * The value of x on the normal of r is r x x. With X_ik = a_i x b_k, an edge a_i spans det A itself
 * and B spans 0, X_i0, X_i1; an edge b_k spans det B, and A spans 0, -X_0k, -X_1k. The third edge
 * a_1 - a_0 of a simplex goes from a_0, so its middle is other than that of a cuboid by det A.
 */
#ifndef FMB_STUDY_SAT_PLANE_H
#define FMB_STUDY_SAT_PLANE_H

#include "study/sat/axes.h"

FMB_INLINE lane sat_flat_cross(const lane *x, const lane *y)
{
    return lane_fms(x[0], y[1], x[1] * y[0]);
}

/* On the normals of the edges of A. */
FMB_INLINE lane sat_flat_a(sat_kind k, const sat_rays *r)
{
    lane det = sat_flat_cross(r->a[0], r->a[1]), least = lane_of(0), on[3][4];
    for (int i = 0; i < 2; i++) {
        on[i][0] = sat_flat_cross(r->a[i], r->b[0]);
        on[i][1] = sat_flat_cross(r->a[i], r->b[1]);
        on[i][2] = sat_flat_cross(r->a[i], k.b_simplex ? r->corner : r->centre);
        on[i][3] = k.moves ? sat_flat_cross(r->a[i], r->drift) : lane_of(0);
    }
    for (int j = 0; j < 4; j++)
        on[2][j] = on[1][j] - on[0][j];
    on[2][2] = on[2][2] + det;
    for (int i = 0; i < (k.a_simplex ? 3 : 2); i++) {
        sat_span b = sat_span_of_frame(k.b_simplex, 2, on[i]);
        lane overlap = lane_abs(det) + b.width - lane_abs(on[i][2] - b.middle);
        if (k.moves)
            overlap = overlap + lane_abs(on[i][3]);
        least = i == 0 ? overlap : lane_min(least, overlap);
    }
    return least;
}

/* On the normals of the edges of B. */
FMB_INLINE lane sat_flat_b(sat_kind k, const sat_rays *r)
{
    lane det = sat_flat_cross(r->b[0], r->b[1]), least = lane_of(0), on[3][4];
    for (int i = 0; i < 2; i++) {
        on[i][0] = sat_flat_cross(r->b[i], r->a[0]);
        on[i][1] = sat_flat_cross(r->b[i], r->a[1]);
        on[i][2] = sat_flat_cross(r->b[i], k.a_simplex ? r->origin : r->centre);
        on[i][3] = k.moves ? sat_flat_cross(r->b[i], r->drift) : lane_of(0);
    }
    for (int j = 0; j < 4; j++)
        on[2][j] = on[1][j] - on[0][j];
    on[2][2] = on[2][2] - det;
    for (int i = 0; i < (k.b_simplex ? 3 : 2); i++) {
        sat_span a = sat_span_of_frame(k.a_simplex, 2, on[i]);
        lane overlap = lane_abs(det) + a.width - lane_abs(on[i][2] + a.middle);
        if (k.moves)
            overlap = overlap + lane_abs(on[i][3]);
        least = i == 0 ? overlap : lane_min(least, overlap);
    }
    return least;
}

/* On the normal of the drift. */
FMB_INLINE lane sat_flat_drift(sat_kind k, const sat_rays *r)
{
    const lane *from = k.a_simplex ? r->origin : k.b_simplex ? r->corner : r->centre;
    lane a[2], b[2], distance = sat_flat_cross(r->drift, from);
    for (int i = 0; i < 2; i++) {
        a[i] = sat_flat_cross(r->drift, r->a[i]);
        b[i] = sat_flat_cross(r->drift, r->b[i]);
    }
    if (k.a_simplex)
        distance = distance + (b[0] + b[1]);
    sat_span x = sat_span_of_frame(k.a_simplex, 2, a), y = sat_span_of_frame(k.b_simplex, 2, b);
    return x.width + y.width - lane_abs(distance + x.middle - y.middle);
}

#endif
