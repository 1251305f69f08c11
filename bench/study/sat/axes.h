/* axes.h: shared by the kernels of plane.h and space.h: loads, spans, errors.
 *
 * All positions are doubled and in world coordinates, relative to the corner of A. A frame whose
 * values on an axis go from low to high has the width high - low and the middle high + low; two
 * frames overlap there by
 *
 *     width of A + width of B - |middle of A - middle of B|
 *
 * (twice the depth, and negative if the axis separates them: Gottschalk, Lin, Manocha 1996). All
 * numbers below are determinants of axes of A, axes of B, the drift d and the vectors of sat_rays.
 * No number is scaled by the volume of A, so flat frames lose nothing, and no sign of a determinant
 * matters.
 */
#ifndef FMB_STUDY_SAT_AXES_H
#define FMB_STUDY_SAT_AXES_H

#include <stdbool.h>

#include "pair/kernels/lane/local_frame.h"

/* The kind of kernel: a constant in each compiled kernel. If A is a simplex, so is B. */
typedef struct sat_kind {
    int dim;
    bool moves, a_simplex, b_simplex;
} sat_kind;

typedef struct sat_rays {
    lane a[3][3], b[3][3]; /* axes */
    lane drift[3];
    lane corner[3]; /* (sum of a) - (2 shift + drift): twice the middle of a cuboid A, less twice
                       B's corner at time 1/2 */
    lane centre[3]; /* corner - (sum of b): the same for B's middle */
    lane origin[3]; /* centre - (sum of a): the same for A's corner */
    lane alpha, beta, omega; /* the largest numbers of a, b and drift */
    lane reach; /* 3 alpha + 3 beta + 2 delta + omega bounds corner, centre and origin */
    lane_mask known;
} sat_rays;

/* The range of some values and 0. */
typedef struct sat_span {
    lane width, middle;
} sat_span;

FMB_INLINE lane sat_largest(int dim, const lane *x, lane most)
{
    for (int j = 0; j < dim; j++)
        most = lane_max(most, lane_abs(x[j]));
    return most;
}

/* The bounds of the errors; lanes are known under the conditions of local_frame.h, except the sign
 * of det A, which does not matter here. A NaN in any input makes centre NaN. */
FMB_INLINE void sat_measure(sat_kind k, const lane *shift, sat_rays *r)
{
    int d = k.dim;
    lane zero = lane_of(0), alpha = zero, beta = zero, sum = r->centre[0] + r->centre[1];
    for (int i = 0; i < d; i++) {
        alpha = sat_largest(d, r->a[i], alpha);
        beta = sat_largest(d, r->b[i], beta);
    }
    lane delta = sat_largest(d, shift, zero);
    lane omega = k.moves ? sat_largest(d, r->drift, zero) : zero;
    if (d == 3)
        sum = sum + r->centre[2];
    r->alpha = alpha;
    r->beta = beta;
    r->omega = omega;
    r->reach = lane_of(3) * (alpha + beta) + (delta + delta) + omega;
    lane most = lane_max(lane_max(alpha, beta), lane_max(delta, omega));
    r->known = lane_and(lane_less(lane_of(0x1p-50), lane_min(alpha, beta)),
                        lane_less(most, lane_of(0x1p50)));
    r->known = lane_and(r->known, lane_less(lane_abs(sum), lane_of(INFINITY)));
}

FMB_INLINE sat_rays sat_load(sat_kind k, const double *block)
{
    sat_rays r;
    int d = k.dim, row = d * FMB_LANES;
    lane shift[3];
    local_frame_load(shift, block, d);
    for (int i = 0; i < d; i++) {
        local_frame_load(r.a[i], block + (1 + i) * row, d);
        local_frame_load(r.b[i], block + (1 + d + i) * row, d);
    }
    if (k.moves)
        local_frame_load(r.drift, block + (1 + 2 * d) * row, d);
    for (int j = 0; j < d; j++) {
        lane a = r.a[0][j] + r.a[1][j], b = r.b[0][j] + r.b[1][j], twice = shift[j] + shift[j];
        if (d == 3) {
            a = a + r.a[2][j];
            b = b + r.b[2][j];
        }
        if (k.moves)
            twice = twice + r.drift[j];
        r.corner[j] = a - twice;
        r.centre[j] = r.corner[j] - b;
        r.origin[j] = -(twice + b);
    }
    sat_measure(k, shift, &r);
    return r;
}

FMB_INLINE sat_span sat_span_of(int n, const lane *x)
{
    lane high = lane_of(0), low = lane_of(0);
    for (int i = 0; i < n; i++) {
        high = lane_max(high, x[i]);
        low = lane_min(low, x[i]);
    }
    return (sat_span){high - low, high + low};
}

/* A cuboid with edges x, about its middle. */
FMB_INLINE sat_span sat_span_of_cuboid(int n, const lane *x)
{
    lane width = lane_abs(x[0]);
    for (int i = 1; i < n; i++)
        width = width + lane_abs(x[i]);
    return (sat_span){width, lane_of(0)};
}

FMB_INLINE sat_span sat_span_of_frame(bool simplex, int n, const lane *x)
{
    return simplex ? sat_span_of(n, x) : sat_span_of_cuboid(n, x);
}

/* The certain verdicts so far; known: lanes whose error bounds are valid. */
typedef struct sat_state {
    lane_mask apart, meet, known;
} sat_state;

/* Update with the least overlap of a class of axes, accurate to error. */
FMB_INLINE void sat_learn(sat_state *s, lane least, lane error)
{
    s->apart = lane_or(s->apart, lane_less(least, -error));
    s->meet = lane_and(s->meet, lane_less(error, least));
}

#endif
