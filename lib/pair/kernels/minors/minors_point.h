/* minors_point.h: a point in both cuboids proves that they meet where no row can: edges of the two
 * that are parallel, or share a plane with others, make rows of zeros, whose gap is 0 but for
 * errors.
 *
 * With |x_j| <= 1 the point center + sum x_j g_j is in B, at some time; if all its coordinates are
 * less than 1 then, with x drawn in a little, there is a point in the interiors of both.
 * Such x are looked for by coordinate descent on the squared distance from 0.9 of that cuboid: each
 * step goes along g_j to the least of the parabola that has the same slope and the largest
 * curvature that this distance has anywhere, so it never grows.
 */
#ifndef FMB_PAIR_MINORS_POINT_H
#define FMB_PAIR_MINORS_POINT_H

#include "pair/kernels/minors/minors_view.h"

enum { MINORS_SWEEPS = 12 };

typedef struct minors_point {
    lane x[FMB_MINORS_MOST], step[FMB_MINORS_MOST]; /* step: 1 / the column squared */
    lane z[FMB_MINORS_MOST_DIM];
} minors_point;

FMB_INLINE void minors_begin_point(minors_kind d, const minors_view *v, minors_point *p)
{
    for (int r = 0; r < d.dim; r++)
        p->z[r] = v->center[r];
    for (int j = 0; j < d.n; j++) {
        lane square = lane_of(0x1p-1000);
        for (int r = 0; r < d.dim; r++)
            square = lane_fma(v->e[r * d.n + j], v->e[r * d.n + j], square);
        p->step[j] = lane_of(1) / square;
        p->x[j] = lane_of(0);
    }
}

FMB_INLINE lane minors_clamp(lane x, double most)
{
    return lane_max(lane_of(-most), lane_min(lane_of(most), x));
}

FMB_INLINE void minors_sweep(minors_kind d, const minors_view *v, minors_point *p)
{
    for (int j = 0; j < d.n; j++) {
        lane along = lane_of(0);
        for (int r = 0; r < d.dim; r++)
            along = lane_fma(p->z[r] - minors_clamp(p->z[r], 0.9), v->e[r * d.n + j], along);
        lane to = minors_clamp(lane_fnma(along, p->step[j], p->x[j]), 1), by = to - p->x[j];
        p->x[j] = to;
        for (int r = 0; r < d.dim; r++)
            p->z[r] = lane_fma(by, v->e[r * d.n + j], p->z[r]);
    }
}

/* Is the point in A's interior? z is computed anew: what it was off by before does not count. */
FMB_INLINE unsigned minors_check_point(minors_kind d, const minors_view *v, const minors_point *p)
{
    const double n = d.n, columns = n * minors_entry_error(d), sums = (n + 1) * (2 * n + 4);
    const lane error = lane_of(1.01 * 0x1p-53 * (minors_center_error(d) + columns + sums));
    minors_said inside = minors_silent();
    for (int r = 0; r < d.dim; r++) {
        lane z = v->center[r];
        for (int j = 0; j < d.n; j++)
            z = lane_fma(p->x[j], v->e[r * d.n + j], z);
        minors_hear(&inside, lane_abs(z) - lane_of(1), error * v->g[r]);
    }
    return minors_bits(&inside).meet;
}

/* Lanes where a point proves that they meet. Few pairs get here: not in the kernels, and once for
 * all dimensions. */
static FMB_NEVER_CLONED unsigned minors_find_point(minors_kind d, const minors_view *v)
{
    minors_point p;
    unsigned found = 0;
    minors_begin_point(d, v, &p);
    for (int i = 0; i < MINORS_SWEEPS; i++) {
        minors_sweep(d, v, &p);
        found |= minors_check_point(d, v, &p);
    }
    return found;
}

#endif
