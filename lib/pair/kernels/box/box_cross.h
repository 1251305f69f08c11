/* box_cross.h: vertices of the common points in space and time where an edge of A meets an edge of
 * B on its way.
 *
 * A is the host. On an edge of A two values are fixed, y_i and y_j (at 0 or size; at 0 for a
 * simplex), and another one, y_k, is within 0 ... size. With m = fixed value - value of the corner
 * where the edge of B starts, d its direction and f the drift,
 *
 *     d_i u + f_i t = m_i,  d_j u + f_j t = m_j:   u = U / det, t = T / det,
 *     det = d_i f_j - d_j f_i,  U = m_i f_j - m_j f_i,  T = d_i m_j - d_j m_i,
 *
 * and they meet iff 0 <= U, T <= det and 0 <= W <= size det, W = y_k det + U d_k + T f_k (after all
 * four took the sign of det). If det is 0 the two sweep in one plane, and no vertex is made by
 * these two alone.
 *
 * Errors, whatever the sign of det: docs/error-bounds.md, "Contacts".
 */
#ifndef FMB_PAIR_BOX_CROSS_H
#define FMB_PAIR_BOX_CROSS_H

#include "pair/kernels/box/box_edges.h"

/* The numbers shared by all parallel edges. */
typedef struct box_cross {
    int i, j, k;                  /* values: two fixed, one along the edge of A */
    lane2 det;                    /* as computed; then its absolute value */
    lane2 whole;                  /* size |det| */
    lane r, far_plane, far_along; /* 1 / |det|; the bounds beyond which a number tells */
    lane margin;
} box_cross;

FMB_BOX_INLINE lane2 box_det(const box_kind *k, lane2 a, lane2 b, lane2 c, lane2 d)
{
    return lane2_subtract(k->fine, lane2_times(k->fine, a, d), lane2_times(k->fine, b, c));
}

FMB_BOX_INLINE box_cross box_cross_of(const box_kind *k, const box_view *v, const lane2 *d, int i,
                                      int j, int along)
{
    box_cross x = {.i = i, .j = j, .k = along};
    const lane unit = lane_of(LANE2_UNIT(k->fine)), most = v->most[i] * v->most[j];
    x.det = box_det(k, d[i], d[j], v->drift[i], v->drift[j]);
    x.r = lane_of(1) / lane_max(lane_abs(x.det.hi), unit * most);
    x.whole = lane2_times(k->fine, v->size, lane2_times_sign(k->fine, x.det, x.det.hi));
    x.far_plane = lane_of(126) * unit * most;
    x.far_along = lane_of(400) * unit * most * v->most[along];
    x.margin = lane_of(121) * unit * most * x.r + lane_of(16) * unit;
    return x;
}

/* The smaller of x and most - x. */
FMB_BOX_INLINE lane box_room(const box_kind *k, lane2 x, lane2 most)
{
    return lane_min(x.hi, lane2_subtract(k->fine, most, x).hi);
}

typedef struct box_contact {
    lane u, t; /* NaN where there is none */
    lane gap;
} box_contact;

FMB_BOX_INLINE box_contact box_contact_of(const box_kind *k, const box_view *v, const box_cross *x,
                                          const lane2 *d, const lane2 *y, lane2 mi, lane2 mj)
{
    const lane zero = lane_of(0), none = lane_of(NAN), s = x->det.hi;
    const lane2 *f = v->drift, det = lane2_times_sign(k->fine, x->det, s);
    lane2 u = lane2_times_sign(k->fine, box_det(k, mi, mj, f[x->i], f[x->j]), s);
    lane2 t = lane2_times_sign(k->fine, box_det(k, d[x->i], d[x->j], mi, mj), s);
    lane2 w =
        lane2_add(k->fine, lane2_times(k->fine, u, d[x->k]), lane2_times(k->fine, t, f[x->k]));
    w = lane2_add(k->fine, w, lane2_times(k->fine, y[x->k], det));
    lane plane = lane_min(box_room(k, u, det), box_room(k, t, det));
    lane along = box_room(k, w, x->whole);
    lane_mask out = lane_or(lane_less(plane, -x->far_plane), lane_less(along, -x->far_along));
    lane_mask in = lane_and(lane_less(x->far_plane, plane), lane_less(x->far_along, along));
    box_contact c = {lane_pick(out, none, lane2_over(k->fine, u, det, x->r).hi),
                     lane_pick(out, none, lane2_over(k->fine, t, det, x->r).hi), zero};
    c.gap = lane_pick(in, x->margin + x->margin, lane_of(HUGE_VAL));
    c.gap = lane_pick(out, zero, c.gap);
    return c;
}

FMB_BOX_INLINE void box_cover_contact(const box_kind *k, const box_contact *x, const box_cross *of,
                                      const box_frame *b, const box_guest *g, int c,
                                      const box_direction *e, box_hull *h)
{
    lane at[3], lo = x->u - of->margin, hi = x->u + of->margin;
    int own[3];
    box_own_corner(k, 1, c, own);
    box_cover_own(k, h, own, e->own, lo, hi);
    box_cover(x->t - of->margin, &h->time[0], &h->time[1]);
    box_cover(x->t + of->margin, &h->time[0], &h->time[1]);
    for (int j = 0; j < k->dim; j++)
        at[j] = lane_fma(x->t, b->speed[j], g->world[c][j]);
    box_cover_world(k, h, at, e->world, x->u, of->margin);
    for (int j = 0; j < k->dim; j++) { /* t is off as well */
        lane off = of->margin * b->speed[j], *lower = &h->world[0][j], *upper = &h->world[1][j];
        box_cover_span(at[j] - off, e->world[j], x->u, of->margin, lower, upper);
        box_cover_span(at[j] + off, e->world[j], x->u, of->margin, lower, upper);
    }
    h->gap = lane_max(h->gap, x->gap + x->gap);
    h->inside_gap = lane_max(h->inside_gap, x->gap);
}

/* One direction of edges of A against one direction of edges of B. Nearly all pairs of edges miss
 * each other, which plain doubles prove first. */
FMB_BOX_INLINE void box_cover_cross(const box_kind *k, const box_view *v, const box_frame *b,
                                    const box_guest *g, int n, const box_direction *e,
                                    const int fixed[3], box_hull *h)
{
    const box_kind plain = box_in_precision(k, false);
    const box_cross x = box_cross_of(k, v, e->d, fixed[0], fixed[1], fixed[2]);
    const box_cross rough = box_cross_of(&plain, v, e->d, fixed[0], fixed[1], fixed[2]);
    int sides = k->shape[0] == FMB_SIMPLEX ? 1 : 4;
    for (int c = 0; c < box_corners(k, 1); c++) {
        if (!box_starts(k, 1, n, c))
            continue;
        for (int side = 0; side < sides; side++) {
            const lane2 *y = g->y[c];
            lane2 mi = lane2_minus(y[x.i]), mj = lane2_minus(y[x.j]);
            if (side & 1)
                mi = lane2_subtract(k->fine, v->size, y[x.i]);
            if (side & 2)
                mj = lane2_subtract(k->fine, v->size, y[x.j]);
            if (box_is_nowhere(box_contact_of(&plain, v, &rough, e->d, y, mi, mj).u))
                continue;
            box_contact at = box_contact_of(k, v, &x, e->d, y, mi, mj);
            box_cover_contact(k, &at, &x, b, g, c, e, h);
        }
    }
}

/* All pairs of edges, in double-doubles; g holds the corners of B at t = 0. Not inlined: shared by
 * lines of either precision. */
static FMB_NEVER_CLONED void box_cover_contacts(int a, int b, const box_view *v,
                                                const box_frame *guest, const box_guest *g,
                                                box_hull *h)
{
    static const int fixed[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 2, 0},
                                    {0, 3, 1}, {1, 3, 0}, {2, 3, 0}};
    const box_kind kind = {3, true, true, {a, b}}, *k = &kind;
    for (int n = 0; n < box_directions(k, 1); n++) {
        box_direction e;
        box_direction_of(k, 1, v, guest, n, &e);
        for (int m = 0; m < box_directions(k, 0); m++)
            box_cover_cross(k, v, guest, g, n, &e, fixed[m], h);
    }
}

#endif
