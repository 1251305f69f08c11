/* space.h: separating axes in space: normals of A, normals of B, edge x edge, drift x edge.
 *
 * With normals n_i = a_(i+1) x a_(i+2) of A (indices modulo 3) and m_k = b_(k+1) x b_(k+2) of B,
 * everything is made of
 *
 *     e_k[i] = n_i b_k              d[i] = n_i d
 *     p_k[i] = m_k a_i              tau[k] = m_k d
 *     w_k[i] = a_i (b_k x d)        t_k[i] = a_i (b_k x centre)
 *
 * A simplex has also the face opposite to its corner: the edges b_(m+2) - b_(m+1) and the normal
 * m_0 + m_1 + m_2. For A the fourth coordinate of an edge, e[3] = - e[0] - e[1] - e[2]: barycentric
 * coordinates are all alike.
 *
 * Edge x edge. Look along an edge of A: it is a point, and every axis across an edge of B is an
 * axis edge x edge. Along a_i we see coordinates p = i + 1, q = i + 2, and, with x_k = x_k[i],
 *
 *     axis a_i x b_k         corners of A off its edge by e_k[p], -e_k[q],
 *                            corners of B by -p_(k+2), p_(k+1); middles apart by t_k
 *     axis a_i x (b_l - b_k) with l = k + 1, m = k + 2: by e_l[p] - e_k[p], -(e_l[q] - e_k[q]),
 *                            by p_m, p_0 + p_1 + p_2; middles apart by t_l - t_k - 2 p_m
 *
 * Along a_p - a_q we see coordinates i and 3, x_k = x_k[p] - x_k[q], and 2 e_k[i] more for t_k.
 *
 * Such an axis matters only where both edges are supported by it: the other corners of A all on one
 * side, those of B all on the other. So each frame's values 0, x, y may be taken to reach from
 * min(x, 0) + min(y, 0) to max(x, 0) + max(y, 0): that is right for a cuboid, and if more than the
 * truth for a simplex, then on an axis that does not matter. The width is |x| + |y| and the middle
 * x + y, for simplices as for cuboids. The same holds of B on an axis drift x (edge of B), and of A
 * on drift x (edge of A).
 */
#ifndef FMB_STUDY_SAT_SPACE_H
#define FMB_STUDY_SAT_SPACE_H

#include "study/sat/axes.h"

typedef struct sat_products {
    lane e[6][4], d[4];
    lane p[4][3], t[3][3], w[3][3], tau[4];
    lane z[3]; /* a_i (d x corner), of two cuboids a_i (d x centre) */
    lane det_a, det_b;
    lane on_a[3], on_b[3]; /* n_i corner (centre), m_k centre (origin) */
    lane on_drift[3];      /* (b_k x d) centre (origin) */
} sat_products;

FMB_INLINE void sat_cross(const lane *x, const lane *y, lane *out)
{
    for (int i = 0; i < 3; i++) {
        int p = (i + 1) % 3, q = (i + 2) % 3;
        out[i] = lane_fms(x[p], y[q], x[q] * y[p]);
    }
}

/* The products of x with each axis of A. */
FMB_INLINE void sat_with_a(const sat_rays *r, const lane *x, lane *out)
{
    for (int i = 0; i < 3; i++)
        out[i] = local_frame_dot(3, r->a[i], x);
}

/* ---- products: for one index each, as the compiler unrolls small loops only -------------------
 */

FMB_INLINE void sat_multiply_normal_of_a(sat_kind k, const sat_rays *r, int i, sat_products *x)
{
    lane n[3];
    sat_cross(r->a[(i + 1) % 3], r->a[(i + 2) % 3], n);
    for (int j = 0; j < 3; j++)
        x->e[j][i] = local_frame_dot(3, n, r->b[j]);
    for (int m = 0; k.b_simplex && m < 3; m++)
        x->e[3 + m][i] = x->e[(m + 2) % 3][i] - x->e[(m + 1) % 3][i];
    x->on_a[i] = local_frame_dot(3, n, k.b_simplex ? r->corner : r->centre);
    if (k.moves)
        x->d[i] = local_frame_dot(3, n, r->drift);
    if (i == 0)
        x->det_a = local_frame_dot(3, n, r->a[0]);
}

FMB_INLINE void sat_multiply_normal_of_b(sat_kind k, const sat_rays *r, int j, sat_products *x)
{
    const lane *from = k.a_simplex ? r->origin : r->centre;
    lane y[3];
    sat_cross(r->b[(j + 1) % 3], r->b[(j + 2) % 3], y);
    sat_with_a(r, y, x->p[j]);
    x->on_b[j] = local_frame_dot(3, y, from);
    if (j == 0)
        x->det_b = local_frame_dot(3, y, r->b[0]);
    if (k.moves)
        x->tau[j] = local_frame_dot(3, y, r->drift);
}

FMB_INLINE void sat_multiply_edge(sat_kind k, const sat_rays *r, int j, sat_products *x)
{
    lane y[3];
    sat_cross(r->b[j], r->centre, y);
    sat_with_a(r, y, x->t[j]);
    if (!k.moves)
        return;
    sat_cross(r->b[j], r->drift, y);
    sat_with_a(r, y, x->w[j]);
    x->on_drift[j] = local_frame_dot(3, y, k.a_simplex ? r->origin : r->centre);
}

/* The products of the normals of A. */
FMB_INLINE void sat_multiply_a(sat_kind k, const sat_rays *r, sat_products *x)
{
    sat_multiply_normal_of_a(k, r, 0, x);
    sat_multiply_normal_of_a(k, r, 1, x);
    sat_multiply_normal_of_a(k, r, 2, x);
    for (int j = 0; k.a_simplex && j < 6; j++)
        x->e[j][3] = -(x->e[j][0] + x->e[j][1] + x->e[j][2]);
    if (k.moves)
        x->d[3] = -(x->d[0] + x->d[1] + x->d[2]);
}

/* The products of the normals of B. */
FMB_INLINE void sat_multiply_b(sat_kind k, const sat_rays *r, sat_products *x)
{
    sat_multiply_normal_of_b(k, r, 0, x);
    sat_multiply_normal_of_b(k, r, 1, x);
    sat_multiply_normal_of_b(k, r, 2, x);
    for (int i = 0; i < 3; i++)
        x->p[3][i] = x->p[0][i] + x->p[1][i] + x->p[2][i];
    if (k.moves)
        x->tau[3] = x->tau[0] + x->tau[1] + x->tau[2];
}

/* The products of the edges of B and of the drift. */
FMB_INLINE void sat_multiply_edges(sat_kind k, const sat_rays *r, sat_products *x)
{
    sat_multiply_edge(k, r, 0, x);
    sat_multiply_edge(k, r, 1, x);
    sat_multiply_edge(k, r, 2, x);
    if (k.moves) {
        lane y[3];
        sat_cross(r->drift, k.b_simplex ? r->corner : r->centre, y);
        sat_with_a(r, y, x->z);
    }
}

/* ---- normals --------------------------------------------------------------------------------- */

/* On normal i of A; B spans e_k[i] there. The values of the fourth one are det A less the sum of
 * the others. */
FMB_INLINE lane sat_on_normal_of_a(sat_kind k, const sat_products *x, int i)
{
    lane edge[3], apart = x->on_a[i % 3];
    for (int j = 0; j < 3; j++)
        edge[j] = x->e[j][i];
    if (i == 3)
        apart = lane_fms(lane_of(2), x->det_a, x->on_a[0] + x->on_a[1] + x->on_a[2]);
    sat_span b = sat_span_of_frame(k.b_simplex, 3, edge);
    if (k.b_simplex)
        apart = apart - b.middle;
    lane overlap = lane_abs(x->det_a) + b.width - lane_abs(apart);
    if (k.moves)
        overlap = overlap + lane_abs(x->d[i]);
    return overlap;
}

/* On normal j of B; A spans p_j[i] there. */
FMB_INLINE lane sat_on_normal_of_b(sat_kind k, const sat_products *x, int j)
{
    lane apart = x->on_b[j % 3];
    if (j == 3)
        apart = lane_fma(lane_of(2), x->det_b, x->on_b[0] + x->on_b[1] + x->on_b[2]);
    sat_span a = sat_span_of_frame(k.a_simplex, 3, x->p[j]);
    if (k.a_simplex)
        apart = apart + a.middle;
    lane overlap = lane_abs(x->det_b) + a.width - lane_abs(apart);
    if (k.moves)
        overlap = overlap + lane_abs(x->tau[j]);
    return overlap;
}

/* On (edge j of B) x drift; A spans w_k[i] there, and B is seen along the drift. */
FMB_INLINE lane sat_on_swept(sat_kind k, const sat_products *x, int j)
{
    int m = j % 3, next = (m + 1) % 3, other = (m + 2) % 3;
    lane across[3], apart = x->on_drift[m], width = lane_abs(x->tau[m]) + lane_abs(x->tau[3]);
    for (int i = 0; i < 3; i++) {
        across[i] = x->w[m][i];
        if (j >= 3)
            across[i] = x->w[other][i] - x->w[next][i];
    }
    if (j < 3)
        width = lane_abs(x->tau[next]) + lane_abs(x->tau[other]);
    else
        apart = lane_fma(lane_of(2), x->tau[m], x->on_drift[other] - x->on_drift[next]);
    sat_span a = sat_span_of_frame(k.a_simplex, 3, across);
    if (k.a_simplex)
        apart = apart + a.middle;
    return a.width + width - lane_abs(apart);
}

/* The least overlaps. */
FMB_INLINE lane sat_normals_of_a(sat_kind k, const sat_products *x)
{
    lane least = sat_on_normal_of_a(k, x, 0);
    least = lane_min(least, sat_on_normal_of_a(k, x, 1));
    least = lane_min(least, sat_on_normal_of_a(k, x, 2));
    return k.a_simplex ? lane_min(least, sat_on_normal_of_a(k, x, 3)) : least;
}

FMB_INLINE lane sat_normals_of_b(sat_kind k, const sat_products *x)
{
    lane least = sat_on_normal_of_b(k, x, 0);
    least = lane_min(least, sat_on_normal_of_b(k, x, 1));
    least = lane_min(least, sat_on_normal_of_b(k, x, 2));
    return k.b_simplex ? lane_min(least, sat_on_normal_of_b(k, x, 3)) : least;
}

FMB_INLINE lane sat_swept_b(sat_kind k, const sat_products *x)
{
    lane least = sat_on_swept(k, x, 0);
    least = lane_min(least, sat_on_swept(k, x, 1));
    least = lane_min(least, sat_on_swept(k, x, 2));
    if (!k.b_simplex)
        return least;
    least = lane_min(least, sat_on_swept(k, x, 3));
    least = lane_min(least, sat_on_swept(k, x, 4));
    return lane_min(least, sat_on_swept(k, x, 5));
}

/* ---- edges of A ------------------------------------------------------------------------------ */

/* What is seen along an edge of A: coordinates p and q of edges. */
typedef struct sat_image {
    int p, q;
    lane n[4], t[3], w[3], z;
} sat_image;

/* x[i], or x[i + 1] - x[i + 2] */
FMB_INLINE lane sat_seen(const lane *x, int i, bool difference)
{
    if (difference)
        return x[(i + 1) % 3] - x[(i + 2) % 3];
    return x[i];
}

/* Along a_i, or a_(i+1) - a_(i+2). */
FMB_INLINE void sat_look(sat_kind k, const sat_products *x, int i, bool difference, sat_image *m)
{
    m->p = difference ? i : (i + 1) % 3;
    m->q = difference ? 3 : (i + 2) % 3;
    for (int j = 0; j < 4; j++)
        m->n[j] = sat_seen(x->p[j], i, difference);
    for (int j = 0; j < 3; j++) {
        m->t[j] = sat_seen(x->t[j], i, difference);
        if (difference)
            m->t[j] = lane_fma(lane_of(2), x->e[j][i], m->t[j]);
        if (k.moves)
            m->w[j] = sat_seen(x->w[j], i, difference);
    }
    if (k.moves)
        m->z = sat_seen(x->z, i, difference);
    if (k.moves && difference)
        m->z = lane_fma(lane_of(2), x->d[i], m->z);
}

/* On the axis across edge j of B. */
FMB_INLINE lane sat_across_edge(sat_kind k, const sat_products *x, const sat_image *m, int j)
{
    int i = j % 3, next = (i + 1) % 3, other = (i + 2) % 3;
    bool touches = j < 3; /* the corner of B */
    lane width = lane_abs(x->e[j][m->p]) + lane_abs(x->e[j][m->q]);
    width = width + lane_abs(m->n[touches ? next : i]) + lane_abs(m->n[touches ? other : 3]);
    if (k.moves && touches)
        width = width + lane_abs(m->w[i]);
    if (k.moves && !touches)
        width = width + lane_abs(m->w[other] - m->w[next]);
    if (touches)
        return width - lane_abs(m->t[i]);
    return width - lane_abs(lane_fma(lane_of(-2), m->n[i], m->t[other] - m->t[next]));
}

/* On the axis across the drift; B spans -w_k there. */
FMB_INLINE lane sat_across_drift(sat_kind k, const sat_products *x, const sat_image *m)
{
    sat_span b = sat_span_of_frame(k.b_simplex, 3, m->w);
    lane apart = m->z, width = lane_abs(x->d[m->p]) + lane_abs(x->d[m->q]) + b.width;
    if (k.b_simplex)
        apart = apart + b.middle;
    return width - lane_abs(apart);
}

FMB_INLINE lane sat_along(sat_kind k, const sat_products *x, int i, bool difference)
{
    sat_image m;
    sat_look(k, x, i, difference, &m);
    lane least = sat_across_edge(k, x, &m, 0);
    least = lane_min(least, sat_across_edge(k, x, &m, 1));
    least = lane_min(least, sat_across_edge(k, x, &m, 2));
    if (k.b_simplex) {
        least = lane_min(least, sat_across_edge(k, x, &m, 3));
        least = lane_min(least, sat_across_edge(k, x, &m, 4));
        least = lane_min(least, sat_across_edge(k, x, &m, 5));
    }
    return k.moves ? lane_min(least, sat_across_drift(k, x, &m)) : least;
}

/* On axes (edge of A) x (edge of B), and (edge of A) x drift. */
FMB_INLINE lane sat_edges_of_a(sat_kind k, const sat_products *x)
{
    lane least = sat_along(k, x, 0, false);
    least = lane_min(least, sat_along(k, x, 1, false));
    least = lane_min(least, sat_along(k, x, 2, false));
    if (!k.a_simplex)
        return least;
    least = lane_min(least, sat_along(k, x, 0, true));
    least = lane_min(least, sat_along(k, x, 1, true));
    return lane_min(least, sat_along(k, x, 2, true));
}

#endif
