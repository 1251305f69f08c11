/* minors_point.h: a common point proves that frames meet where rows cannot: two parallel edges, or
 * coplanar ones, give rows of zeros, whose computed gap is 0 up to errors and whose signs are
 * undefined.
 *
 * For |x_j| <= 1 the point z = center + sum x_j g_j is in B at some time. If all |z_r| < 1, then
 * for slightly smaller x it is in the interiors of both. Coordinate descent on the squared distance
 * of z from the cube |z_r| <= 0.9 searches such x: a step along g_j goes to the minimum of the
 * parabola with the present slope and the largest curvature |g_j|^2 that this function has
 * anywhere, so the distance never increases. If B moves, it begins in the middle of the times at
 * which B's bounds meet the cube: of parallel frames these are the times at which they meet.
 *
 * For simplices, z = sum (1 + x_j) g_j over the corners g_j, at t = 0, is a point of B times
 * sum (1 + x_j); it is in A's interior if all z_r > 0. Here the descent aims at z_r >= 0.1.
 */
#ifndef FMB_PAIR_MINORS_POINT_H
#define FMB_PAIR_MINORS_POINT_H

#include "pair/kernels/minors/minors_view.h"

enum { MINORS_SWEEPS = 12 };

typedef struct minors_point {
    lane x[FMB_MINORS_MOST], step[FMB_MINORS_MOST]; /* step: 1 / the column squared */
    lane z[FMB_MINORS_MOST_DIM];
} minors_point;

/* Columns that a point is made of. */
FMB_INLINE int minors_count_generators(minors_kind d)
{
    return d.simplices ? d.dim + 1 : d.n;
}

/* Coordinate r of the point. */
FMB_INLINE lane minors_place(minors_kind d, const minors_view *v, const minors_point *p, int r)
{
    const lane *e = v->e + r * minors_stride(d, 1);
    lane z = lane_of(0);
    if (!d.simplices)
        z = v->center[r];
    for (int j = 0; j < minors_count_generators(d); j++)
        z = lane_fma(p->x[j] + lane_of(d.simplices), e[j], z);
    return z;
}

FMB_INLINE lane minors_clamp(lane x, double most)
{
    return lane_max(lane_of(-most), lane_min(lane_of(most), x));
}

/* The share of the drift, the last column of a cuboid that moves, where the search begins. */
FMB_INLINE lane minors_begin_drift(minors_kind d, const minors_view *v)
{
    lane first = lane_of(-1), last = lane_of(1);
    for (int r = 0; r < d.dim; r++) {
        const lane *e = v->e + r * d.n;
        const lane drift = lane_abs(e[d.dim]) + lane_of(0x1p-500);
        const lane at = lane_times_sign(v->center[r], e[d.dim]);
        lane reach = lane_of(0.9);
        for (int j = 0; j < d.dim; j++)
            reach = reach + lane_abs(e[j]);
        first = lane_max(first, (-reach - at) / drift);
        last = lane_min(last, (reach - at) / drift);
    }
    return minors_clamp(lane_of(0.5) * (first + last), 1);
}

FMB_INLINE void minors_begin_point(minors_kind d, const minors_view *v, minors_point *p)
{
    for (int j = 0; j < minors_count_generators(d); j++) {
        lane square = lane_of(0x1p-1000);
        for (int r = 0; r < minors_count_rows(d); r++) {
            const lane e = v->e[r * minors_stride(d, 1) + j];
            square = lane_fma(e, e, square);
        }
        p->step[j] = lane_of(1) / square;
        p->x[j] = lane_of(0);
    }
    if (d.moves && !d.simplices && !d.from_cuboid && !d.from_simplex)
        p->x[d.dim] = minors_begin_drift(d, v);
    for (int r = 0; r < minors_count_rows(d); r++)
        p->z[r] = minors_place(d, v, p, r);
}

/* The distance of z from its required interval. */
FMB_INLINE lane minors_off(minors_kind d, lane z)
{
    if (d.simplices || d.from_simplex)
        return lane_min(z - lane_of(0.1), lane_of(0));
    return z - minors_clamp(z, 0.9);
}

FMB_INLINE void minors_sweep(minors_kind d, const minors_view *v, minors_point *p)
{
    for (int j = 0; j < minors_count_generators(d); j++) {
        const lane *e = v->e + j;
        const int row = minors_stride(d, 1);
        lane along = lane_of(0);
        for (int r = 0; r < minors_count_rows(d); r++)
            along = lane_fma(minors_off(d, p->z[r]), e[r * row], along);
        lane to = minors_clamp(lane_fnma(along, p->step[j], p->x[j]), 1), by = to - p->x[j];
        p->x[j] = to;
        for (int r = 0; r < minors_count_rows(d); r++)
            p->z[r] = lane_fma(by, e[r * row], p->z[r]);
    }
}

/* Is the point in A's interior? z is computed anew, so that earlier errors do not add up. */
FMB_INLINE unsigned minors_check_point(minors_kind d, const minors_view *v, const minors_point *p)
{
    const double n = minors_count_generators(d);
    const double columns = n * minors_entry_error(d), sums = (n + 1) * (2 * n + 4);
    const lane error = lane_of(1.01 * 0x1p-53 *
                               (d.simplices ? n * (2 * d.dim + 4) * 2 + 2 * sums
                                            : minors_center_error(d) + columns + sums));
    minors_said inside = minors_silent();
    for (int r = 0; r < minors_count_rows(d); r++) {
        const lane z = minors_place(d, v, p, r);
        lane gap = lane_abs(z) - lane_of(1);
        if (d.simplices || d.from_simplex)
            gap = lane_of(0) - z;
        minors_hear(&inside, gap, error * v->g[r]);
    }
    return minors_bits(&inside).meet;
}

/* The lanes of `wanted` where a point proves that the frames meet. Few pairs get here: so this is
 * not inlined into the kernels, and compiled once for all dimensions. */
static FMB_NEVER_CLONED unsigned minors_find_point(minors_kind d, const minors_view *v,
                                                   unsigned wanted)
{
    minors_point p;
    unsigned found = 0;
    minors_begin_point(d, v, &p);
    for (int i = 0; i < MINORS_SWEEPS && wanted & ~found; i++) {
        minors_sweep(d, v, &p);
        found |= minors_check_point(d, v, &p);
    }
    return found;
}

#endif
