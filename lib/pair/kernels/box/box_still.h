/* box_still.h: the box of the common points of two frames that stand still.
 *
 * All edges of each frame are clipped against the other (box_kernel.h shows that this suffices), in
 * plain doubles. Lanes where these are not accurate enough are left to box_kernel.h.
 *
 * Ends in the world are computed from the origin of A, with at most 12 roundings, each of a number
 * at most
 *
 *     far = 3 (largest origin) + (largest sum of absolute axes, of A) + (of B),
 *
 * so all are moved out by 16 u far. With M the largest coordinate of a corner, such a sum is at
 * most 6 M: far <= 15 M, and ends exceed the exact ones by at most 480 u M for this, and 9.4e-13 M
 * for the gap of edges (box_still_gap.h).
 */
#ifndef FMB_PAIR_BOX_STILL_H
#define FMB_PAIR_BOX_STILL_H

#include "pair/kernels/box/box_still_gap.h"

typedef struct still_pair {
    still_frame frame[2];    /* A, B */
    lane place[3], shift[3]; /* the origin of A; the vector from there to that of B */
    lane far, most;          /* most: M, up to rounding */
    lane limit;              /* still_limits.world */
    lane_mask known;         /* numbers have sizes for which all error bounds hold */
} still_pair;

/* ---- the numbers ----------------------------------------------------------------------------- */

/* Returns the largest coordinate of a corner, up to rounding. */
FMB_BOX_INLINE lane still_frame_of(const box_kind *k, int which, const double *axes,
                                   const lane *place, still_frame *f)
{
    const lane half = lane_of(0.5);
    const bool simplex = k->shape[which] == FMB_SIMPLEX;
    lane most = lane_of(0);
    FMB_UNROLL
    for (int j = 0; j < k->dim; j++) {
        lane at = place[j] + f->origin[j], sum = lane_load(axes + j * FMB_LANES);
        f->axes[0][j] = sum;
        f->extent[j] = lane_abs(sum);
        most = lane_max_abs(most, at);
        if (simplex)
            most = lane_max_abs(most, at + sum);
        FMB_UNROLL
        for (int l = 1; l < k->dim; l++) {
            f->axes[l][j] = lane_load(axes + (l * k->dim + j) * FMB_LANES);
            f->extent[j] = f->extent[j] + lane_abs(f->axes[l][j]);
            sum = sum + f->axes[l][j];
            if (simplex)
                most = lane_max_abs(most, at + f->axes[l][j]);
        }
        lane centre = lane_fma(half, sum, at);
        if (!simplex)
            most = lane_max(most, lane_fma(half, f->extent[j], lane_abs(centre)));
    }
    return most;
}

/* A block has a cuboid before a simplex. */
FMB_BOX_INLINE void still_pair_of(const box_kind *k, const double *block, still_pair *p)
{
    const int d = k->dim, swapped = k->shape[0] == FMB_SIMPLEX && k->shape[1] == FMB_CUBOID;
    const double *axes = block + d * FMB_LANES, *places = axes + 2 * d * d * FMB_LANES;
    lane largest = lane_of(0), reach[2];
    FMB_UNROLL
    for (int j = 0; j < d; j++) {
        lane first = lane_load(places + j * FMB_LANES);
        lane second = lane_load(places + (d + j) * FMB_LANES);
        lane shift = swapped ? first - second : second - first;
        largest = lane_max_abs(lane_max_abs(largest, first), second);
        p->place[j] = swapped ? second : first;
        p->shift[j] = p->frame[1].origin[j] = shift;
        p->frame[0].origin[j] = lane_of(0);
    }
    p->most = lane_of(0);
    for (int f = 0; f < 2; f++) {
        const double *own = axes + (f ^ swapped) * d * d * FMB_LANES;
        lane most = still_frame_of(k, f, own, p->place, &p->frame[f]);
        reach[f] = still_most(d, p->frame[f].extent);
        p->most = lane_max(p->most, most);
    }
    p->limit = lane_of(1) / (lane_of(9.4e-13) * p->most);
    p->far = lane_fma(lane_of(3), largest, reach[0] + reach[1]);
    p->known = lane_and(lane_less(lane_of(0x1p-38), lane_min(reach[0], reach[1])),
                        lane_less(p->far, lane_of(0x1p40)));
}

/* ---- edges ----------------------------------------------------------------------------------- */

FMB_BOX_INLINE void still_cover_cuboid(const box_kind *k, bool own, const still_view *v,
                                       const still_frame *f, const still_limits *limit,
                                       still_hull *h)
{
    const int dim = k->dim, corners = 1 << (dim - 1);
    FMB_UNROLL
    for (int n = 0; n < dim; n++) {
        lane y[4][BOX_VALUES];
        still_direction e;
        still_slabs b = {.r = {lane_of(0)}};
        still_part p[4];
        still_direction_of(k, v, f, n, -1, &e);
        still_slabs_of(k, v, e.d, &b);
        FMB_UNROLL
        for (int c = 0; c < corners; c++) {
            /* one step on from the corner before, or from corner 0 */
            const int axis = (n + (c == 2 ? 2 : 1)) % dim, before = c % 2;
            FMB_UNROLL
            for (int i = 0; i < box_values(k, STILL_HOST); i++) {
                y[c][i] = before ? y[c - 1][i] : v->start[i];
                if (c > 0)
                    y[c][i] = y[c][i] + v->edge[axis][i];
            }
            p[c] = still_clip_segment(k, &b, y[c]);
        }
        still_measure(k, own, v, &e, &b, corners, y, limit, h);
        still_cover_parts(k, &e, corners, p, f->origin, f->axes[(n + 1) % dim],
                          f->axes[(n + 2) % dim], h);
        if (own)
            still_cover_own_cuboid(dim, n, p, h);
        else
            still_cover_values(k, &e, corners, p, y, h);
    }
}

FMB_BOX_INLINE void still_cover_simplex(const box_kind *k, bool own, const still_view *v,
                                        const still_frame *f, const still_limits *limit,
                                        still_hull *h)
{
    FMB_UNROLL
    for (int n = 0; n < box_directions(k, STILL_GUEST); n++) {
        const int back = box_simplex_from(n) - 1, ahead = box_simplex_to(n) - 1;
        lane y[1][BOX_VALUES], from[3];
        still_direction e;
        still_slabs b = {.r = {lane_of(0)}};
        still_direction_of(k, v, f, ahead, back, &e);
        still_slabs_of(k, v, e.d, &b);
        FMB_UNROLL
        for (int i = 0; i < box_values(k, STILL_HOST); i++) {
            y[0][i] = v->start[i];
            if (back >= 0)
                y[0][i] = y[0][i] + v->edge[back][i];
        }
        FMB_UNROLL
        for (int j = 0; j < k->dim; j++) {
            from[j] = f->origin[j];
            if (back >= 0)
                from[j] = from[j] + f->axes[back][j];
        }
        still_part p = still_clip_segment(k, &b, y[0]);
        still_cover_parts(k, &e, 1, &p, from, NULL, NULL, h);
        if (own)
            still_cover_own_simplex(k->dim, ahead, back, &p, h);
        else
            still_cover_values(k, &e, 1, &p, y, h);
        still_measure(k, own, v, &e, &b, 1, y, limit, h);
    }
}

/* ---- the box --------------------------------------------------------------------------------- */

/* The ends of coordinate j in B, the host of view v. */
FMB_BOX_INLINE void still_inside(const box_kind *k, const still_view *v, lane rho, int j,
                                 still_hull *h)
{
    const lane zero = lane_of(0), one = lane_of(1), round = lane_of(8 * 0x1p-53);
    lane origin = k->shape[STILL_HOST] == FMB_SIMPLEX ? v->wide[j] : -v->half;
    lane lower = lane_min((h->guest[0][j] - (origin + v->wide[j])) * rho, h->own[0][j]) - round;
    lane upper = lane_max((h->guest[1][j] - (origin - v->wide[j])) * rho, h->own[1][j]) + round;
    lower = lane_min(lane_max(lower, zero), one);
    upper = lane_max(lane_min(upper, one), zero);
    h->own[0][j] = lane_pick(h->at[0][j], zero, lower);
    h->own[1][j] = lane_pick(h->at[1][j], one, upper);
}

FMB_BOX_INLINE void still_store(const box_kind *k, const still_pair *p, const still_hull *h,
                                double *answer)
{
    const int d = k->dim;
    const lane out = lane_of(16 * 0x1p-53) * p->far;
    FMB_UNROLL
    for (int j = 0; j < d; j++) {
        lane_store(answer + j * FMB_LANES, (h->world[0][j] - out) + p->place[j]);
        lane_store(answer + (d + j) * FMB_LANES, (h->world[1][j] + out) + p->place[j]);
        lane_store(answer + (2 * d + j) * FMB_LANES, h->own[0][j]);
        lane_store(answer + (3 * d + j) * FMB_LANES, h->own[1][j]);
        lane_store(answer + (4 * d + 2 + j) * FMB_LANES, h->witness[j] + p->place[j]);
    }
    lane_store(answer + 4 * d * FMB_LANES, lane_of(0));
    lane_store(answer + (4 * d + 1) * FMB_LANES, lane_of(1));
}

/* One frame, the guest, in the other; own: it is B. Returns the lanes where its edges are known.
 * Shapes are constants: kind is that of a host and its guest. */
FMB_BOX_INLINE lane_mask still_side(const box_kind *k, bool own, const still_pair *p, still_hull *h)
{
    const lane one = lane_of(1), zero = lane_of(0);
    const still_frame *guest = &p->frame[own], *host = &p->frame[!own];
    lane shift[3];
    still_view v;
    still_limits limit;
    FMB_UNROLL
    for (int j = 0; j < k->dim; j++)
        shift[j] = own ? p->shift[j] : -p->shift[j];
    still_view_of(k, host, guest, shift, &v);
    limit.world = limit.guest = p->limit;
    lane left = one, rho = one;
    if (!own) {
        left = lane_fma(lane_of(9.9e-13), v.size, lane_of(-2) * still_most(k->dim, v.wide));
        rho = one / v.size;
        limit.guest = one / left;
    }
    if (k->shape[STILL_GUEST] == FMB_SIMPLEX)
        still_cover_simplex(k, own, &v, guest, &limit, h);
    else
        still_cover_cuboid(k, own, &v, guest, &limit, h);
    if (own)
        return v.known;
    FMB_UNROLL
    for (int j = 0; j < k->dim; j++)
        still_inside(k, &v, rho, j, h);
    return lane_and(v.known, lane_less(zero, left));
}

/* Not inlined: each serves the guest of two kinds of pairs, for either of A and B. */
#define STILL_SIDE(name, host, guest)                                                              \
    static FMB_NEVER_CLONED lane_mask name(bool own, const still_pair *__restrict p,               \
                                           still_hull *__restrict h)                               \
    {                                                                                              \
        const box_kind k = {3, false, false, {host, guest}};                                       \
        return still_side(&k, own, p, h);                                                          \
    }
STILL_SIDE(still_side_cc, FMB_CUBOID, FMB_CUBOID)
STILL_SIDE(still_side_ct, FMB_CUBOID, FMB_SIMPLEX)
STILL_SIDE(still_side_tc, FMB_SIMPLEX, FMB_CUBOID)
STILL_SIDE(still_side_tt, FMB_SIMPLEX, FMB_SIMPLEX)

typedef lane_mask still_sider(bool own, const still_pair *__restrict p, still_hull *__restrict h);
static still_sider *const STILL_SIDERS[2][2] = {{still_side_cc, still_side_ct},
                                                {still_side_tc, still_side_tt}};

/* Are sides in functions of their own? In space, where numbers do not stay in registers anyway,
 * that is half of the code and no slower; with eight lanes it takes 1.04 to 1.08 of the time. */
#define STILL_APART(dim) ((dim) == 3 && FMB_LANES < 8)

/* dim is a constant and, unless STILL_APART, so are the shapes a and b. */
FMB_BOX_INLINE unsigned still_kernel(int dim, int a, int b, const double *block, double *answer)
{
    const box_kind kind = {dim, false, false, {a, b}}, swapped = {dim, false, false, {b, a}};
    still_pair p;
    still_hull h;
    still_pair_of(&kind, block, &p);
    still_hull_empty(&h);
    lane_mask known = lane_and(p.known, STILL_APART(dim) ? STILL_SIDERS[a][b](true, &p, &h)
                                                         : still_side(&kind, true, &p, &h));
    known = lane_and(known, STILL_APART(dim) ? STILL_SIDERS[b][a](false, &p, &h)
                                             : still_side(&swapped, false, &p, &h));
    still_store(&kind, &p, &h, answer);
    lane_mask long_ones = lane_less(lane_of(0x1p-36), h.shortest);
    lane_mask some = lane_less(h.world[0][0], lane_of(HUGE_VAL));
    lane_mask near = lane_less(h.excess, lane_of(1));
    return lane_bits(lane_and(lane_and(known, near), lane_and(some, long_ones)));
}

#endif
