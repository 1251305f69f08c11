/* box_still_edges.h: the parts of edges inside the other frame, for frames that do not move, and
 * the hull of these parts.
 *
 * An edge y + s d of the guest, 0 <= s <= 1, is in a cuboid host where |y_i + s d_i| <= half for
 * all i, that is, with r_i = 1 / d_i, where s is within half |r_i| of -y_i r_i; in a simplex where
 * all y_i + s d_i >= 0, that is, s >= -y_i r_i if d_i > 0, else s <= -y_i r_i (box_still_view.h).
 * The total error of the numbers is at most wide_i, so bounds widened by wide_i contain the exact
 * part of the edge: ends move out by margin_i = wide_i |r_i|. wide_i also covers the rounding of an
 * end, and the effect of taking |d_i| to be at least 2^-10 wide_i: docs/error-bounds.md, "Still
 * view".
 */
#ifndef FMB_PAIR_BOX_STILL_EDGES_H
#define FMB_PAIR_BOX_STILL_EDGES_H

#include "pair/kernels/box/box_edges.h"
#include "pair/kernels/box/box_still_view.h"

/* A direction of edges of the guest. */
typedef struct still_direction {
    lane d[BOX_VALUES];
    lane along[3], far[3]; /* half of the edge in the world, and of its absolute value */
} still_direction;

/* The intervals of parameters of edges in one direction. */
typedef struct still_slabs {
    lane r[BOX_VALUES], room[BOX_VALUES], margin[BOX_VALUES];
    lane_mask falls[BOX_VALUES]; /* d_i < 0; unused for a cuboid, as room is for a simplex */
} still_slabs;

typedef struct still_part {
    lane lower, upper;
    lane length, sum; /* of the ends; the sum is NaN if the part is empty */
    lane_mask some;   /* it is not empty */
} still_part;

typedef struct still_hull {
    lane world[2][3], witness[3];
    lane own[2][3];     /* of edges of B, in its coordinates */
    lane guest[2][3];   /* of edges of A there: as y */
    lane_mask at[2][3]; /* some vertex has coordinate j = 0, = 1 */
    lane shortest;      /* the least absolute length of a part */
    lane excess;        /* box_still_gap.h */
} still_hull;

/* Along axis `ahead`; of a simplex from the end of axis `back`, if that is not -1. */
FMB_BOX_INLINE void still_direction_of(const box_kind *k, const still_view *v, const still_frame *f,
                                       int ahead, int back, still_direction *e)
{
    FMB_UNROLL
    for (int i = 0; i < box_values(k, STILL_HOST); i++) {
        e->d[i] = v->edge[ahead][i];
        if (back >= 0)
            e->d[i] = e->d[i] - v->edge[back][i];
    }
    FMB_UNROLL
    for (int j = 0; j < k->dim; j++) {
        lane edge = f->axes[ahead][j];
        if (back >= 0)
            edge = edge - f->axes[back][j];
        e->along[j] = lane_of(0.5) * edge;
        e->far[j] = lane_abs(e->along[j]);
    }
}

FMB_BOX_INLINE void still_slabs_of(const box_kind *k, const still_view *v, const lane *d,
                                   still_slabs *b)
{
    FMB_UNROLL
    for (int i = 0; i < box_values(k, STILL_HOST); i++) {
        lane inverse = lane_of(1) / lane_max_abs(lane_of(0x1p-10) * v->wide[i], d[i]);
        b->margin[i] = v->wide[i] * inverse;
        b->r[i] = lane_times_sign(inverse, d[i]);
        b->falls[i] = lane_negative(d[i]);
        b->room[i] = (v->half + v->wide[i]) * inverse;
    }
}

/* Clip the parameters of an edge by value i of the host. */
FMB_BOX_INLINE void still_cut_segment(const box_kind *k, const still_slabs *b, int i, lane y,
                                      still_part *p)
{
    const bool simplex = k->shape[STILL_HOST] == FMB_SIMPLEX;
    lane lower = lane_fnma(y, b->r[i], lane_of(0)), upper = lower;
    if (!simplex) {
        lower = lane_fnms(y, b->r[i], b->room[i]);
        upper = lane_fnma(y, b->r[i], b->room[i]);
    }
    lower = lane_max(lower, p->lower);
    upper = lane_min(upper, p->upper);
    p->lower = simplex ? lane_pick(b->falls[i], p->lower, lower) : lower;
    p->upper = simplex ? lane_pick(b->falls[i], upper, p->upper) : upper;
}

FMB_BOX_INLINE still_part still_clip_segment(const box_kind *k, const still_slabs *b, const lane *y)
{
    still_part p = {.lower = lane_of(0), .upper = lane_of(1)};
    FMB_UNROLL
    for (int i = 0; i < box_values(k, STILL_HOST); i++)
        still_cut_segment(k, b, i, y[i], &p);
    p.length = p.upper - p.lower;
    p.some = lane_less(lane_of(0), p.length);
    p.sum = lane_pick(p.some, p.upper + p.lower, lane_of(NAN));
    return p;
}

FMB_BOX_INLINE void still_hull_empty(still_hull *h)
{
    const lane zero = lane_of(0), most = lane_of(HUGE_VAL);
    const lane_mask no = lane_less(zero, zero);
    h->shortest = most;
    h->excess = zero;
    for (int j = 0; j < 3; j++) {
        h->world[0][j] = h->guest[0][j] = most;
        h->world[1][j] = h->guest[1][j] = -most;
        h->own[0][j] = lane_of(1); /* every common point is within 0 ... 1 */
        h->own[1][j] = h->witness[j] = zero;
        h->at[0][j] = h->at[1][j] = no;
    }
}

/* The points from + s along of a part, given half of along and of its absolute value. Returns the
 * one in the middle. */
FMB_BOX_INLINE lane still_cover(const still_part *p, lane from, lane along, lane far, lane *lower,
                                lane *upper)
{
    lane middle = lane_fma(p->sum, along, from);
    *lower = lane_min(lane_fnma(p->length, far, middle), *lower);
    *upper = lane_max(lane_fma(p->length, far, middle), *upper);
    return middle;
}

/* Parts of edges in one direction, from corners: the first is at that place, further ones are steps
 * from there on, one if bit 0 of their number is set, two if bit 1. One coordinate after the other,
 * as there are not enough registers for all. */
FMB_BOX_INLINE void still_cover_parts(const box_kind *k, const still_direction *e, int corners,
                                      const still_part *p, const lane *first, const lane *one,
                                      const lane *two, still_hull *h)
{
    FMB_UNROLL
    for (int c = 0; c < corners; c++)
        h->shortest = lane_min_abs(h->shortest, p[c].length);
    FMB_UNROLL
    for (int j = 0; j < k->dim; j++) {
        FMB_UNROLL
        for (int c = 0; c < corners; c++) {
            lane from = first[j];
            if (c & 2)
                from = from + two[j];
            if (c & 1)
                from = from + one[j];
            lane middle =
                still_cover(&p[c], from, e->along[j], e->far[j], &h->world[0][j], &h->world[1][j]);
            h->witness[j] = lane_pick(p[c].some, middle, h->witness[j]);
        }
    }
}

/* Parts of edges of A, from corners with values y in B. */
FMB_BOX_INLINE void still_cover_values(const box_kind *k, const still_direction *e, int corners,
                                       const still_part *p, lane y[][BOX_VALUES], still_hull *h)
{
    FMB_UNROLL
    for (int j = 0; j < k->dim; j++) {
        lane along = lane_of(0.5) * e->d[j], far = lane_abs(along);
        FMB_UNROLL
        for (int c = 0; c < corners; c++)
            still_cover(&p[c], y[c][j], along, far, &h->guest[0][j], &h->guest[1][j]);
    }
}

/* Edges of B along axis n, in its coordinates: the part p[c] starts one step along the next axis if
 * bit 0 of c is set, one along the one after it if bit 1. */
FMB_BOX_INLINE void still_cover_own_cuboid(int dim, int n, const still_part p[4], still_hull *h)
{
    const lane none = lane_of(NAN);
    lane lower = lane_of(1), upper = lane_of(0);
    FMB_UNROLL
    for (int c = 0; c < 1 << (dim - 1); c++) {
        lower = lane_min(lane_pick(p[c].some, p[c].lower, none), lower);
        upper = lane_max(lane_pick(p[c].some, p[c].upper, none), upper);
    }
    FMB_UNROLL
    for (int l = 1; l < dim; l++) {
        FMB_UNROLL
        for (int side = 0; side < 2; side++) {
            const int c = side << (l - 1), next = dim == 3 ? c ^ (3 - l) : c;
            lane_mask *at = &h->at[side][(n + l) % dim];
            *at = lane_or(*at, lane_or(p[c].some, p[next].some));
        }
    }
    h->own[0][n] = lower;
    h->own[1][n] = upper;
}

/* The edge of B from the end of axis `back` (-1: from the origin) to that of `ahead`. */
FMB_BOX_INLINE void still_cover_own_simplex(int dim, int ahead, int back, const still_part *p,
                                            still_hull *h)
{
    const lane none = lane_of(NAN), one = lane_of(1);
    lane lower = lane_pick(p->some, p->lower, none), upper = lane_pick(p->some, p->upper, none);
    FMB_UNROLL
    for (int j = 0; j < dim; j++) {
        if (j == ahead) {
            h->own[0][j] = lane_min(lower, h->own[0][j]);
            h->own[1][j] = lane_max(upper, h->own[1][j]);
        } else if (j == back) {
            h->own[0][j] = lane_min(one - upper, h->own[0][j]);
            h->own[1][j] = lane_max(one - lower, h->own[1][j]);
        } else {
            h->at[0][j] = lane_or(h->at[0][j], p->some);
        }
    }
}

#endif
