/* box_view.h: one frame, the guest, in the coordinates of another, the host.
 *
 * With n_i the rows of the adjugate of the host's axes, times the sign of their determinant, a
 * point x has values y_i = n_i (x - origin of the host). It is in the host where all values are
 * within 0 ... size = |det|; for a simplex, where all are at least 0, with one value more, size -
 * sum y_i. (The same idea as in local_frame.h, with tighter bounds on errors.)
 *
 * Errors: error_i = steps unit most_i bounds those of value i: docs/error-bounds.md, "View".
 *
 * `known` says where alpha, beta, drift and places are within 2^-40 ... 2^40 (the last two: at
 * most) and size > its error. Then nothing overflows, and underflow does not hurt: it changes a
 * value by less than 2^-1020, a product of three values by less than 2^-770, but to every most_i
 * 2^-200 is added, which makes the bounds on these errors 2^-302 and 2^-700 at least.
 */
#ifndef FMB_PAIR_BOX_VIEW_H
#define FMB_PAIR_BOX_VIEW_H

#include "pair/kernels/double_double.h"

enum { BOX_CORNERS = 8, BOX_VALUES = 4 };

/* What is constant in a kernel. */
typedef struct box_kind {
    int dim;
    bool moves, fine;
    int shape[2]; /* of A, of B */
} box_kind;

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

/* The factor of unit most in errors. */
FMB_BOX_INLINE double box_steps(const box_kind *k, int host)
{
    return k->fine ? 2 : 10 + 5 * k->moves + 3 * (k->shape[host] == FMB_SIMPLEX);
}

/* The adjugate of a, whose rows are axes, and N. */
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
            lane2 one = k->fine ? two_product(p[s], q[t]) : lane2_of(p[s] * q[t]);
            lane2 two = k->fine ? two_product(p[t], q[s]) : lane2_of(p[t] * q[s]);
            n[i][j] = lane2_subtract(k->fine, one, two);
            most[i][j] = lane_abs(one.hi) + lane_abs(two.hi);
        }
    }
}

FMB_BOX_INLINE lane2 box_dot(const box_kind *k, const lane2 *n, const lane2 *x)
{
    lane2 sum = lane2_times(k->fine, n[0], x[0]);
    for (int j = 1; j < k->dim; j++)
        sum = lane2_add(k->fine, sum, lane2_times(k->fine, n[j], x[j]));
    return sum;
}

FMB_BOX_INLINE lane2 box_dot_lanes(const box_kind *k, const lane2 *n, const lane *x)
{
    lane2 t[3];
    for (int j = 0; j < k->dim; j++)
        t[j] = lane2_of(x[j]);
    return box_dot(k, n, t);
}

/* y - x */
FMB_BOX_INLINE void box_difference(const box_kind *k, const lane *x, const lane *y, lane2 *out)
{
    for (int j = 0; j < k->dim; j++)
        out[j] = k->fine ? two_sum(y[j], -x[j]) : lane2_of(y[j] - x[j]);
}

/* The value that a simplex has besides. */
FMB_BOX_INLINE void box_last_value(const box_kind *k, lane2 from, lane2 *y)
{
    for (int i = 0; i < k->dim; i++)
        from = lane2_subtract(k->fine, from, y[i]);
    y[k->dim] = from;
}

/* X_j but for the drift, given the shift. */
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

FMB_BOX_INLINE void box_errors(const box_kind *k, int guest, const box_frame *a, const box_frame *b,
                               lane most[3][3], const lane2 *shift, const lane2 *drift, box_view *v)
{
    lane x[3], whole = lane_of(0x1p-200), sum = lane_of(0),
               unit = lane_of(box_steps(k, 1 - guest) * LANE2_UNIT(k->fine));
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
    for (int i = 0; i <= k->dim; i++)
        v->error[i] = unit * v->most[i];
    v->known = lane_less(unit * whole, v->size.hi);
}

FMB_BOX_INLINE void box_view_of(const box_kind *k, int guest, const box_frame *a,
                                const box_frame *b, box_view *v)
{
    lane2 n[3][3], shift[3], drift[3];
    lane most[3][3];
    box_adjugate(k, a->axes, n, most);
    lane2 det = box_dot_lanes(k, n[0], a->axes[0]);
    v->size = lane2_times_sign(k->fine, det, det.hi);
    for (int i = 0; i < k->dim; i++)
        for (int j = 0; j < k->dim; j++)
            n[i][j] = lane2_times_sign(k->fine, n[i][j], det.hi);
    box_difference(k, a->origin, b->origin, shift);
    box_difference(k, a->speed, b->speed, drift);
    for (int i = 0; i < k->dim; i++) {
        v->start[i] = box_dot(k, n[i], shift);
        for (int l = 0; l < k->dim; l++)
            v->edge[l][i] = box_dot_lanes(k, n[i], b->axes[l]);
        v->drift[i] = box_dot(k, n[i], drift);
    }
    if (k->shape[1 - guest] == FMB_SIMPLEX) {
        box_last_value(k, v->size, v->start);
        for (int l = 0; l < k->dim; l++)
            box_last_value(k, lane2_of(lane_of(0)), v->edge[l]);
        box_last_value(k, lane2_of(lane_of(0)), v->drift);
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
                y[i] = lane2_add(k->fine, y[i], v->edge[l][i]);
    }
}

#endif
