/* local_frame.h: a block of pairs in coordinates of A, without a division.
 *
 * With n_i the rows of the adjugate of the matrix whose columns are A's axes a_k, n_i a_k is det A
 * if i = k, else 0. So in the coordinates y_i = n_i (x - origin of A), times the sign of det A, the
 * cuboid A is 0 <= y_i <= size, and the simplex A is 0 <= y_i, sum y_i <= size, with size = |det
 * A|; B has its origin at `shift`, edges e_k, and moves by `drift`.
 *
 * alpha, beta, delta and omega are the largest absolute values of A's axes, B's axes, shift and
 * drift in a lane (omega at least 2^-50); gamma is the product of the largest numbers of the two
 * largest axes of A, so that a slender A has small bounds (in the plane: alpha). Each number is
 * within LOCAL_FRAME_ERROR times its bound: docs/error-bounds.md, "Local frame".
 *
 * This holds in lanes that are `known`: alpha and beta are between 2^-50 and 2^50, gamma is at
 * least 2^-100, delta and omega are at most 2^50, no number is a NaN, and the sign of det A is
 * certain. Then polynomials of degree up to 14 in these numbers do not overflow, and underflow does
 * not matter: it is an error of 2^-1075, while a bound, a product of at most 14 of these numbers,
 * is at least 2^-700, and u times the bound is far larger. (delta may be smaller, but in all tests
 * it is added to terms with alpha or beta in its place.)
 *
 * Source: Gottschalk, Lin, Manocha 1996, who test boxes in the frame of one of them; the adjugate
 * in place of the inverse spares the division.
 */
#ifndef FMB_PAIR_LOCAL_FRAME_H
#define FMB_PAIR_LOCAL_FRAME_H

#include <stdbool.h>

#include "pair/kernels/lane/lane.h"

#define LOCAL_FRAME_ERROR (6.1 * 0x1p-53)

typedef struct local_frame {
    lane size, e[3][3], shift[3], drift[3]; /* e[k][i]: coordinate i of edge k */
    lane volume;                            /* det A, or size: local_frame_make */
    lane alpha, beta, delta, omega;
    lane most_size, most_e, most_shift, most_drift; /* the bounds above */
    bool single;      /* constant: numbers of frames were rounded to floats. If so, also: */
    lane input_error; /* what numbers above are off by for that, over their bounds */
    /* their largest absolute values as computed, or 2^-8 of the bounds if that is more */
    lane found_size, found_e, found_shift, found_drift;
    lane_mask known;
} local_frame;

FMB_INLINE lane local_frame_largest(const double *rows, int n)
{
    lane most = lane_abs(lane_load(rows));
    for (int r = 1; r < n; r++)
        most = lane_max_abs(most, lane_load(rows + r * FMB_LANES));
    return most;
}

/* The adjugate of a, whose rows are axes. */
FMB_INLINE void local_frame_adjugate(int dim, lane a[3][3], lane n[3][3])
{
    if (dim == 2) {
        n[0][0] = a[1][1];
        n[0][1] = -a[1][0];
        n[1][0] = -a[0][1];
        n[1][1] = a[0][0];
        return;
    }
    for (int i = 0; i < 3; i++) {
        const lane *p = a[(i + 1) % 3], *q = a[(i + 2) % 3];
        for (int j = 0; j < 3; j++) {
            int s = (j + 1) % 3, t = (j + 2) % 3;
            n[i][j] = lane_fms(p[s], q[t], p[t] * q[s]);
        }
    }
}

FMB_INLINE lane local_frame_dot(int dim, const lane *n, const lane *x)
{
    lane sum = n[0] * x[0];
    for (int j = 1; j < dim; j++)
        sum = lane_fma(n[j], x[j], sum);
    return sum;
}

/* In the plane: the product of x and y turned by a right angle, (y_1, -y_0), in the order of
 * operations of local_frame_dot but without negating a number; and its negative. */
FMB_INLINE lane local_frame_turned(const lane *y, const lane *x)
{
    return lane_fnma(y[0], x[1], y[1] * x[0]);
}

FMB_INLINE lane local_frame_turned_back(const lane *y, const lane *x)
{
    return lane_fms(y[0], x[1], y[1] * x[0]);
}

FMB_INLINE void local_frame_load(lane *x, const double *rows, int n)
{
    for (int j = 0; j < n; j++)
        x[j] = lane_load(rows + j * FMB_LANES);
}

/* Set alpha; return gamma, which bounds products of numbers of two axes (in the plane, of one). */
FMB_INLINE lane local_frame_measure_axes(int dim, const double *axes, local_frame *f)
{
    lane size[3];
    for (int k = 0; k < dim; k++)
        size[k] = local_frame_largest(axes + k * dim * FMB_LANES, dim);
    f->alpha = lane_max(size[0], size[1]);
    if (dim == 2)
        return f->alpha;
    lane least = lane_min(size[0], size[1]), second = lane_min(f->alpha, size[2]);
    f->alpha = lane_max(f->alpha, size[2]);
    return f->alpha * lane_max(least, second);
}

/* Set delta and omega, and with numbers rounded to floats input_error: dim factors at most are off.
 */
FMB_INLINE void local_frame_measure_differences(int dim, bool moves, bool single,
                                                const double *block, local_frame *f)
{
    const double *drift = block + dim * (1 + 2 * dim) * FMB_LANES;
    const double *more = drift + moves * dim * FMB_LANES;
    f->delta = single ? lane_load(more) : local_frame_largest(block, dim);
    f->omega = lane_of(0);
    if (moves)
        f->omega = single ? lane_load(more + FMB_LANES) : local_frame_largest(drift, dim);
    if (single)
        f->input_error = lane_of(dim) * lane_load(more + 2 * FMB_LANES);
}

/* The largest absolute value of some numbers, or 2^-8 of their bound. */
FMB_INLINE lane local_frame_found(int n, const lane *x, lane most)
{
    most = lane_of(0x1p-8) * most;
    for (int i = 0; i < n; i++)
        most = lane_max_abs(most, x[i]);
    return most;
}

FMB_INLINE void local_frame_find_sizes(int dim, bool moves, local_frame *f)
{
    f->found_size = local_frame_found(1, &f->size, f->most_size);
    f->found_shift = local_frame_found(dim, f->shift, f->most_shift);
    f->found_e = lane_of(0x1p-8) * f->most_e;
    for (int k = 0; k < dim; k++)
        for (int i = 0; i < dim; i++)
            f->found_e = lane_max_abs(f->found_e, f->e[k][i]);
    f->found_drift = lane_of(0);
    if (moves)
        f->found_drift = local_frame_found(dim, f->drift, f->most_drift);
}

/* The bounds, and which lanes are known. The largest absolute value may miss a NaN, and an infinity
 * only together with a NaN. But det A contains all numbers of A, and the coordinates 0 of shift,
 * edges and drift contain all other numbers; so a NaN makes size or the sum of those coordinates a
 * NaN, and no comparison with a NaN is true.
 */
FMB_INLINE void local_frame_measure(int dim, bool moves, bool single, const double *block,
                                    local_frame *f)
{
    const double *axes = block + dim * FMB_LANES;
    const lane low = lane_of(0x1p-50), high = lane_of(0x1p50);
    lane gamma = local_frame_measure_axes(dim, axes, f);
    f->beta = local_frame_largest(axes + dim * dim * FMB_LANES, dim * dim);
    local_frame_measure_differences(dim, moves, single, block, f);
    if (moves) /* or else errors of rows along a slow drift underflow, and so do their bounds */
        f->omega = lane_max(f->omega, low);
    lane scale = lane_of(dim == 2 ? 2 : 6) * gamma;
    f->most_size = scale * f->alpha;
    f->most_e = scale * f->beta;
    f->most_shift = scale * f->delta;
    f->most_drift = scale * f->omega;
    lane most = lane_max(lane_max(f->alpha, f->beta), lane_max(f->delta, f->omega));
    f->known = lane_and(lane_less(low, lane_min(f->alpha, f->beta)), lane_less(most, high));
    f->known = lane_and(f->known, lane_less(low * low, gamma));
    /* the sign of det A must be certain */
    lane error = lane_of(LOCAL_FRAME_ERROR);
    if (single) {
        error = error + f->input_error;
        local_frame_find_sizes(dim, moves, f);
    }
    f->known = lane_and(f->known, lane_less(error * f->most_size, f->size));
    lane sum = f->shift[0];
    for (int k = 0; k < dim; k++)
        sum = sum + f->e[k][0];
    if (moves)
        sum = sum + f->drift[0];
    f->known = lane_and(f->known, lane_less(sum, lane_of(0x1p1000)));
}

/* Coordinates of x: the rows of the adjugate n, times x. In the plane n is used only if `turned`.
 */
FMB_INLINE void local_frame_look(int dim, bool turned, lane a[3][3], lane n[3][3], const lane *x,
                                 lane *out)
{
    if (dim == 2 && !turned) {
        out[0] = local_frame_turned(a[1], x);
        out[1] = local_frame_turned_back(a[0], x);
        return;
    }
    for (int i = 0; i < dim; i++)
        out[i] = local_frame_dot(dim, n[i], x);
}

/* In place, as a returned structure of this size may be copied. single: constant, the numbers of
 * frames were rounded to floats, and three rows follow in the block (packed_kernels.h). turned: y
 * has the sign of det A, and volume is size. Otherwise volume is det A, and A is 0 <= y_i / volume
 * (<= 1). */
FMB_INLINE void local_frame_make(int dim, bool moves, bool turned, bool single, const double *block,
                                 local_frame *f)
{
    f->single = single;
    lane a[3][3], n[3][3], x[3];
    const double *row = block + dim * FMB_LANES;
    for (int k = 0; k < dim; k++, row += dim * FMB_LANES)
        local_frame_load(a[k], row, dim);
    local_frame_adjugate(dim, a, n);
    lane det = dim == 2 ? local_frame_turned(a[1], a[0]) : local_frame_dot(dim, n[0], a[0]);
    f->size = lane_abs(det);
    f->volume = det;
    if (turned)
        f->volume = f->size;
    for (int i = 0; turned && i < dim; i++)
        for (int j = 0; j < dim; j++)
            n[i][j] = lane_times_sign(n[i][j], det);
    local_frame_load(x, block, dim);
    local_frame_look(dim, turned, a, n, x, f->shift);
    for (int k = 0; k < dim; k++, row += dim * FMB_LANES) {
        local_frame_load(x, row, dim);
        local_frame_look(dim, turned, a, n, x, f->e[k]);
    }
    if (moves) {
        local_frame_load(x, row, dim);
        local_frame_look(dim, turned, a, n, x, f->drift);
    }
    local_frame_measure(dim, moves, single, block, f);
}

#endif
