/* box_still_view.h: one frame, the guest, in the coordinates of another, the host; both stand
 * still.
 *
 * As in box_view.h, with n_i the rows of the adjugate of the host's axes, times the sign of their
 * determinant, a point x has values n_i (x - origin of the host), and is in the host where all are
 * within 0 ... size = |det|; or for a simplex where all are at least 0, with one value more, size
 * less the others. Here values are kept as numbers y_i that ask for simpler comparisons: for a
 * cuboid host less half = size / 2, so that |y_i| <= half; for a simplex, more by the bound wide_i
 * on all errors, so that y_i >= 0 is certain in the host.
 *
 * Errors: wide_i bounds those of value i, and what clipping rounds: docs/error-bounds.md, "Still
 * view".
 */
#ifndef FMB_PAIR_BOX_STILL_VIEW_H
#define FMB_PAIR_BOX_STILL_VIEW_H

#include "pair/kernels/box/box_view.h"

/* The places of the shapes in a box_kind. */
enum { STILL_HOST, STILL_GUEST };

/* One frame of a block, from the origin of A. */
typedef struct still_frame {
    lane origin[3], axes[3][3];
    lane extent[3]; /* the sum of its absolute axes */
} still_frame;

typedef struct still_view {
    lane size, half;
    lane start[BOX_VALUES], edge[3][BOX_VALUES]; /* y_i of the guest's origin and axes */
    lane wide[BOX_VALUES];
    lane_mask known; /* the sign of the determinant is certain */
} still_view;

/* The adjugate n, and W, which bounds its errors and those of sums (docs/error-bounds.md). */
FMB_BOX_INLINE void still_adjugate(const box_kind *k, const lane a[3][3], lane n[3][3],
                                   lane rough[3][3])
{
    static const double ns[2][3] = {{5, 5, 4}, {4, 3, 2}}, plane[2][2] = {{2, 2}, {2, 1}};
    const double twos = FMB_LANE_FUSED ? 1 : 2;
    FMB_UNROLL
    for (int i = 0; i < k->dim; i++) {
        FMB_UNROLL
        for (int j = 0; j < k->dim; j++) {
            if (k->dim == 2) {
                lane entry = a[1 - i][1 - j];
                n[i][j] = i == j ? entry : -entry;
                rough[i][j] = lane_of(plane[FMB_LANE_FUSED][j]) * lane_abs(entry);
                continue;
            }
            const lane *p = a[(i + 1) % 3], *q = a[(i + 2) % 3];
            const int s = (j + 1) % 3, t = (j + 2) % 3;
            lane two = p[t] * q[s];
            n[i][j] = lane_fms(p[s], q[t], two);
            rough[i][j] = lane_fma(lane_of(ns[FMB_LANE_FUSED][j]), lane_abs(n[i][j]),
                                   lane_of(twos) * lane_abs(two));
        }
    }
}

FMB_BOX_INLINE lane still_dot(int dim, const lane *n, const lane *x)
{
    lane sum = n[0] * x[0];
    FMB_UNROLL
    for (int j = 1; j < dim; j++)
        sum = lane_fma(n[j], x[j], sum);
    return sum;
}

FMB_BOX_INLINE lane still_dot_abs(int dim, const lane *rough, const lane *x)
{
    lane sum = rough[0] * lane_abs(x[0]);
    FMB_UNROLL
    for (int j = 1; j < dim; j++)
        sum = lane_fma(rough[j], lane_abs(x[j]), sum);
    return sum;
}

/* The value that a simplex has besides. */
FMB_BOX_INLINE void still_last_value(int dim, still_view *v)
{
    v->start[dim] = v->size;
    FMB_UNROLL
    for (int i = 0; i < dim; i++)
        v->start[dim] = v->start[dim] - v->start[i];
    FMB_UNROLL
    for (int l = 0; l < dim; l++) {
        v->edge[l][dim] = -v->edge[l][0];
        FMB_UNROLL
        for (int i = 1; i < dim; i++)
            v->edge[l][dim] = v->edge[l][dim] - v->edge[l][i];
    }
}

typedef struct still_size {
    lane corner, edge, sum; /* M_i, E_i, F_i */
} still_size;

FMB_BOX_INLINE still_size still_size_of(const box_kind *k, const still_view *v, int i)
{
    const bool simplex = k->shape[STILL_GUEST] == FMB_SIMPLEX;
    const lane half = lane_of(0.5), start = v->start[i];
    lane total = lane_of(0), sum = total, longest = total, most = lane_abs(start);
    FMB_UNROLL
    for (int l = 0; l < k->dim; l++) {
        lane edge = v->edge[l][i];
        sum = sum + lane_abs(edge);
        longest = lane_max_abs(longest, edge);
        total = total + edge;
        if (simplex)
            most = lane_max_abs(most, start + edge);
    }
    if (simplex)
        return (still_size){most, longest + longest, sum};
    lane centre = lane_fma(half, total, start);
    return (still_size){lane_fma(half, sum, lane_abs(centre)), longest, sum};
}

/* From the values to numbers y_i, and their bounds; all: S sum_j W_ij X_j + S D for i < dim. */
FMB_BOX_INLINE void still_bound(const box_kind *k, const lane *all, lane off, still_view *v)
{
    const bool simplex = k->shape[STILL_HOST] == FMB_SIMPLEX;
    const int dim = k->dim;
    const lane u = lane_of(1.01 * 0x1p-53);
    lane base = lane_of(6) * v->half, others = lane_fma(lane_of(3), v->size, off),
         rest = lane_of(0);
    FMB_UNROLL
    for (int i = 0; i < box_values(k, STILL_HOST); i++) {
        if (!simplex)
            v->start[i] = v->start[i] - v->half;
        still_size s = still_size_of(k, v, i);
        lane wide = lane_fma(lane_of(6), s.corner, lane_fma(lane_of(3), s.edge, base));
        if (i < dim) {
            wide = wide + all[i];
            others = others + all[i];
            rest = rest + (s.corner + s.sum);
        } else {
            wide = wide + others;
        }
        wide = lane_fma(lane_of(i < dim ? 1 : 4), i < dim ? s.sum : rest, wide);
        v->wide[i] = u * wide;
        if (simplex)
            v->start[i] = v->start[i] + v->wide[i];
    }
}

/* shift: from the origin of the host, a, to that of the guest, b. 2^-200 is for underflow: products
 * of numbers up to 2^40 that underflow change a value by less than 2^-1025, and wide_i is at least
 * 2^-253. As size is at least 2^-252 where it is known, quotients by it and by |d_i|, which is
 * taken to be at least 2^-10 wide_i, are finite. */
FMB_BOX_INLINE void still_view_of(const box_kind *k, const still_frame *a, const still_frame *b,
                                  const lane *shift, still_view *v)
{
    const int dim = k->dim;
    lane n[3][3], rough[3][3], x[3], all[3];
    still_adjugate(k, a->axes, n, rough);
    lane det = still_dot(dim, n[0], a->axes[0]);
    lane off = still_dot_abs(dim, rough[0], a->axes[0]) + lane_of(0x1p-200);
    v->size = lane_times_sign(det, det);
    v->half = lane_of(0.5) * v->size;
    v->known = lane_less(lane_of(0x1p-52) * (off + v->size), v->size);
    FMB_UNROLL
    for (int j = 0; j < dim; j++)
        x[j] = lane_abs(shift[j]) + b->extent[j];
    FMB_UNROLL
    for (int i = 0; i < dim; i++) {
        FMB_UNROLL
        for (int j = 0; j < dim; j++)
            n[i][j] = lane_times_sign(n[i][j], det);
        v->start[i] = still_dot(dim, n[i], shift);
        FMB_UNROLL
        for (int l = 0; l < dim; l++)
            v->edge[l][i] = still_dot(dim, n[i], b->axes[l]);
        all[i] = still_dot_abs(dim, rough[i], x) + off;
    }
    if (k->shape[STILL_HOST] == FMB_SIMPLEX)
        still_last_value(dim, v);
    still_bound(k, all, off, v);
}

#endif
