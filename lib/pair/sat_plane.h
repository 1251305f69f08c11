/* sat_plane.h: axes across edges of B, in a plane.
 *
 * In the plane these axes are the normals of B. In space, look along an edge of A: it is a point
 * then, A is a square or a triangle, and an axis across an edge b of B is the cross product of both
 * edges. The image along u_i has coordinates (i + 1, i + 2); that along u_i - u_j has (k, 3), as
 * coordinates k and 3 are those that stay the same along this edge. In every image A is the unit
 * square, or triangle, times its size.
 *
 * Seen along anything (an edge of A, the drift), B's corners lie off the line of an edge by
 * products N_k = e_(k+1) x e_(k+2): with the sum N of all three,
 *
 *     edge e_k           0, -N_(k+2), N_(k+1)
 *     edge 3 + m         0, -N_m, -N
 *
 * and a cuboid reaches |N_(k+1)| + |N_(k+2)| from the line of e_k through its centre.
 */
#ifndef FMB_PAIR_SAT_PLANE_H
#define FMB_PAIR_SAT_PLANE_H

#include "pair/sat_axes.h"

/* (p, q) x (r, s) */
FMB_INLINE lane sat_cross(lane p, lane q, lane r, lane s)
{
    return lane_fms(p, s, q * r);
}

/* In space: how far B reaches on each side of the lines of its edges, given N_k and their sum. */
FMB_INLINE void sat_reaches_of_b(sat_kind k, const lane *n, sat_reach *reach)
{
    sat_reach to[4];
    for (int j = 0; j < 3; j++)
        to[j] = k.b_simplex ? sat_to(n[j]) : sat_even(lane_abs(n[j]));
    for (int j = 0; j < 3; j++) {
        sat_reach next = to[(j + 1) % 3], other = to[(j + 2) % 3];
        reach[j] = k.b_simplex ? sat_join(next, sat_flip(other)) : sat_even(next.high + other.high);
    }
    if (!k.b_simplex)
        return;
    to[3] = sat_to(n[3]);
    for (int m = 0; m < 3; m++)
        reach[3 + m] = sat_flip(sat_join(to[m], to[3]));
}

/* The axis across the drift: of B's points from its corner or centre, e_k x v = -sweep[k]. */
FMB_INLINE lane sat_across_drift(sat_kind k, const sat *s, int p, int q, const lane *sweep)
{
    lane g = sat_cross(s->g[p], s->g[q], s->v[p], s->v[q]), sum = lane_of(0);
    sat_reach b = {sum, sum};
    for (int j = 0; j < k.dim; j++) {
        sum = sum + lane_abs(sweep[j]);
        b = k.b_simplex ? sat_join(b, sat_flip(sat_to(sweep[j]))) : sat_even(sum);
    }
    return sat_overlap(k, s->a, sat_reach_across(k, s->v[p], s->v[q]), b, g);
}

/* One image in space: the least overlap on axes across the edges of B, and the drift. n are the
 * N_k seen here, sweep[b] = v x edge b for the edges from the corner. */
FMB_INLINE lane sat_image(sat_kind k, const sat *s, int p, int q, const lane *n, const lane *sweep)
{
    lane least = lane_of(0), g[6], t[6];
    sat_reach b[6];
    sat_reaches_of_b(k, n, b);
    for (int j = 0; j < 3; j++) {
        g[j] = sat_cross(s->g[p], s->g[q], s->e[j][p], s->e[j][q]);
        t[j] = sweep[j];
    }
    for (int m = 0; k.b_simplex && m < 3; m++) {
        g[3 + m] = g[(m + 2) % 3] - g[(m + 1) % 3] + n[m];
        t[3 + m] = t[(m + 2) % 3] - t[(m + 1) % 3];
    }
    for (int j = 0; j < (k.b_simplex ? 6 : 3); j++) {
        sat_reach a = sat_reach_across(k, s->e[j][p], s->e[j][q]);
        lane overlap = sat_overlap(k, s->a, a, b[j], g[j]);
        if (k.moves)
            overlap = overlap + lane_abs(t[j]);
        least = j == 0 ? overlap : lane_min(least, overlap);
    }
    return k.moves ? lane_min(least, sat_across_drift(k, s, p, q, sweep)) : least;
}

/* All axes in the plane but A's normals. Its corners lie off the lines of e_0, e_1 and e_1 - e_0 by
 * -n, n and -n, where n = e_0 x e_1. */
FMB_INLINE lane sat_flatland(sat_kind k, const sat *s)
{
    lane n = sat_cross(s->e[0][0], s->e[0][1], s->e[1][0], s->e[1][1]), least = lane_of(0);
    lane g[3], sweep[3];
    sat_reach b = k.b_simplex ? sat_flip(sat_to(n)) : sat_even(lane_abs(n));
    for (int j = 0; j < 2; j++) {
        g[j] = sat_cross(s->g[0], s->g[1], s->e[j][0], s->e[j][1]);
        sweep[j] = k.moves ? sat_cross(s->v[0], s->v[1], s->e[j][0], s->e[j][1]) : lane_of(0);
    }
    g[2] = g[1] - g[0] + n;
    sweep[2] = sweep[1] - sweep[0];
    for (int j = 0; j < (k.b_simplex ? 3 : 2); j++) {
        sat_reach a = sat_reach_across(k, s->e[j][0], s->e[j][1]);
        lane overlap = sat_overlap(k, s->a, a, j == 1 ? sat_flip(b) : b, g[j]);
        if (k.moves)
            overlap = overlap + lane_abs(sweep[j]);
        least = j == 0 ? overlap : lane_min(least, overlap);
    }
    return k.moves ? lane_min(least, sat_across_drift(k, s, 0, 1, sweep)) : least;
}

#endif
