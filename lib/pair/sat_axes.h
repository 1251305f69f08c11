/* sat_axes.h: what all kernels of sat.h share: the pair about A's centre, and projections.
 *
 * On an axis w the frames overlap by
 *
 *     min(high of B - low of A, high of A - low of B)
 *
 * which is negative exactly if w separates them. A cuboid reaches as far on both sides of its
 * centre, so for two of them this is (reach of A) + (reach of B) - |distance of the centres|
 * (Gottschalk 1996). A frame B that moves is B + [-v, v] with v half its drift; that adds |w v|.
 *
 * Units: two cuboids are doubled, so that nothing need be halved.
 */
#ifndef FMB_PAIR_SAT_AXES_H
#define FMB_PAIR_SAT_AXES_H

#include <stdbool.h>

#include "pair/front.h"

/* Which kernel; every one is compiled with a constant. A simplex A has a simplex B. */
typedef struct sat_kind {
    int dim;
    bool moves, a_simplex, b_simplex;
} sat_kind;

/* Coordinate `dim` is for a simplex A, whose coordinates y_i with y_dim = size - sum y_i are all
 * alike: A is where none is negative. */
typedef struct sat {
    lane a;       /* half the size of a cuboid A (doubled: its size), the size of a simplex */
    lane e[6][4]; /* edges of B: from its corner, then, of a simplex, opposite to edges from there;
                     in 3D edge 3 + m goes from corner m + 1 to m + 2 (modulo 3) */
    lane g[4];    /* from the centre of a cuboid A, or the corner of a simplex, to the centre of a
                     cuboid B, or the corner of a simplex, at time 1/2 */
    lane v[4];    /* half the drift */
} sat;

/* How far values of an axis reach from 0: the highest, and minus the lowest. */
typedef struct sat_reach {
    lane high, low;
} sat_reach;

/* From 0 to x; both ends are exact. */
FMB_INLINE sat_reach sat_to(lane x)
{
    lane high = lane_max(x, lane_of(0));
    return (sat_reach){high, high - x};
}

FMB_INLINE sat_reach sat_flip(sat_reach r)
{
    return (sat_reach){r.low, r.high};
}

FMB_INLINE sat_reach sat_join(sat_reach r, sat_reach s)
{
    return (sat_reach){lane_max(r.high, s.high), lane_max(r.low, s.low)};
}

FMB_INLINE sat_reach sat_even(lane radius)
{
    return (sat_reach){radius, radius};
}

/* A reaches a times ra from its centre or corner, B reaches rb from g. */
FMB_INLINE lane sat_overlap(sat_kind k, lane a, sat_reach ra, sat_reach rb, lane g)
{
    if (!k.b_simplex)
        return lane_fma(a, ra.high, rb.high) - lane_abs(g);
    if (!k.a_simplex)
        return lane_fma(a, ra.high, lane_min(rb.high + g, rb.low - g));
    return lane_min(lane_fma(a, ra.low, rb.high) + g, lane_fma(a, ra.high, rb.low) - g);
}

/* The edges of a simplex B that do not touch its corner, and the last coordinates. */
FMB_INLINE void sat_complete(sat_kind k, sat *s)
{
    int d = k.dim;
    for (int i = 0; k.b_simplex && i < d; i++) {
        for (int m = 0; d == 3 && m < 3; m++)
            s->e[3 + m][i] = s->e[(m + 2) % 3][i] - s->e[(m + 1) % 3][i];
        if (d == 2)
            s->e[2][i] = s->e[1][i] - s->e[0][i];
    }
    if (!k.a_simplex)
        return;
    lane sum = s->g[0], drift = s->v[0];
    for (int i = 1; i < d; i++) {
        sum = sum + s->g[i];
        drift = drift + s->v[i];
    }
    s->g[d] = s->a - sum;
    s->v[d] = -drift;
    for (int b = 0; b < (d == 3 ? 6 : 3); b++) {
        sum = s->e[b][0];
        for (int i = 1; i < d; i++)
            sum = sum + s->e[b][i];
        s->e[b][d] = -sum;
    }
}

FMB_INLINE sat sat_of(sat_kind k, const front *f)
{
    sat s;
    s.a = lane_of(k.a_simplex == k.b_simplex ? 1 : 0.5) * f->size;
    for (int i = 0; i < k.dim; i++) {
        s.g[i] = lane_of(k.b_simplex ? 1 : 2) * f->shift[i];
        if (!k.a_simplex)
            s.g[i] = s.g[i] - s.a;
        s.v[i] = lane_of(0);
        if (k.moves) {
            s.v[i] = lane_of(k.b_simplex ? 0.5 : 1) * f->drift[i];
            s.g[i] = s.g[i] + s.v[i];
        }
        for (int b = 0; b < k.dim; b++) {
            s.e[b][i] = f->e[b][i];
            if (!k.b_simplex)
                s.g[i] = s.g[i] + s.e[b][i];
        }
    }
    sat_complete(k, &s);
    return s;
}

/* The least overlap on the normals of A. Of a simplex A only the outer side matters. */
FMB_INLINE lane sat_normals_of_a(sat_kind k, const sat *s)
{
    lane least = lane_of(0);
    for (int i = 0; i < k.dim + k.a_simplex; i++) {
        lane high = lane_of(0), low = lane_of(0), overlap;
        for (int b = 0; b < k.dim; b++) {
            if (k.b_simplex) {
                high = lane_max(high, s->e[b][i]);
                low = lane_min(low, s->e[b][i]);
            } else {
                high = high + lane_abs(s->e[b][i]);
            }
        }
        if (k.a_simplex)
            overlap = high + s->g[i];
        else if (k.b_simplex)
            overlap = s->a + lane_min(high + s->g[i], -(low + s->g[i]));
        else
            overlap = s->a + high - lane_abs(s->g[i]);
        if (k.moves)
            overlap = overlap + lane_abs(s->v[i]);
        least = i == 0 ? overlap : lane_min(least, overlap);
    }
    return least;
}

/* From 0 how far A reaches, over a, in direction (x[0], x[1], x[2]). */
FMB_INLINE sat_reach sat_reach_of_a(sat_kind k, const lane *x)
{
    if (!k.a_simplex)
        return sat_even(lane_abs(x[0]) + lane_abs(x[1]) + lane_abs(x[2]));
    return sat_join(sat_join(sat_to(x[0]), sat_to(x[1])), sat_to(x[2]));
}

/* The same across an edge (p, q) seen in a plane, on the axis (q, -p). */
FMB_INLINE sat_reach sat_reach_across(sat_kind k, lane p, lane q)
{
    if (!k.a_simplex)
        return sat_even(lane_abs(p) + lane_abs(q));
    return sat_join(sat_to(q), sat_flip(sat_to(p)));
}

#endif
