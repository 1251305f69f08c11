/* verdict_cuboids.h: do two cuboids of the plane or of space meet? See docs/theory.md, "Pairs". */
#ifndef FMB_PAIR_VERDICT_CUBOIDS_H
#define FMB_PAIR_VERDICT_CUBOIDS_H

#include "pair/kernels/verdict/verdict_gaps.h"

/* In coordinates z = 2 y - det A of A's frame: A is |z_i| <= size, and B, with all its places from
 * t = 0 to 1, is center + sum x_k g_k, |x_k| <= 1, over its edges and, if it moves, the drift.
 *
 * Eliminating x from the rows of B leaves slabs |n (z - center)| <= sum |n g_k|: n = g_a x g_b in
 * space, or g_a turned by a right angle in the plane, has all other unknowns eliminated; in space n
 * = g_a x (axis i of A) has z_i eliminated from two slabs of B (the half-width is then a sum of the
 * coordinates i of cross products, by Jacobi's identity for minors of the adjugate). A slab misses
 * A iff |n center| > size sum |n_i| + sum |n g_k|.
 *
 * Complete: A and B meet in interiors unless a facet of B - A keeps 0 out. D - 1 independent edges
 * of A and g_k are parallel to the facet: two or more of A make it a face of A, otherwise its
 * normal is one of the n above.
 *
 * Errors: docs/error-bounds.md, "Cuboids"; bound is its K.
 */
typedef struct fmb_cuboids {
    lane size, g[4][3], center[3];
    fmb_bound bound;
    lane cross[6][3]; /* of g_a, g_b, a < b, at [b (b - 1) / 2 + a] */
} fmb_cuboids;

/* The number of g_k. */
FMB_INLINE int fmb_cuboids_count(fmb_kind kind)
{
    return kind.dim + kind.moves;
}

FMB_INLINE void fmb_cuboids_make(fmb_kind kind, const local_frame *f, fmb_cuboids *c)
{
    const int dim = kind.dim, n = fmb_cuboids_count(kind);
    c->size = f->size;
    for (int i = 0; i < dim; i++) {
        lane sum = f->e[0][i];
        for (int k = 0; k < n; k++)
            c->g[k][i] = k < dim ? f->e[k][i] : f->drift[i];
        for (int k = 1; k < n; k++)
            sum = sum + c->g[k][i];
        c->center[i] = lane_fma(lane_of(2), f->shift[i], sum - f->volume);
    }
    c->bound = fmb_bound_of_sum(f, 2, dim);
}

/* A's rows: the largest gap. */
FMB_INLINE lane fmb_cuboids_faces(fmb_kind kind, const fmb_cuboids *c)
{
    lane most = lane_of(0);
    for (int i = 0; i < kind.dim; i++) {
        lane reach = c->size;
        for (int k = 0; k < fmb_cuboids_count(kind); k++)
            reach = reach + lane_abs(c->g[k][i]);
        most = fmb_gaps_largest(i, most, lane_abs(c->center[i]) - reach);
    }
    return most;
}

/* In the plane: the row along g_a. */
FMB_INLINE lane fmb_cuboids_turned(fmb_kind kind, const fmb_cuboids *c, int a)
{
    const lane *g = c->g[a];
    lane away = lane_abs(lane_fms(g[0], c->center[1], g[1] * c->center[0]));
    lane gap = lane_fnma(c->size, lane_abs(g[0]) + lane_abs(g[1]), away);
    for (int b = 0; b < fmb_cuboids_count(kind); b++)
        if (b != a)
            gap = gap - lane_abs(lane_fms(g[0], c->g[b][1], g[1] * c->g[b][0]));
    return gap;
}

/* The cross products with g_b, first <= b < end. */
FMB_INLINE void fmb_cuboids_cross(fmb_cuboids *c, int first, int end)
{
    for (int b = first; b < end; b++)
        for (int a = 0; a < b; a++)
            fmb_cross(c->g[a], c->g[b], c->cross[b * (b - 1) / 2 + a]);
}

/* In space: the row along g_a and g_b, a < b. */
FMB_INLINE lane fmb_cuboids_side(fmb_kind kind, const fmb_cuboids *c, int a, int b)
{
    const lane *n = c->cross[b * (b - 1) / 2 + a];
    lane sum = lane_abs(n[0]) + lane_abs(n[1]) + lane_abs(n[2]);
    lane gap = lane_fnma(c->size, sum, lane_abs(local_frame_dot(3, n, c->center)));
    for (int k = 0; k < fmb_cuboids_count(kind); k++)
        if (k != a && k != b) {
            /* the same determinant in all three rows that have it */
            int x = k < a ? k : a, y = k < b ? (k < a ? a : k) : b, z = k < b ? b : k;
            gap = gap - lane_abs(local_frame_dot(3, c->cross[y * (y - 1) / 2 + x], c->g[z]));
        }
    return gap;
}

/* In space: the rows along g_a and an axis of A. */
FMB_INLINE lane fmb_cuboids_ridge(fmb_kind kind, const fmb_cuboids *c, int a)
{
    const lane *g = c->g[a];
    lane most = lane_of(0);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        lane away = lane_abs(lane_fms(g[k], c->center[j], g[j] * c->center[k])), wide = lane_of(0);
        for (int b = 0; b < fmb_cuboids_count(kind); b++)
            if (b != a) {
                int x = a < b ? a : b, y = a < b ? b : a;
                wide = wide + lane_abs(c->cross[y * (y - 1) / 2 + x][i]);
            }
        lane reach = lane_fma(c->size, lane_abs(g[j]) + lane_abs(g[k]), wide);
        most = fmb_gaps_largest(i, most, away - reach);
    }
    return most;
}

FMB_INLINE fmb_pair_bits fmb_cuboids_2d(const double *block, bool moves)
{
    const fmb_kind kind = {2, moves, false};
    local_frame f;
    local_frame_make(2, moves, false, false, block, &f);
    fmb_cuboids c;
    fmb_cuboids_make(kind, &f, &c);
    fmb_gaps gaps = fmb_gaps_first(fmb_cuboids_faces(kind, &c), 26, 0, c.bound);
    lane most = lane_max(fmb_cuboids_turned(kind, &c, 0), fmb_cuboids_turned(kind, &c, 1));
    fmb_gaps_class(&gaps, most, 92, 0, fmb_bound_times(fmb_bound_of_edges(&f), c.bound));
    if (moves)
        fmb_gaps_class(&gaps, fmb_cuboids_turned(kind, &c, 2), 92, 0,
                       fmb_bound_times(fmb_bound_of_speed(&f), c.bound));
    return fmb_gaps_bits(&gaps, f.known);
}

FMB_INLINE fmb_pair_bits fmb_cuboids_3d(const double *block, bool moves, bool single,
                                        fmb_asked asked)
{
    const fmb_kind kind = {3, moves, false};
    local_frame f;
    local_frame_make(3, moves, false, single, block, &f);
    fmb_cuboids c;
    fmb_cuboids_make(kind, &f, &c);
    fmb_gaps gaps = fmb_gaps_first(fmb_cuboids_faces(kind, &c), 26, 2, c.bound);
    fmb_pair_bits out;
    if (FMB_LANES < 8 && fmb_gaps_done(&gaps, f.known, &out))
        return out;
    fmb_cuboids_cross(&c, 0, 3);
    lane side = lane_max(fmb_cuboids_side(kind, &c, 0, 1), fmb_cuboids_side(kind, &c, 0, 2));
    side = lane_max(side, fmb_cuboids_side(kind, &c, 1, 2));
    const fmb_bound e = fmb_bound_of_edges(&f), e_bound = fmb_bound_times(e, c.bound);
    fmb_gaps_class(&gaps, side, 384, 12, fmb_bound_times(e, e_bound));
    if (fmb_gaps_done(&gaps, f.known, &out) || asked == FMB_ASK_FACES)
        return out;
    fmb_cuboids_cross(&c, 3, fmb_cuboids_count(kind));
    lane edge = lane_max(fmb_cuboids_ridge(kind, &c, 0), fmb_cuboids_ridge(kind, &c, 1));
    fmb_gaps_class(&gaps, lane_max(edge, fmb_cuboids_ridge(kind, &c, 2)), 92, 4, e_bound);
    if (moves) {
        lane swept = lane_max(fmb_cuboids_side(kind, &c, 0, 3), fmb_cuboids_side(kind, &c, 1, 3));
        swept = lane_max(swept, fmb_cuboids_side(kind, &c, 2, 3));
        const fmb_bound drift_bound = fmb_bound_times(fmb_bound_of_speed(&f), c.bound);
        fmb_gaps_class(&gaps, swept, 384, 12, fmb_bound_times(e, drift_bound));
        fmb_gaps_class(&gaps, fmb_cuboids_ridge(kind, &c, 3), 92, 4, drift_bound);
    }
    return fmb_gaps_bits(&gaps, f.known);
}

#endif
