/* sat_space.h: axes in space.
 *
 * Besides the normals of A: the normals n_k = e_(k+1) x e_(k+2) of B, and their sum for a simplex;
 * edge x edge, in the images of sat_plane.h; edge x drift. All products of two edges of B, or of an
 * edge and the drift, are made once: a component of n_k is what the image along an edge of A sees.
 */
#ifndef FMB_PAIR_SAT_SPACE_H
#define FMB_PAIR_SAT_SPACE_H

#include "pair/sat_plane.h"

typedef struct sat_products {
    lane n[4][3];     /* e_(k+1) x e_(k+2); their sum */
    lane sweep[3][3]; /* v x e_k */
} sat_products;

FMB_INLINE void sat_cross_product(const lane *x, const lane *y, lane *out)
{
    for (int i = 0; i < 3; i++) {
        int p = (i + 1) % 3, q = (i + 2) % 3;
        out[i] = sat_cross(x[p], x[q], y[p], y[q]);
    }
}

FMB_INLINE sat_products sat_multiply(sat_kind k, const sat *s)
{
    sat_products x;
    for (int j = 0; j < 3; j++) {
        sat_cross_product(s->e[(j + 1) % 3], s->e[(j + 2) % 3], x.n[j]);
        for (int i = 0; i < 3; i++)
            x.sweep[j][i] = lane_of(0);
        if (k.moves)
            sat_cross_product(s->v, s->e[j], x.sweep[j]);
    }
    for (int i = 0; i < 3; i++)
        x.n[3][i] = x.n[0][i] + x.n[1][i] + x.n[2][i];
    return x;
}

/* Of x in direction u_i, or u_(i+1) - u_(i+2). */
FMB_INLINE lane sat_component(const lane *x, int i, bool difference)
{
    if (difference)
        return x[(i + 1) % 3] - x[(i + 2) % 3];
    return x[i];
}

/* The image along edge u_i, or u_(i+1) - u_(i+2) of A. */
FMB_INLINE lane sat_along(sat_kind k, const sat *s, const sat_products *x, int i, bool difference)
{
    int p = (i + 1) % 3, q = (i + 2) % 3;
    lane n[4], sweep[3];
    for (int j = 0; j < 4; j++)
        n[j] = sat_component(x->n[j], i, difference);
    for (int j = 0; j < 3; j++)
        sweep[j] = sat_component(x->sweep[j], i, difference);
    return difference ? sat_image(k, s, i, 3, n, sweep) : sat_image(k, s, p, q, n, sweep);
}

/* The least overlap on axes edge x edge, and edge of A x drift. */
FMB_INLINE lane sat_edges(sat_kind k, const sat *s, const sat_products *x)
{
    lane least = sat_along(k, s, x, 0, false);
    least = lane_min(least, sat_along(k, s, x, 1, false));
    least = lane_min(least, sat_along(k, s, x, 2, false));
    if (!k.a_simplex)
        return least;
    least = lane_min(least, sat_along(k, s, x, 0, true));
    least = lane_min(least, sat_along(k, s, x, 1, true));
    return lane_min(least, sat_along(k, s, x, 2, true));
}

/* On the normals of B; tau are their products with v. All edges from the corner have the same
 * product with their normal, or with the sum of the normals: the determinant. */
FMB_INLINE lane sat_normals_of_b(sat_kind k, const sat *s, const sat_products *x, const lane *tau)
{
    lane det = front_dot(3, x->n[0], s->e[0]), least = lane_of(0);
    sat_reach b = k.b_simplex ? sat_to(det) : sat_even(lane_abs(det));
    for (int j = 0; j < (k.b_simplex ? 4 : 3); j++) {
        sat_reach a = sat_reach_of_a(k, x->n[j]);
        lane overlap = sat_overlap(k, s->a, a, b, front_dot(3, x->n[j], s->g));
        if (k.moves)
            overlap = overlap + lane_abs(tau[j]);
        least = j == 0 ? overlap : lane_min(least, overlap);
    }
    return least;
}

/* On axes drift x edge of B: the image of B along the drift, the other way round. */
FMB_INLINE lane sat_swept_faces(sat_kind k, const sat *s, const sat_products *x, const lane *tau)
{
    lane least = lane_of(0), g[6], axis[6][3];
    sat_reach b[6];
    sat_reaches_of_b(k, tau, b);
    for (int j = 0; j < 3; j++) {
        g[j] = front_dot(3, x->sweep[j], s->g);
        for (int i = 0; i < 3; i++)
            axis[j][i] = x->sweep[j][i];
    }
    for (int m = 0; k.b_simplex && m < 3; m++) {
        int from = (m + 1) % 3, to = (m + 2) % 3;
        g[3 + m] = g[to] - g[from] - tau[m];
        for (int i = 0; i < 3; i++)
            axis[3 + m][i] = x->sweep[to][i] - x->sweep[from][i];
    }
    for (int j = 0; j < (k.b_simplex ? 6 : 3); j++) {
        sat_reach a = sat_reach_of_a(k, axis[j]);
        lane overlap = sat_overlap(k, s->a, a, sat_flip(b[j]), g[j]);
        least = j == 0 ? overlap : lane_min(least, overlap);
    }
    return least;
}

/* The least overlap on axes that are products of two edges of B, or of one and the drift. */
FMB_INLINE lane sat_faces(sat_kind k, const sat *s, const sat_products *x)
{
    lane tau[4];
    for (int j = 0; j < 4; j++)
        tau[j] = k.moves ? front_dot(3, x->n[j], s->v) : lane_of(0);
    lane least = sat_normals_of_b(k, s, x, tau);
    return k.moves ? lane_min(least, sat_swept_faces(k, s, x, tau)) : least;
}

#endif
