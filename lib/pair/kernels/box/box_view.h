/* box_view.h: one frame, the guest, in the coordinates of another, the host.
 *
 * With n_i the rows of the adjugate of the host's axes, times the sign of their determinant det, a
 * point x has the values y_i = n_i (x - origin of the host). x is in a cuboid host iff all values
 * are within 0 ... size = |det|; in a simplex host iff all are at least 0, one more value, size -
 * sum y_i, included. (As in local_frame.h, but with tighter error bounds.)
 *
 * All numbers are double-doubles. error_i bounds the error of value i; where only the upper halves
 * are used, the omission of the lower ones is included: docs/error-bounds.md, "View".
 *
 * A lane is `known` if alpha and beta, the largest numbers of A's and B's axes, are within 2^-40
 * ... 2^40, drift and places are at most 2^40, and size exceeds its error. Then nothing overflows,
 * and underflow does not matter:
 * - a product that underflows is off by at most 2^-1072. It enters a value with a factor of at most
 *   2^44 (the largest X_j), and products of two or three values with others of at most 2^128: so it
 *   changes values by less than 2^-1020, and products of two or three by 2^-888 and 2^-755;
 * - but 2^-200 is added to every most_i, so the bounds on these errors are at least 2^-301, 2^-497
 *   and 2^-694. Likewise quotients stay finite: size and |d_i| (box_cyrus_beck.h) are at least
 *   2^-311, |det| (box_cross.h) is at least 2^-502.
 */
#ifndef FMB_PAIR_BOX_VIEW_H
#define FMB_PAIR_BOX_VIEW_H

#include "pair/kernels/lane/double_double.h"

enum { BOX_CORNERS = 8, BOX_VALUES = 4 };

/* What is constant in a kernel. */
typedef struct box_kind {
    int dim;
    bool moves, fine; /* fine: the lower halves of double-doubles are used, too */
    int shape[2];     /* of A, of B */
} box_kind;

/* The kind k with another precision. */
FMB_BOX_INLINE box_kind box_in_precision(const box_kind *k, bool fine)
{
    return (box_kind){k->dim, k->moves, fine, {k->shape[0], k->shape[1]}};
}

/* One frame of a block; speed is 0 if nothing moves. */
typedef struct box_frame {
    lane origin[3], axes[3][3], speed[3];
} box_frame;

typedef struct box_view {
    lane2 size;
    lane2 start[BOX_VALUES], edge[3][BOX_VALUES], drift[BOX_VALUES]; /* of the guest */
    lane most[BOX_VALUES], error[BOX_VALUES];
    lane_mask known;
} box_view;

FMB_BOX_INLINE int box_values(const box_kind *k, int host)
{
    return k->dim + (k->shape[host] == FMB_SIMPLEX);
}

FMB_BOX_INLINE int box_corners(const box_kind *k, int guest)
{
    return k->shape[guest] == FMB_SIMPLEX ? k->dim + 1 : 1 << k->dim;
}

/* The adjugate n of a, whose rows are axes, and most = N (docs/error-bounds.md, "View"). */
FMB_BOX_INLINE void box_adjugate(const box_kind *k, const lane a[3][3], lane2 n[3][3],
                                 lane most[3][3])
{
    if (k->dim == 2) {
        for (int i = 0; i < 2; i++)
            for (int j = 0; j < 2; j++) {
                lane entry = a[1 - i][1 - j];
                n[i][j] = lane2_of(i == j ? entry : -entry);
                most[i][j] = lane_abs(entry);
            }
        return;
    }
    for (int i = 0; i < 3; i++) {
        const lane *p = a[(i + 1) % 3], *q = a[(i + 2) % 3];
        for (int j = 0; j < 3; j++) {
            int s = (j + 1) % 3, t = (j + 2) % 3;
            lane2 one = two_product(p[s], q[t]), two = two_product(p[t], q[s]);
            n[i][j] = lane2_subtract(true, one, two);
            most[i][j] = lane_abs(one.hi) + lane_abs(two.hi);
        }
    }
}

FMB_BOX_INLINE lane2 box_dot(int dim, const lane2 *n, const lane2 *x)
{
    lane2 sum = lane2_times(true, n[0], x[0]);
    for (int j = 1; j < dim; j++)
        sum = lane2_add(true, sum, lane2_times(true, n[j], x[j]));
    return sum;
}

FMB_BOX_INLINE lane2 box_dot_lanes(int dim, const lane2 *n, const lane *x)
{
    lane2 t[3];
    for (int j = 0; j < dim; j++)
        t[j] = lane2_of(x[j]);
    return box_dot(dim, n, t);
}

/* y - x */
FMB_BOX_INLINE void box_difference(int dim, const lane *x, const lane *y, lane2 *out)
{
    for (int j = 0; j < dim; j++)
        out[j] = two_sum(y[j], -x[j]);
}

/* The last value of a simplex: `from` less the other values. */
FMB_BOX_INLINE void box_last_value(int dim, lane2 from, lane2 *y)
{
    for (int i = 0; i < dim; i++)
        from = lane2_subtract(true, from, y[i]);
    y[dim] = from;
}

/* X_j without the drift, given the shift. */
FMB_BOX_INLINE lane box_extent(const box_kind *k, int guest, const box_frame *b, int j, lane shift)
{
    lane edges = lane_of(0), largest = lane_of(0);
    for (int l = 0; l < k->dim; l++) {
        edges = edges + lane_abs(b->axes[l][j]);
        largest = lane_max(largest, lane_abs(b->axes[l][j]));
    }
    if (k->shape[guest] == FMB_SIMPLEX)
        edges = edges + largest;
    return lane_abs(shift) + edges;
}

/* The error of value i where lower halves are ignored: docs/error-bounds.md, "View". */
FMB_BOX_INLINE lane box_halves(const box_kind *k, int guest, const box_view *v, int i)
{
    const double factor =
        1.25 + (k->shape[guest] == FMB_SIMPLEX) + (k->shape[1 - guest] == FMB_CUBOID);
    lane reach = v->size.hi + lane_abs(v->start[i].hi) + lane_abs(v->drift[i].hi);
    for (int l = 0; l < k->dim; l++)
        reach = reach + lane_abs(v->edge[l][i].hi);
    return lane_of(factor * 0x1p-53) * reach;
}

FMB_BOX_INLINE void box_errors(const box_kind *k, int guest, const box_frame *a, const box_frame *b,
                               lane most[3][3], const lane2 *shift, const lane2 *drift, box_view *v)
{
    lane x[3], whole = lane_of(0x1p-200), sum = lane_of(0), unit = lane_of(2 * LANE2_UNIT(true));
    for (int j = 0; j < k->dim; j++) {
        x[j] = box_extent(k, guest, b, j, shift[j].hi) + lane_abs(drift[j].hi);
        whole = lane_fma(most[0][j], lane_abs(a->axes[0][j]), whole);
    }
    for (int i = 0; i < k->dim; i++) {
        v->most[i] = whole;
        for (int j = 0; j < k->dim; j++)
            v->most[i] = lane_fma(most[i][j], x[j], v->most[i]);
        sum = sum + v->most[i];
    }
    v->most[k->dim] = sum;
    for (int i = 0; i < box_values(k, 1 - guest); i++) {
        v->error[i] = unit * v->most[i];
        if (!k->fine)
            v->error[i] = v->error[i] + box_halves(k, guest, v, i);
    }
    v->known = lane_less(unit * whole, v->size.hi);
}

FMB_BOX_INLINE void box_view_of(const box_kind *k, int guest, const box_frame *a,
                                const box_frame *b, box_view *v)
{
    lane2 n[3][3], shift[3], drift[3];
    lane most[3][3];
    box_adjugate(k, a->axes, n, most);
    lane2 det = box_dot_lanes(k->dim, n[0], a->axes[0]);
    v->size = lane2_times_sign(true, det, det.hi);
    for (int i = 0; i < k->dim; i++)
        for (int j = 0; j < k->dim; j++)
            n[i][j] = lane2_times_sign(true, n[i][j], det.hi);
    box_difference(k->dim, a->origin, b->origin, shift);
    box_difference(k->dim, a->speed, b->speed, drift);
    for (int i = 0; i < k->dim; i++) {
        v->start[i] = box_dot(k->dim, n[i], shift);
        for (int l = 0; l < k->dim; l++)
            v->edge[l][i] = box_dot_lanes(k->dim, n[i], b->axes[l]);
        v->drift[i] = k->moves ? box_dot(k->dim, n[i], drift) : lane2_of(lane_of(0));
    }
    if (k->shape[1 - guest] == FMB_SIMPLEX) {
        box_last_value(k->dim, v->size, v->start);
        for (int l = 0; l < k->dim; l++)
            box_last_value(k->dim, lane2_of(lane_of(0)), v->edge[l]);
        box_last_value(k->dim, lane2_of(lane_of(0)), v->drift);
    }
    box_errors(k, guest, a, b, most, shift, drift, v);
}

/* Values of corner c of the guest at t = 0: bit l of c says whether edge l is taken; corner l + 1
 * of a simplex is at the end of edge l. */
FMB_BOX_INLINE void box_corner(const box_kind *k, int host, const box_view *v, int c, lane2 *y)
{
    for (int i = 0; i < box_values(k, host); i++) {
        y[i] = v->start[i];
        for (int l = 0; l < k->dim; l++)
            if (k->shape[1 - host] == FMB_SIMPLEX ? c == l + 1 : c >> l & 1)
                y[i] = lane2_add(true, y[i], v->edge[l][i]);
    }
}

#endif
