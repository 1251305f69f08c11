/* verdict_simplices.h: does a simplex meet a cuboid or a simplex, in the plane or in space? See
 * docs/theory.md, theorem 34. */
#ifndef FMB_PAIR_VERDICT_SIMPLICES_H
#define FMB_PAIR_VERDICT_SIMPLICES_H

#include "pair/kernels/verdict/verdict_gaps.h"

/* Notation: y are coordinates in A's frame (local_frame.h), size = |det A|. A is the cube
 * 0 <= y_i / det A <= 1; or the simplex 0 <= y_i, sum y_i <= size, whose y have the sign of det A
 * and a last coordinate more, size - sum y_i. B is the simplex with the corners v and v + e_i,
 * moving by t drift, 0 <= t <= 1. Slabs are in coordinates z = 2 y - det A: A lies in |z_i| <=
 * size, B starts at s = 2 v - det A, and m = s + sum e_i + drift is the middle of v + sum
 * [0, 1] e_i + [0, 1] drift. (p, q, r) is a cyclic permutation of (0, 1, 2).
 *
 * 1. Rows of B, in space: w_p = e_q x e_r, and w_3 = -(w_0 + w_1 + w_2); with the sign of det B,
 *    w_p (y - v) >= 0 for p < 3, and w_3 (y - v) >= -|det B|. In the plane: w_0 = e_1, w_1 = -e_0,
 *    each turned by a right angle. If A is a cube these are slabs of half-width |det B|, with the
 *    middles w_p m for p < D, and w_D m + (D - 1) det B.
 * 2. Eliminating a direction d from rows p and q, a_p = w_p d, leaves a row along the edge that the
 *    two faces share: a_p w_q - a_q w_p = det B (e_r x d). So no row needs to be formed. Along
 *    u = e_r x d the two other corners of B are g = a_p and h = -a_q from the edge; along
 *    u = (e_r - e_q) x d, from rows 3 and p, v and v + e_p are g = -a_p and h = a_3 from it.
 * 3. The row counts only if g and h have one sign: then B lies between 0, its near end, and g + h.
 *    So the slab from min(0, g) + min(0, h) to max(0, g) + max(0, h), of half-width |g| + |h| in z,
 *    always contains B, its near end is exact where the row counts, and no sign is tested. Likewise
 *    a simplex A along u, in the coordinates k, l that are 0 along its edge d: its half-width is
 *    size (|x_k| + |x_l|) for the edge x of B.
 * 4. The distance of the middles is T = x_l m_k - x_k m_l for the edge x = e_r; for e_r - e_q it is
 *    the difference of those of e_r and e_q, less 2 a_p; for d = d_j - d_k it is the difference of
 *    those of d_j and d_k, plus 2 size x_i, i the third index.
 * 5. If B moves, the half-width grows by |u drift|, a coordinate of edge x drift; and time is
 *    eliminated likewise: u = e_r x drift, with drift for d, and the drift with each edge of A.
 *
 * Completeness: docs/theory.md, theorem 35. If B is flat, a row that vanishes has the gap 0, so the
 * verdict is not "meet"; where A is a simplex, rows are one-sided, and the sign of det B must be
 * certain.
 *
 * Errors, also where the sign of det B is wrong: docs/error-bounds.md, "Simplices" and "Signs";
 * bound and more are its X and Y.
 */
typedef struct fmb_simplices {
    lane v[4], e[3][4], drift[4], end[4]; /* end = v + drift */
    lane w[4][3], det;
    fmb_bound bound, more; /* X, Y */
    /* in space, and doubled */
    lane size, twice;                       /* twice = 2 size */
    lane start[3], middle[3];               /* s, m */
    lane swept[3][3], along[3][3], past[3]; /* e x drift, m x e, s x drift */
} fmb_simplices;

FMB_INLINE lane fmb_sum(const lane *x, int n)
{
    lane sum = x[0];
    for (int i = 1; i < n; i++)
        sum = sum + x[i];
    return sum;
}

FMB_INLINE void fmb_simplices_make(fmb_kind kind, const local_frame *f, fmb_simplices *c)
{
    const int dim = kind.dim;
    for (int i = 0; i < dim; i++) {
        c->v[i] = f->shift[i];
        c->drift[i] = lane_of(0);
        if (kind.moves)
            c->drift[i] = f->drift[i];
        for (int k = 0; k < dim; k++)
            c->e[k][i] = f->e[k][i];
    }
    if (kind.simplex) {
        c->v[dim] = f->size - fmb_sum(c->v, dim);
        c->drift[dim] = -fmb_sum(c->drift, dim);
        for (int k = 0; k < dim; k++)
            c->e[k][dim] = -fmb_sum(c->e[k], dim);
    }
    for (int i = 0; i < dim + kind.simplex; i++)
        c->end[i] = c->v[i] + c->drift[i];
    c->size = f->size;
    c->twice = f->size + f->size;
    for (int i = 0; i < dim; i++) {
        lane sum = f->e[0][i] + f->e[1][i];
        if (dim == 3)
            sum = sum + f->e[2][i];
        c->start[i] = lane_fms(lane_of(2), f->shift[i], f->volume);
        if (kind.moves)
            sum = sum + f->drift[i];
        c->middle[i] = c->start[i] + sum;
    }
    c->bound = fmb_bound_of_sum(f, 1, 1);
    c->more = fmb_bound_of_sum(f, 1, 3);
}

/* A's rows: the largest gap. */
FMB_INLINE lane fmb_simplices_faces(fmb_kind kind, const fmb_simplices *c)
{
    const lane zero = lane_of(0);
    lane most = lane_of(0);
    for (int i = 0; i < kind.dim + kind.simplex; i++) {
        lane low = zero, high = zero;
        for (int k = 0; k < kind.dim; k++) {
            low = lane_min(low, c->e[k][i]);
            high = lane_max(high, c->e[k][i]);
        }
        if (kind.simplex) {
            most = fmb_gaps_largest(i, most, -(lane_max(c->v[i], c->end[i]) + high));
            continue;
        }
        lane away = c->start[i] + (high + low), width = high - low;
        if (kind.moves) {
            away = away + c->drift[i];
            width = width + lane_abs(c->drift[i]);
        }
        most = fmb_gaps_largest(i, most, lane_abs(away) - width);
    }
    if (kind.simplex)
        return most;
    return most - c->size;
}

/* The largest value over A, a simplex, of the row with the coefficients w, with the sign of s. */
FMB_INLINE lane fmb_simplices_most(fmb_kind kind, const lane *w, lane s)
{
    lane most = lane_of(0);
    for (int i = 0; i < kind.dim; i++)
        most = lane_max(most, lane_times_sign(w[i], s));
    return most;
}

/* The gap of the row w, with the sign of s; w v = away, and w drift = along. */
FMB_INLINE lane fmb_simplices_row(fmb_kind kind, const fmb_simplices *c, const lane *w, lane away,
                                  lane along, lane s)
{
    lane least = lane_times_sign(away, s);
    if (kind.moves)
        least = least + lane_min(lane_times_sign(along, s), lane_of(0));
    return lane_fnma(c->size, fmb_simplices_most(kind, w, s), least);
}

/* B's rows: their coefficients. */
FMB_INLINE void fmb_simplices_rows(fmb_kind kind, fmb_simplices *c)
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
    c->det = local_frame_dot(n, c->w[0], c->e[0]);
    for (int i = 0; i < n; i++)
        c->w[n][i] = -(c->w[0][i] + c->w[1][i] + (n == 3 ? c->w[2][i] : lane_of(0)));
}

/* B's rows, A a cuboid in the plane: the largest gap. Only absolute values of coefficients count:
 * no sign is applied. */
FMB_INLINE lane fmb_simplices_strips(fmb_kind kind, fmb_simplices *c)
{
    const lane *p = c->e[0], *q = c->e[1];
    lane away[3], along[3], wide[3], most = lane_of(0);
    c->det = local_frame_turned(q, p);
    away[0] = local_frame_turned(q, c->middle);
    away[1] = local_frame_turned_back(p, c->middle);
    away[2] = c->det - (away[0] + away[1]);
    wide[0] = lane_abs(q[0]) + lane_abs(q[1]);
    wide[1] = lane_abs(p[0]) + lane_abs(p[1]);
    wide[2] = lane_abs(q[0] - p[0]) + lane_abs(q[1] - p[1]);
    if (kind.moves) {
        along[0] = local_frame_turned(q, c->drift);
        along[1] = local_frame_turned_back(p, c->drift);
        along[2] = along[0] + along[1];
    }
    for (int i = 0; i < 3; i++) {
        lane gap = lane_abs(away[i]);
        if (kind.moves)
            gap = gap - lane_abs(along[i]);
        most = fmb_gaps_largest(i, most, lane_fnma(c->size, wide[i], gap));
    }
    return most - lane_abs(c->det);
}

/* B's rows, A a cuboid in space: the largest gap. */
FMB_INLINE lane fmb_simplices_slabs(fmb_kind kind, const fmb_simplices *c)
{
    lane most = lane_of(0), away[4], along[4];
    for (int p = 0; p < 3; p++) {
        away[p] = local_frame_dot(3, c->w[p], c->middle);
        along[p] = kind.moves ? local_frame_dot(3, c->w[p], c->drift) : lane_of(0);
    }
    away[3] = lane_fms(lane_of(2), c->det, fmb_sum(away, 3));
    along[3] = fmb_sum(along, 3);
    for (int p = 0; p < 4; p++) {
        lane gap = lane_abs(away[p]), wide = lane_abs(c->w[p][0]) + lane_abs(c->w[p][1]);
        wide = wide + lane_abs(c->w[p][2]);
        if (kind.moves)
            gap = gap - lane_abs(along[p]);
        most = fmb_gaps_largest(p, most, lane_fnma(c->size, wide, gap));
    }
    return most - lane_abs(c->det);
}

/* B's rows, A a simplex: the largest gap. */
FMB_INLINE lane fmb_simplices_sides(fmb_kind kind, const fmb_simplices *c)
{
    const int n = kind.dim;
    lane most = lane_of(0), away[4], along[4];
    for (int p = 0; p < n; p++) {
        away[p] = local_frame_dot(n, c->w[p], c->v);
        along[p] = kind.moves ? local_frame_dot(n, c->w[p], c->drift) : lane_of(0);
    }
    away[n] = -fmb_sum(away, n);
    along[n] = -fmb_sum(along, n);
    for (int p = 0; p <= n; p++) {
        lane gap = fmb_simplices_row(kind, c, c->w[p], away[p], along[p], c->det);
        if (p == n)
            gap = gap - lane_abs(c->det);
        most = fmb_gaps_largest(p, most, gap);
    }
    return most;
}

/* Add the class of B's rows to the gaps. */
FMB_INLINE void fmb_simplices_ask(fmb_kind kind, const local_frame *f, fmb_simplices *c,
                                  fmb_gaps *gaps)
{
    const fmb_bound e = fmb_bound_of_edges(f);
    fmb_bound power = e; /* E^(D - 1) */
    if (kind.dim == 3)
        power = fmb_bound_times(power, e);
    if (kind.dim == 2 && !kind.simplex) {
        fmb_gaps_class(gaps, fmb_simplices_strips(kind, c), 200, 0,
                       fmb_bound_times(power, c->more));
        return;
    }
    fmb_simplices_rows(kind, c);
    if (!kind.simplex) {
        fmb_gaps_class(gaps, fmb_simplices_slabs(kind, c), 1260, 36,
                       fmb_bound_times(power, c->more));
        return;
    }
    fmb_gaps_class(gaps, fmb_simplices_sides(kind, c), kind.dim == 3 ? 1210 : 100, 18,
                   fmb_bound_times(power, c->bound));
    fmb_gaps_certain(gaps, lane_abs(c->det), 150, 6, fmb_bound_times(power, e));
}

/* ---- in space: a direction eliminated -------------------------------------------------------- */

/* Coordinates k, l along an edge of A. */
typedef struct fmb_simplex_columns {
    int k, l;
} fmb_simplex_columns;

FMB_INLINE fmb_simplex_columns fmb_columns_of(int edge)
{
    return edge < 3 ? (fmb_simplex_columns){(edge + 1) % 3, (edge + 2) % 3}
                    : (fmb_simplex_columns){edge - 3, 3};
}

FMB_INLINE lane fmb_turned(const lane *x, const lane *y, fmb_simplex_columns in)
{
    return lane_fms(x[in.l], y[in.k], x[in.k] * y[in.l]);
}

/* One of the two faces of B beside its edge j of 6, in the order in which their rows are combined;
 * edge 3 + p is e_r - e_q. */
FMB_INLINE int fmb_simplices_face(int j, int side)
{
    if (j < 3)
        return (j + 1 + side) % 3;
    return side == 0 ? j - 3 : 3;
}

/* Coordinates i of the cross products m x e and e x drift: those along axis i of A. */
FMB_INLINE void fmb_simplices_look(fmb_kind kind, fmb_simplices *c, int i)
{
    const fmb_simplex_columns in = fmb_columns_of(i);
    for (int p = 0; p < 3; p++) {
        c->along[p][i] = fmb_turned(c->e[p], c->middle, in);
        if (kind.moves)
            c->swept[p][i] = fmb_turned(c->drift, c->e[p], in);
    }
}

/* The product of x with direction `edge` of A; the first three directions are the axes. */
FMB_INLINE lane fmb_simplices_on(const lane *x, int edge)
{
    if (edge < 3)
        return x[edge];
    return x[(edge + 1) % 3] - x[(edge + 2) % 3];
}

/* All pairs of rows of B that share an edge, the direction of an edge of A eliminated: the largest
 * gap. */
FMB_INLINE lane fmb_simplices_edges(fmb_kind kind, fmb_simplices *c, int edge)
{
    const fmb_simplex_columns in = fmb_columns_of(edge);
    lane a[4], width[4], t[6], swept[6], most = lane_of(0);
    if (edge < 3)
        fmb_simplices_look(kind, c, edge);
    for (int p = 0; p < 3; p++) {
        a[p] = fmb_simplices_on(c->w[p], edge);
        t[p] = fmb_simplices_on(c->along[p], edge);
        if (edge >= 3)
            t[p] = lane_fma(c->twice, c->e[p][edge - 3], t[p]);
        if (kind.moves)
            swept[p] = fmb_simplices_on(c->swept[p], edge);
    }
    a[3] = fmb_sum(a, 3);
    for (int p = 0; p < 4; p++)
        width[p] = lane_abs(a[p]);
    for (int p = 0; p < 3; p++) {
        int q = (p + 1) % 3, r = (p + 2) % 3;
        t[3 + p] = lane_fnma(lane_of(2), a[p], t[r] - t[q]);
        if (kind.moves)
            swept[3 + p] = swept[r] - swept[q];
    }
#pragma GCC unroll 6
    for (int j = 0; j < 6; j++) {
        int q = (j + 1) % 3, r = (j + 2) % 3;
        lane k = c->e[j % 3][in.k], l = c->e[j % 3][in.l];
        if (j >= 3) {
            k = c->e[r][in.k] - c->e[q][in.k];
            l = c->e[r][in.l] - c->e[q][in.l];
        }
        lane reach = width[fmb_simplices_face(j, 0)] + width[fmb_simplices_face(j, 1)];
        if (kind.moves)
            reach = reach + lane_abs(swept[j]);
        reach = lane_fma(c->size, lane_abs(k) + lane_abs(l), reach);
        most = fmb_gaps_largest(j, most, lane_abs(t[j]) - reach);
    }
    return most;
}

/* ---- in space: time eliminated --------------------------------------------------------------- */

/* The row along the drift and an edge of A. */
FMB_INLINE lane fmb_simplices_swept(fmb_simplices *c, int edge)
{
    const fmb_simplex_columns in = fmb_columns_of(edge);
    lane low = lane_of(0), high = lane_of(0), away;
    if (edge < 3)
        c->past[edge] = fmb_turned(c->drift, c->start, in);
    away = fmb_simplices_on(c->past, edge);
    if (edge >= 3)
        away = lane_fma(c->twice, c->drift[edge - 3], away);
    for (int p = 0; p < 3; p++) {
        lane at = fmb_simplices_on(c->swept[p], edge);
        low = lane_min(low, at);
        high = lane_max(high, at);
    }
    lane reach = lane_fma(c->size, lane_abs(c->drift[in.k]) + lane_abs(c->drift[in.l]), high - low);
    return lane_abs(away + (high + low)) - reach;
}

/* The gap of the row u = (edge of B) x drift; away: the distance of the middles of B and A. */
FMB_INLINE lane fmb_simplices_late(fmb_kind kind, const fmb_simplices *c, const lane *u, lane away)
{
    lane low = lane_of(0), high = lane_of(0);
    if (!kind.simplex)
        return lane_fnma(c->size, lane_abs(u[0]) + lane_abs(u[1]) + lane_abs(u[2]), lane_abs(away));
    for (int i = 0; i < 3; i++) {
        low = lane_min(low, u[i]);
        high = lane_max(high, u[i]);
    }
    away = lane_fnma(c->size, high + low, away);
    return lane_fnma(c->size, high - low, lane_abs(away));
}

/* All pairs of rows of B that share an edge, time eliminated. */
FMB_INLINE lane fmb_simplices_times(fmb_kind kind, const fmb_simplices *c)
{
    lane b[4], away[3], from[3], most = lane_of(0);
    for (int i = 0; i < 3; i++) {
        from[i] = c->middle[i];
        if (kind.simplex)
            from[i] = from[i] + c->size;
    }
    for (int p = 0; p < 3; p++) {
        b[p] = local_frame_dot(3, c->w[p], c->drift);
        away[p] = local_frame_dot(3, c->swept[p], from);
    }
    b[3] = fmb_sum(b, 3);
#pragma GCC unroll 6
    for (int j = 0; j < 6; j++) {
        lane width = lane_abs(b[fmb_simplices_face(j, 0)]) + lane_abs(b[fmb_simplices_face(j, 1)]);
        lane u[3], at = away[j % 3];
        int q = (j + 1) % 3, r = (j + 2) % 3;
        for (int i = 0; i < 3; i++) {
            u[i] = c->swept[j % 3][i];
            if (j >= 3)
                u[i] = c->swept[r][i] - c->swept[q][i];
        }
        if (j >= 3)
            at = lane_fnma(lane_of(2), b[j - 3], away[r] - away[q]);
        most = fmb_gaps_largest(j, most, fmb_simplices_late(kind, c, u, at) - width);
    }
    return most;
}

FMB_INLINE fmb_pair_bits fmb_simplices_3d(const double *block, bool moves, bool simplex,
                                          bool single, fmb_asked asked)
{
    const fmb_kind kind = {3, moves, simplex};
    const int edges = simplex ? 6 : 3; /* directions of edges of A */
    local_frame f;
    local_frame_make(3, moves, simplex, single, block, &f);
    fmb_simplices c;
    fmb_simplices_make(kind, &f, &c);
    fmb_gaps gaps = fmb_gaps_first(fmb_simplices_faces(kind, &c), 52, 4, c.bound);
    fmb_pair_bits out;
    if (FMB_LANES < 8 && fmb_gaps_done(&gaps, f.known, &out))
        return out;
    fmb_simplices_ask(kind, &f, &c, &gaps);
    if (fmb_gaps_done(&gaps, f.known, &out) || asked == FMB_ASK_FACES)
        return out;
    const fmb_bound e_bound = fmb_bound_times(fmb_bound_of_edges(&f), c.more);
    lane most = lane_of(0), swept = most;
#pragma GCC unroll 6
    for (int edge = 0; edge < edges; edge++) {
        most = fmb_gaps_largest(edge, most, fmb_simplices_edges(kind, &c, edge));
        if (moves)
            swept = fmb_gaps_largest(edge, swept, fmb_simplices_swept(&c, edge));
    }
    fmb_gaps_class(&gaps, most, 500, simplex ? 20 : 8, e_bound);
    if (moves) {
        const fmb_bound speed = fmb_bound_of_speed(&f);
        fmb_gaps_class(&gaps, swept, 220, simplex ? 10 : 4, fmb_bound_times(speed, c.more));
        fmb_gaps_class(&gaps, fmb_simplices_times(kind, &c), 1140, simplex ? 40 : 24,
                       fmb_bound_times(speed, e_bound));
    }
    return fmb_gaps_bits(&gaps, f.known);
}

/* In the plane: the row along the drift. */
FMB_INLINE lane fmb_simplices_turned(fmb_kind kind, const fmb_simplices *c)
{
    const fmb_simplex_columns in = {0, 1};
    const lane w[2] = {c->drift[1], -c->drift[0]};
    lane low = lane_of(0), high = low, first = low, last = low;
    for (int p = 0; p < 2; p++) {
        lane at = fmb_turned(c->drift, c->e[p], in);
        low = lane_min(low, at);
        high = lane_max(high, at);
        first = lane_min(first, w[p]);
        last = lane_max(last, w[p]);
    }
    if (!kind.simplex) {
        lane away = lane_abs(fmb_turned(c->drift, c->start, in) + (high + low));
        return lane_fnma(c->size, lane_abs(w[0]) + lane_abs(w[1]), away - (high - low));
    }
    lane away = fmb_turned(c->drift, c->v, in);
    return lane_max(lane_fnma(c->size, last, away + low), lane_fms(c->size, first, away + high));
}

FMB_INLINE fmb_pair_bits fmb_simplices_2d(const double *block, bool moves, bool simplex)
{
    const fmb_kind kind = {2, moves, simplex};
    local_frame f;
    local_frame_make(2, moves, simplex, false, block, &f);
    fmb_simplices c;
    fmb_simplices_make(kind, &f, &c);
    fmb_gaps gaps = fmb_gaps_first(fmb_simplices_faces(kind, &c), 52, 4, c.bound);
    fmb_simplices_ask(kind, &f, &c, &gaps);
    if (moves)
        fmb_gaps_class(&gaps, fmb_simplices_turned(kind, &c), simplex ? 50 : 410, 0,
                       fmb_bound_times(fmb_bound_of_speed(&f), c.bound));
    return fmb_gaps_bits(&gaps, f.known);
}

#endif
