/* fmb_simplices.h: does a simplex meet a cuboid or a simplex, in the plane or in space? See
 * docs/theory.md, "Pairs". */
#ifndef FMB_PAIR_FMB_SIMPLICES_H
#define FMB_PAIR_FMB_SIMPLICES_H

#include "pair/fmb_gaps.h"

/* B is the simplex v, v + e_0, ..., moving by t drift. A is either the cube |y_i| <= half, with y
 * measured from its center, or the simplex of y_i >= 0 with sum size over one more coordinate, the
 * last, which all of B has as well.
 *
 * Rows of B, in space: w_p = e_q x e_r with (p, q, r) = (0, 1, 2) or turned round, and w_3 = -(w_0
 * + w_1 + w_2); with the sign of det B, w_p (y - v) >= 0, and >= -|det B| for w_3. (In the plane:
 * w_0 = e_1, w_1 = -e_0, each turned by a right angle.)
 *
 * Eliminating a direction d from two rows p, q of opposite a_p = w_p d leaves the row along the
 * edge that the two faces share: a_p w_q - a_q w_p = det B (e_r x d), for p, q < 3. So no row needs
 * to be formed: with u = e_r x d, the row says that u, with the sign of a_p, is least on B at v. At
 * the other two vertices e_q, e_p it is a_p, -a_q more: whence the signs. From rows 3 and p comes u
 * = (e_r - e_q) x d, least at v + e_q with the sign of a_3: at v and e_p it is -a_p, a_3 more. In
 * coordinates k, l of A's frame, d being an edge of A along which these are constant, u y is x_l
 * y_k - x_k y_l for the edge x of B; and where d is the drift, u is x x drift. That is how time is
 * eliminated; if time remains, the earliest or the latest B counts, so min(0, u drift) is added.
 *
 * Complete: A and B meet in interiors unless a facet of the set of all b + t drift - a keeps 0 out.
 * Two edges, of A or of B, or one and the drift, are parallel to the facet. Both of A: a row of A.
 * Both of B: a row of B, as det B is certain. One of each: eliminate that edge of A; the facet is
 * not along a face of B (or it is a row of B), so the two rows of B at the edge of B have opposite
 * signs. An edge of B and the drift: likewise. An edge of A and the drift: the row along both,
 * where nothing is known of signs, so both sides of A and B are compared.
 *
 * Signs: where that of some a_p is uncertain, no verdict is "meet". "Apart" is right all the same:
 * if the sign of a_p is wrong then B is below the row by at most |a_p|, so by at most its error.
 *
 * Errors: in sums, X = H + S + E + V, which is at least any of v, v + e, ... over the first
 * coordinates, and 3 X over the last. Counts: v 9.1 (3 H + S), e and drift over the last
 * coordinate 8.1 (3 E), differences of edges 9.1 (6 E).
 *   A's rows: 3 X; lowest or highest of B 11.1, the gap 12.1.
 *   a_p: 4 E^2, 15.2; a_3: 12 E^2, 17.2.
 *   u v: 6 E (3 H + S), 19.2; over a difference twice that and 4 E^2, 21.2; at t = 1 with 3 H + 3 V
 *     for 3 H, 22.2. A's reach: 6 E S, 16.2. The gap: 36 E (H + V) + 18 E S + 4 E^2 <= 36 E X,
 * count 23.2. With the error of a wrong sign, 17.2 * 12 E^2: at most (835.2 + 206.4) E X. drift x
 * d: u v: 6 V (3 H + S), 19.2; edges: 18 E V; A: 3 V S. In all 18 V X, count 22.2. B's rows: w_p: 2
 * E^2, 14.2; w_3: 6 E^2, 16.2; w_p v: 6 E^2 (H + S), 24.3; w_3 v: 18 E^2 (H + S), 26.3; times the
 * drift: 18 E^2 V, 26.3; det B: 6 E^3, 23.3; A's reach: 18 E^2 S, 26.3. The gap: 36 E^2 X,
 * count 29.3; with a wrong sign of det B 1195 E^2 X. Rows along the drift: e x drift: 2 E V, 14.2,
 * or 4 E V, 15.2; times v: 6 E V (H + S), 24.3, of differences 12 E V (H + S) + 6 E^2 V, 26.3; A's
 * reach: 12 E V S, 24.3. The gap: 24 E V X, count 27.3. Signs: w_p drift: 6 E^2 V, 23.3, and 18 E^2
 * V, 25.3 for w_3: at most (655.2 + 455.4) E V X. In the plane the same bounds hold by far.
 */
typedef struct fmb_simplices {
    lane reach;                           /* half, or size */
    lane v[4], e[3][4], drift[4], end[4]; /* end = v + drift */
    lane w[4][3], det;
    lane bound; /* X */
} fmb_simplices;

FMB_INLINE lane fmb_sum(const lane *x, int n)
{
    lane sum = x[0];
    for (int i = 1; i < n; i++)
        sum = sum + x[i];
    return sum;
}

FMB_INLINE fmb_simplices fmb_simplices_of(fmb_kind kind, const front *f)
{
    const int dim = kind.dim;
    fmb_simplices c;
    c.reach = f->size;
    if (!kind.simplex)
        c.reach = lane_of(0.5) * f->size;
    for (int i = 0; i < dim; i++) {
        c.v[i] = f->shift[i];
        if (!kind.simplex)
            c.v[i] = c.v[i] - c.reach;
        c.drift[i] = lane_of(0);
        if (kind.moves)
            c.drift[i] = f->drift[i];
        for (int k = 0; k < dim; k++)
            c.e[k][i] = f->e[k][i];
    }
    if (kind.simplex) {
        c.v[dim] = f->size - fmb_sum(c.v, dim);
        c.drift[dim] = -fmb_sum(c.drift, dim);
        for (int k = 0; k < dim; k++)
            c.e[k][dim] = -fmb_sum(c.e[k], dim);
    }
    for (int i = 0; i < dim + kind.simplex; i++)
        c.end[i] = c.v[i] + c.drift[i];
    c.bound = (f->most_shift + f->most_size) + (f->most_e + f->most_drift);
    return c;
}

/* A's rows: the largest gap. */
FMB_INLINE lane fmb_simplices_faces(fmb_kind kind, const fmb_simplices *c)
{
    const lane zero = lane_of(0);
    lane most = lane_of(-INFINITY);
    for (int i = 0; i < kind.dim + kind.simplex; i++) {
        lane low = zero, high = zero;
        for (int k = 0; k < kind.dim; k++) {
            low = lane_min(low, c->e[k][i]);
            high = lane_max(high, c->e[k][i]);
        }
        low = lane_min(c->v[i], c->end[i]) + low;
        high = lane_max(c->v[i], c->end[i]) + high;
        if (kind.simplex)
            most = lane_max(most, -high);
        else
            most = lane_max(most, lane_max(low, -high) - c->reach);
    }
    return most;
}

/* The largest value over A of the row with the coefficients w, with the sign of s. */
FMB_INLINE lane fmb_simplices_most(fmb_kind kind, const lane *w, lane s)
{
    lane most = kind.simplex ? lane_of(0) : lane_abs(w[0]);
    for (int i = 0; kind.simplex && i < kind.dim; i++)
        most = lane_max(most, lane_times_sign(w[i], s));
    for (int i = 1; !kind.simplex && i < kind.dim; i++)
        most = most + lane_abs(w[i]);
    return most;
}

/* ... of the row w, which is away at v and moves by along until t = 1, with the sign of s. */
FMB_INLINE lane fmb_simplices_row(fmb_kind kind, const fmb_simplices *c, const lane *w, lane away,
                                  lane along, lane s)
{
    lane least = lane_times_sign(away, s);
    if (kind.moves)
        least = least + lane_min(lane_times_sign(along, s), lane_of(0));
    return lane_fnma(c->reach, fmb_simplices_most(kind, w, s), least);
}

/* B's rows: their coefficients, and the largest gap. */
FMB_INLINE lane fmb_simplices_sides(fmb_kind kind, fmb_simplices *c)
{
    int n = kind.dim;
    if (n == 3) {
        for (int p = 0; p < 3; p++)
            fmb_cross(c->e[(p + 1) % 3], c->e[(p + 2) % 3], c->w[p]);
    } else {
        c->w[0][0] = c->e[1][1];
        c->w[0][1] = -c->e[1][0];
        c->w[1][0] = -c->e[0][1];
        c->w[1][1] = c->e[0][0];
    }
    c->det = front_dot(n, c->w[0], c->e[0]);
    lane most = lane_of(-INFINITY), away[4], along[4];
    for (int p = 0; p < n; p++) {
        away[p] = front_dot(n, c->w[p], c->v);
        along[p] = kind.moves ? front_dot(n, c->w[p], c->drift) : lane_of(0);
    }
    for (int i = 0; i < n; i++)
        c->w[n][i] = -(c->w[0][i] + c->w[1][i] + (n == 3 ? c->w[2][i] : lane_of(0)));
    away[n] = -fmb_sum(away, n);
    along[n] = -fmb_sum(along, n);
    for (int p = 0; p <= n; p++) {
        lane gap = fmb_simplices_row(kind, c, c->w[p], away[p], along[p], c->det);
        if (p == n)
            gap = gap - lane_abs(c->det);
        most = lane_max(most, gap);
    }
    return most;
}

/* ---- in space: a direction eliminated -------------------------------------------------------- */

/* Coordinates k, l along an edge of A. */
typedef struct fmb_columns {
    int k, l;
} fmb_columns;

FMB_INLINE fmb_columns fmb_columns_of(int edge)
{
    return edge < 3 ? (fmb_columns){(edge + 1) % 3, (edge + 2) % 3} : (fmb_columns){edge - 3, 3};
}

/* What the rows of B have of the edge of A. */
FMB_INLINE void fmb_simplices_slopes(const fmb_simplices *c, int edge, lane *a)
{
    for (int p = 0; p < 3; p++)
        if (edge < 3)
            a[p] = c->w[p][edge];
        else
            a[p] = c->w[p][(edge + 1) % 3] - c->w[p][(edge + 2) % 3];
    a[3] = -fmb_sum(a, 3);
}

/* The row with x_l, -x_k, least on B with the sign of s, which is opposite to that of other, and
 * then away at t = 0, end at t = 1. */
FMB_INLINE lane fmb_simplices_edge(fmb_kind kind, const fmb_simplices *c, lane xk, lane xl,
                                   lane away, lane end, lane s, lane other)
{
    lane least = lane_times_sign(away, s), most;
    if (kind.moves)
        least = lane_min(least, lane_times_sign(end, s));
    if (kind.simplex)
        most = lane_max(lane_max(lane_times_sign(xl, s), lane_of(0)), lane_times_sign(xk, other));
    else
        most = lane_abs(xk) + lane_abs(xl);
    return lane_fnma(c->reach, most, least);
}

FMB_INLINE lane fmb_turned(const lane *x, const lane *y, fmb_columns in)
{
    return lane_fms(x[in.l], y[in.k], x[in.k] * y[in.l]);
}

/* All pairs of rows of B, an edge of A eliminated: the largest gap; the least |a_p| so far. */
FMB_INLINE lane fmb_simplices_edges(fmb_kind kind, const fmb_simplices *c, int edge, lane *certain)
{
    lane most = lane_of(-INFINITY), a[4], away[3], end[3];
    lane_mask negative[4];
    fmb_columns in = fmb_columns_of(edge);
    fmb_simplices_slopes(c, edge, a);
    for (int p = 0; p < 4; p++) {
        negative[p] = lane_negative(a[p]);
        *certain = lane_min_abs(*certain, a[p]);
    }
    for (int r = 0; r < 3; r++) {
        int p = (r + 1) % 3, q = (r + 2) % 3;
        away[r] = fmb_turned(c->e[r], c->v, in);
        end[r] = kind.moves ? fmb_turned(c->e[r], c->end, in) : lane_of(0);
        lane gap =
            fmb_simplices_edge(kind, c, c->e[r][in.k], c->e[r][in.l], away[r], end[r], a[p], a[q]);
        most = lane_max_where(lane_xor(negative[p], negative[q]), most, gap);
    }
    for (int r = 0; r < 3; r++) {
        int p = (r + 1) % 3, q = (r + 2) % 3;
        lane xk = c->e[r][in.k] - c->e[q][in.k], xl = c->e[r][in.l] - c->e[q][in.l];
        lane gap = fmb_simplices_edge(kind, c, xk, xl, away[r] - away[q] + a[p],
                                      end[r] - end[q] + a[p], a[3], a[p]);
        most = lane_max_where(lane_xor(negative[3], negative[p]), most, gap);
    }
    return most;
}

/* ---- in space: time eliminated --------------------------------------------------------------- */

/* The row along the drift and an edge of A, from both sides: the larger gap. */
FMB_INLINE lane fmb_simplices_swept(fmb_kind kind, const fmb_simplices *c, int edge)
{
    fmb_columns in = fmb_columns_of(edge);
    lane low = lane_of(0), high = lane_of(0), xl = c->drift[in.l], xk = c->drift[in.k];
    for (int p = 0; p < 3; p++) {
        lane at = fmb_turned(c->drift, c->e[p], in);
        low = lane_min(low, at);
        high = lane_max(high, at);
    }
    lane away = fmb_turned(c->drift, c->v, in);
    low = low + away;
    high = high + away;
    if (!kind.simplex) {
        lane reach = lane_abs(xk) + lane_abs(xl);
        return lane_fnma(c->reach, reach, lane_max(low, -high));
    }
    lane most = lane_max(lane_max(xl, -xk), lane_of(0));
    lane least = lane_min(lane_min(xl, -xk), lane_of(0));
    return lane_max(lane_fnma(c->reach, most, low), lane_fms(c->reach, least, high));
}

/* All pairs of rows of B, time eliminated. */
FMB_INLINE lane fmb_simplices_times(fmb_kind kind, const fmb_simplices *c, lane *certain)
{
    const lane zero = lane_of(0);
    lane most = lane_of(-INFINITY), b[4], u[3][3], away[3];
    lane_mask negative[4];
    const fmb_kind still = {3, false, kind.simplex};
    for (int p = 0; p < 3; p++)
        b[p] = front_dot(3, c->w[p], c->drift);
    b[3] = -fmb_sum(b, 3);
    for (int p = 0; p < 4; p++) {
        negative[p] = lane_negative(b[p]);
        *certain = lane_min_abs(*certain, b[p]);
    }
    for (int r = 0; r < 3; r++) {
        int p = (r + 1) % 3, q = (r + 2) % 3;
        fmb_cross(c->e[r], c->drift, u[r]);
        away[r] = front_dot(3, u[r], c->v);
        lane gap = fmb_simplices_row(still, c, u[r], away[r], zero, b[p]);
        most = lane_max_where(lane_xor(negative[p], negative[q]), most, gap);
    }
    for (int r = 0; r < 3; r++) {
        int p = (r + 1) % 3, q = (r + 2) % 3;
        const lane w[3] = {u[r][0] - u[q][0], u[r][1] - u[q][1], u[r][2] - u[q][2]};
        lane gap = fmb_simplices_row(still, c, w, away[r] - away[q] + b[p], zero, b[3]);
        most = lane_max_where(lane_xor(negative[3], negative[p]), most, gap);
    }
    return most;
}

FMB_INLINE fmb_pair_bits fmb_simplices_3d(const double *block, bool moves, bool simplex)
{
    const fmb_kind kind = {3, moves, simplex};
    const int edges = simplex ? 6 : 3; /* directions of edges of A */
    front f = front_of(3, moves, block);
    fmb_simplices c = fmb_simplices_of(kind, &f);
    fmb_gaps gaps = fmb_gaps_none();
    fmb_pair_bits out;
    lane ex = f.most_e * c.bound, vx = f.most_drift * c.bound, ee = f.most_e * f.most_e;
    fmb_gaps_class(&gaps, fmb_simplices_faces(kind, &c), 40, c.bound);
    fmb_gaps_class(&gaps, fmb_simplices_sides(kind, &c), 1210, f.most_e * ex);
    if (fmb_gaps_done(&gaps, f.known, &out))
        return out;
    fmb_gaps_certain(&gaps, lane_abs(c.det), 150, f.most_e * ee);
    lane certain = lane_of(INFINITY), most = lane_of(-INFINITY);
#pragma GCC unroll 6
    for (int edge = 0; edge < edges; edge++)
        most = lane_max(most, fmb_simplices_edges(kind, &c, edge, &certain));
    fmb_gaps_class(&gaps, most, 1060, ex);
    fmb_gaps_certain(&gaps, certain, 210, ee);
    if (moves) {
        lane swept = lane_of(-INFINITY);
#pragma GCC unroll 6
        for (int edge = 0; edge < edges; edge++)
            swept = lane_max(swept, fmb_simplices_swept(kind, &c, edge));
        fmb_gaps_class(&gaps, swept, 410, vx);
        certain = lane_of(INFINITY);
        fmb_gaps_class(&gaps, fmb_simplices_times(kind, &c, &certain), 1130, f.most_drift * ex);
        fmb_gaps_certain(&gaps, certain, 470, f.most_drift * ee);
    }
    return fmb_gaps_bits(&gaps, f.known);
}

/* In the plane: the row along the drift, from both sides. */
FMB_INLINE lane fmb_simplices_turned(fmb_kind kind, const fmb_simplices *c)
{
    const fmb_columns in = {0, 1};
    lane low = lane_of(0), high = lane_of(0);
    const lane w[2] = {c->drift[1], -c->drift[0]};
    for (int p = 0; p < 2; p++) {
        lane at = fmb_turned(c->drift, c->e[p], in);
        low = lane_min(low, at);
        high = lane_max(high, at);
    }
    lane away = fmb_turned(c->drift, c->v, in);
    lane above = lane_fnma(c->reach, fmb_simplices_most(kind, w, lane_of(1)), away + low);
    lane below = lane_fma(c->reach, fmb_simplices_most(kind, w, lane_of(-1)), away + high);
    return lane_max(above, -below);
}

FMB_INLINE fmb_pair_bits fmb_simplices_2d(const double *block, bool moves, bool simplex)
{
    const fmb_kind kind = {2, moves, simplex};
    front f = front_of(2, moves, block);
    fmb_simplices c = fmb_simplices_of(kind, &f);
    fmb_gaps gaps = fmb_gaps_none();
    fmb_gaps_class(&gaps, fmb_simplices_faces(kind, &c), 40, c.bound);
    fmb_gaps_class(&gaps, fmb_simplices_sides(kind, &c), 1210, f.most_e * c.bound);
    fmb_gaps_certain(&gaps, lane_abs(c.det), 150, f.most_e * f.most_e);
    if (moves)
        fmb_gaps_class(&gaps, fmb_simplices_turned(kind, &c), 410, f.most_drift * c.bound);
    return fmb_gaps_bits(&gaps, f.known);
}

#endif
