/* box_still.h: boxes of frames that stand still, in plain doubles: the first try.
 *
 * An edge y + s d of the guest, 0 <= s <= 1, is in the host where 0 <= y_i + s d_i <= size for all
 * values i (box_view.h). With r = 1 / d_i this is s in -y_i r + [min(0, size r), max(0, size r)];
 * the second part and its error are the same for all parallel edges. So each edge and value takes
 * four sums and four comparisons: for an outer version, which certainly contains the exact part,
 * and an inner one, which is certainly contained in it.
 *
 * Errors: with u = 2^-53, N and X as in box_view.h, and
 *
 *     T_i = sum_j N_ij X_j,  P_i = sum_j |n_ij| X_j,  T = sum_j N_0j |a_0j|,  P = sum_j |n_0j
 * a_0j|,
 *
 * n_ij is off by u (N_ij + |n_ij|), as each product and the difference is rounded once. A term of a
 * value is rounded at most four times (x_j, the product, two sums), and a corner, or the direction
 * of an edge of a simplex, takes two sums more: y_i + s d_i is off by u (T_i + 7 P_i), and size by
 * u (T + 4 P). So where y_i + s d_i, or size less it, is not negative,
 *
 *     error_i = u (T_i + 8 P_i + T + 5 P)
 *
 * bounds its error. The value more of a simplex is size less the others in three sums: the sums of
 * T_i and 10 P_i over i, and T + 7 P; one more P of each is for terms of u^2 and the rounding of
 * bounds.
 *
 * |d_i| is taken to be at least 2^-10 wide_i (see below), which changes the value by at most that
 * much. r and y_i r are off by u each, relatively, as are size r; taking the margin from that is
 * off by u (size |r| + margin), the last sum by u (|y_i r| + size |r| + margin). As |y_i| <= P_i,
 * all this is less than wide_i |r| =: margin, wide_i = error_i + u (4 P_i + 4 size): it moves the
 * ends out and in. (3 units of P_i |r| and 4 of size |r|; one is left for the rest.)
 *
 * If outer and inner version are both empty or both not, the edge is settled; otherwise the lane is
 * in doubt. Each outer end is then within `gap`, the largest distance of the versions, of a true
 * vertex; so the box in the world exceeds the exact one by at most the largest gap |edge|.
 *
 * In B's coordinates there are two hulls: of what certainly contains the points, and of what they
 * certainly reach. Edges of B give their parameters, and 0 or 1; 8 u cover the rounding of 1 - s.
 * On edges of A, coordinate j is (y_j + s d_j) / size: as the quotient is within 0 ... 1, it is off
 * by error_j / size for both numbers; and by u (2 P_j + 2 size) / size for rounding. wide_j / size
 * =: blur_j covers all of it; the vertex itself is within gap |d_j| / size.
 */
#ifndef FMB_PAIR_BOX_STILL_H
#define FMB_PAIR_BOX_STILL_H

#include "pair/box_edges.h"

/* Where value i of the host lets parameters be: y turn + lower ... y turn + upper. */
typedef struct still_bounds {
    lane turn, outer[2], inner[2];
} still_bounds;

typedef struct still_hull {
    lane world[2][3], witness[3];
    lane outer[2][3], inner[2][3]; /* of edges of B, in B's coordinates */
    lane guest[2][3];              /* of edges of A there */
    lane_mask at[2][3];            /* some vertex has coordinate j = 0, = 1 */
    lane reach, guest_reach[3];    /* by how much gaps may move ends: in the world, of A's edges */
    lane_mask doubt;
} still_hull;

FMB_INLINE void still_wide(const box_kind *k, int guest, const box_frame *a, const box_frame *b,
                           const box_view *v, lane *wide)
{
    const int d = k->dim;
    const lane u = lane_of(0x1p-53);
    twin n[3][3];
    lane most[3][3], x[3], t = lane_of(0x1p-200), p = t, all_t = t, all_p = t;
    box_adjugate(k, a->axes, n, most); /* the same as in the view: not computed again */
    for (int j = 0; j < d; j++) {
        x[j] = box_extent(k, guest, b, j, b->origin[j] - a->origin[j]);
        t = lane_fma(most[0][j], lane_abs(a->axes[0][j]), t);
        p = lane_fma(lane_abs(n[0][j].hi), lane_abs(a->axes[0][j]), p);
    }
    lane size = lane_fma(lane_of(4), v->size.hi, t);
    for (int i = 0; i < d; i++) {
        lane ti = lane_of(0), pi = ti;
        for (int j = 0; j < d; j++) {
            ti = lane_fma(most[i][j], x[j], ti);
            pi = lane_fma(lane_abs(n[i][j].hi), x[j], pi);
        }
        wide[i] = u * (lane_fma(lane_of(12), pi, ti) + lane_fma(lane_of(5), p, size));
        all_t = all_t + ti;
        all_p = all_p + pi;
    }
    wide[d] = u * (lane_fma(lane_of(15), all_p, all_t) + lane_fma(lane_of(8), p, size));
}

FMB_INLINE void still_bounds_of(const box_kind *k, int host, const box_view *v, lane wide, lane d,
                                still_bounds *b)
{
    const lane zero = lane_of(0), all = lane_of(HUGE_VAL), least = lane_of(0x1p-10) * wide;
    d = lane_pick(lane_less(lane_abs(d), least), lane_times_sign(least, d), d);
    lane r = lane_of(1) / d, margin = wide * lane_abs(r);
    b->turn = -r;
    if (k->shape[host] == FMB_CUBOID) {
        lane across = v->size.hi * r;
        lane lower = lane_min(across, zero), upper = lane_max(across, zero);
        b->outer[0] = lower - margin;
        b->inner[0] = lower + margin;
        b->outer[1] = upper + margin;
        b->inner[1] = upper - margin;
        return;
    }
    lane_mask rises = lane_less(zero, d);
    b->outer[0] = lane_pick(rises, -margin, -all);
    b->inner[0] = lane_pick(rises, margin, -all);
    b->outer[1] = lane_pick(rises, all, margin);
    b->inner[1] = lane_pick(rises, all, -margin);
}

/* What is left of an edge; NaN where there is nothing. */
typedef struct still_part {
    lane outer[2], inner[2];
    lane_mask some;
} still_part;

FMB_INLINE void still_clip(int values, const still_bounds *b, const twin *y, still_part *p,
                           still_hull *h)
{
    const lane none = lane_of(NAN);
    lane lower = lane_of(0), upper = lane_of(1), lower_in = lower, upper_in = upper;
    for (int i = 0; i < values; i++) {
        lower = lane_max(lane_fma(y[i].hi, b[i].turn, b[i].outer[0]), lower);
        upper = lane_min(lane_fma(y[i].hi, b[i].turn, b[i].outer[1]), upper);
        lower_in = lane_max(lane_fma(y[i].hi, b[i].turn, b[i].inner[0]), lower_in);
        upper_in = lane_min(lane_fma(y[i].hi, b[i].turn, b[i].inner[1]), upper_in);
    }
    lane_mask empty = lane_less(upper, lower), hollow = lane_less(upper_in, lower_in);
    h->doubt = lane_or(h->doubt, lane_xor(empty, hollow));
    p->outer[0] = lane_pick(empty, none, lower);
    p->outer[1] = lane_pick(empty, none, upper);
    p->inner[0] = lane_pick(empty, none, lower_in);
    p->inner[1] = lane_pick(empty, none, upper_in);
    p->some = lane_less(lane_of(-1), p->outer[0]);
}

FMB_INLINE void still_cover_world(int dim, const still_part *p, const lane *from, const lane *along,
                                  still_hull *h)
{
    for (int j = 0; j < dim; j++) {
        lane one = lane_fma(p->outer[0], along[j], from[j]);
        lane two = lane_fma(p->outer[1], along[j], from[j]);
        h->world[0][j] = lane_min(two, lane_min(one, h->world[0][j]));
        h->world[1][j] = lane_max(two, lane_max(one, h->world[1][j]));
        h->witness[j] = lane_pick(p->some, one, h->witness[j]);
    }
}

/* A hull's lower (side 0) or upper end takes in x, unless that is NaN. */
FMB_INLINE void still_widen(int side, lane x, lane *end)
{
    *end = side ? lane_max(x, *end) : lane_min(x, *end);
}

/* An edge of B: from + s along in B's coordinates, both whole numbers. */
FMB_INLINE void still_cover_own(int dim, const still_part *p, const int *from, const int *along,
                                still_hull *h)
{
    const lane one = lane_of(1);
    for (int j = 0; j < dim; j++) {
        if (along[j] == 0) {
            h->at[from[j]][j] = lane_or(h->at[from[j]][j], p->some);
            continue;
        }
        for (int side = 0; side < 2; side++) {
            int end = along[j] > 0 ? side : 1 - side;
            lane outer = p->outer[end], inner = p->inner[end];
            if (along[j] < 0) {
                outer = one - outer;
                inner = one - inner;
            }
            still_widen(side, outer, &h->outer[side][j]);
            still_widen(side, inner, &h->inner[side][j]);
        }
    }
}

/* An edge of A: y + s along in B's coordinates. */
FMB_INLINE void still_cover_guest(int dim, const still_part *p, const twin *y, lane rho,
                                  const lane *along, still_hull *h)
{
    for (int j = 0; j < dim; j++) {
        lane from = y[j].hi * rho;
        lane one = lane_fma(p->outer[0], along[j], from);
        lane two = lane_fma(p->outer[1], along[j], from);
        h->guest[0][j] = lane_min(two, lane_min(one, h->guest[0][j]));
        h->guest[1][j] = lane_max(two, lane_max(one, h->guest[1][j]));
    }
}

/* All edges in one direction. */
FMB_INLINE void still_cover_direction(const box_kind *k, int guest, const box_view *v,
                                      const lane *wide, const box_guest *g, int n,
                                      const box_direction *e, lane rho, still_hull *h)
{
    still_bounds b[BOX_VALUES];
    lane along[3], gap = lane_of(0);
    for (int i = 0; i < box_values(k, 1 - guest); i++)
        still_bounds_of(k, 1 - guest, v, wide[i], e->d[i].hi, &b[i]);
    for (int j = 0; j < k->dim; j++)
        along[j] = e->d[j].hi * rho;
    for (int c = 0; c < box_corners(k, guest); c++) {
        still_part p;
        if (!box_starts(k, guest, n, c))
            continue;
        still_clip(box_values(k, 1 - guest), b, g->y[c], &p, h);
        lane below = p.inner[0] - p.outer[0], above = p.outer[1] - p.inner[1];
        gap = lane_max(below, lane_max(above, gap));
        still_cover_world(k->dim, &p, g->world[c], e->world, h);
        if (guest == 1) {
            int own[3];
            box_own_corner(k, guest, c, own);
            still_cover_own(k->dim, &p, own, e->own, h);
        } else {
            still_cover_guest(k->dim, &p, g->y[c], rho, along, h);
        }
    }
    for (int j = 0; j < k->dim; j++) {
        h->reach = lane_max(gap * lane_abs(e->world[j]), h->reach);
        if (guest == 0)
            h->guest_reach[j] = lane_max(gap * lane_abs(along[j]), h->guest_reach[j]);
    }
}

FMB_INLINE void still_hull_empty(still_hull *h)
{
    const lane zero = lane_of(0), most = lane_of(HUGE_VAL);
    const lane_mask no = lane_less(zero, zero);
    h->reach = zero;
    h->doubt = no;
    for (int j = 0; j < 3; j++) {
        h->world[0][j] = h->guest[0][j] = most;
        h->world[1][j] = h->guest[1][j] = -most;
        h->outer[0][j] = h->inner[0][j] = lane_of(1); /* every common point is within 0 ... 1 */
        h->outer[1][j] = h->inner[1][j] = h->guest_reach[j] = h->witness[j] = zero;
        h->at[0][j] = h->at[1][j] = no;
    }
}

/* Ends of coordinate j in B; returns by how much they may exceed the exact ones. */
FMB_INLINE lane still_inside(still_hull *h, int j, lane blur)
{
    const lane zero = lane_of(0), one = lane_of(1), round = lane_of(8 * 0x1p-53);
    lane far = blur + h->guest_reach[j];
    lane lower = lane_min(h->outer[0][j], h->guest[0][j] - blur) - round;
    lane upper = lane_max(h->outer[1][j], h->guest[1][j] + blur) + round;
    lane lower_in = lane_min(h->inner[0][j], h->guest[0][j] + far) + round;
    lane upper_in = lane_max(h->inner[1][j], h->guest[1][j] - far) - round;
    lower = lane_pick(h->at[0][j], zero, lane_max(lower, zero));
    upper = lane_pick(h->at[1][j], one, lane_min(upper, one));
    lower_in = lane_pick(h->at[0][j], zero, lane_max(lower_in, zero));
    upper_in = lane_pick(h->at[1][j], one, lane_min(upper_in, one));
    h->outer[0][j] = lane_min(lower, one);
    h->outer[1][j] = lane_max(upper, zero);
    return lane_max(lower_in - h->outer[0][j], h->outer[1][j] - upper_in);
}

#endif
