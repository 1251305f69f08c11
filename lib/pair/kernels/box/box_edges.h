/* box_edges.h: vertices of the common points that lie on an edge of one frame, or on the path of
 * one of its corners.
 */
#ifndef FMB_PAIR_BOX_EDGES_H
#define FMB_PAIR_BOX_EDGES_H

#include "pair/kernels/box/box_cyrus_beck.h"

/* The guest's corners at one time: values in the host, and world coordinates. */
typedef struct box_guest {
    lane2 y[BOX_CORNERS][BOX_VALUES];
    lane world[BOX_CORNERS][3];
} box_guest;

/* A direction of edges. */
typedef struct box_direction {
    int own[3]; /* in the guest's coordinates */
    lane2 d[BOX_VALUES];
    lane world[3];
} box_direction;

FMB_BOX_INLINE void box_guest_of(const box_kind *k, int guest, const box_view *v,
                                 const box_frame *f, box_guest *g)
{
    for (int c = 0; c < box_corners(k, guest); c++) {
        int own[3];
        box_own_corner(k, guest, c, own);
        box_corner(k, 1 - guest, v, c, g->y[c]);
        for (int j = 0; j < k->dim; j++) {
            g->world[c][j] = f->origin[j];
            for (int l = 0; l < k->dim; l++)
                if (own[l])
                    g->world[c][j] = g->world[c][j] + f->axes[l][j];
        }
    }
}

/* Move the corners from t = 0 to t = 1. */
FMB_BOX_INLINE void box_guest_move(const box_kind *k, int guest, const box_view *v,
                                   const box_frame *f, box_guest *g)
{
    for (int c = 0; c < box_corners(k, guest); c++) {
        for (int i = 0; i < box_values(k, 1 - guest); i++)
            g->y[c][i] = lane2_add(true, g->y[c][i], v->drift[i]);
        for (int j = 0; j < k->dim; j++)
            g->world[c][j] = g->world[c][j] + f->speed[j];
    }
}

FMB_BOX_INLINE int box_directions(const box_kind *k, int guest)
{
    return k->shape[guest] == FMB_SIMPLEX ? k->dim * (k->dim + 1) / 2 : k->dim;
}

/* Direction n of a simplex is from corner `from` to corner `to`, 0 <= from < to,
 * n = to (to - 1) / 2 + from. */
FMB_BOX_INLINE int box_simplex_from(int n)
{
    return n < 1 ? 0 : n < 3 ? n - 1 : n - 3;
}

FMB_BOX_INLINE int box_simplex_to(int n)
{
    return n < 1 ? 1 : n < 3 ? 2 : 3;
}

/* Does an edge in direction n start at corner c? */
FMB_BOX_INLINE bool box_starts(const box_kind *k, int guest, int n, int c)
{
    return k->shape[guest] == FMB_SIMPLEX ? c == box_simplex_from(n) : !(c >> n & 1);
}

FMB_BOX_INLINE void box_direction_of(const box_kind *k, int guest, const box_view *v,
                                     const box_frame *f, int n, box_direction *e)
{
    bool simplex = k->shape[guest] == FMB_SIMPLEX;
    int ahead = simplex ? box_simplex_to(n) - 1 : n;
    int back = simplex ? box_simplex_from(n) - 1 : -1; /* -1: the origin */
    for (int l = 0; l < k->dim; l++)
        e->own[l] = (l == ahead) - (l == back);
    for (int i = 0; i < box_values(k, 1 - guest); i++)
        e->d[i] = back < 0 ? v->edge[ahead][i]
                           : lane2_subtract(true, v->edge[ahead][i], v->edge[back][i]);
    for (int j = 0; j < k->dim; j++) {
        e->world[j] = f->axes[ahead][j];
        if (back >= 0)
            e->world[j] = e->world[j] - f->axes[back][j];
    }
}

/* Coordinates in B, the host, of y + s d. */
FMB_BOX_INLINE void box_cover_host(const box_kind *k, box_hull *h, const lane2 *y, const lane2 *d,
                                   lane rho, const box_part *p)
{
    for (int j = 0; j < k->dim; j++) {
        lane along = d[j].hi * rho, *lower = &h->inside[0][j], *upper = &h->inside[1][j];
        h->inside_gap = lane_max(h->inside_gap, p->gap * lane_abs(along));
        if (!k->fine) {
            box_cover_span(y[j].hi * rho, along, p->middle, p->half, lower, upper);
            continue;
        }
        for (int side = 0; side < 2; side++) {
            lane2 s = side ? p->hi : p->lo;
            lane2 x = lane2_add(k->fine, y[j], lane2_times(k->fine, s, d[j]));
            box_cover(x.hi * rho, lower, upper);
        }
    }
}

/* Cover the part of the line from corner c that is in the host. */
FMB_BOX_INLINE box_part box_cover_line(const box_kind *k, int guest, const box_view *v,
                                       const box_line *l, const box_guest *g, int c,
                                       const box_direction *e, lane rho, box_hull *h)
{
    box_part p = box_clip_segment(k, 1 - guest, v, l, g->y[c]);
    h->gap = lane_max(h->gap, p.gap);
    box_cover_world(k, h, g->world[c], e->world, p.middle, p.half);
    if (guest == 1) {
        int own[3];
        box_own_corner(k, guest, c, own);
        box_cover_own(k, h, own, e->own, p.lo.hi, p.hi.hi);
        h->inside_gap = lane_max(h->inside_gap, p.gap);
    } else {
        box_cover_host(k, h, g->y[c], e->d, rho, &p);
    }
    return p;
}

/* All edges, at time t. */
FMB_BOX_INLINE void box_cover_edges(const box_kind *k, int guest, const box_view *v,
                                    const box_frame *f, const box_guest *g, double t, lane rho,
                                    box_hull *h)
{
    for (int n = 0; n < box_directions(k, guest); n++) {
        box_direction e;
        box_line l;
        box_direction_of(k, guest, v, f, n, &e);
        box_line_of(k, 1 - guest, v, e.d, &l);
        for (int c = 0; c < box_corners(k, guest); c++) {
            if (!box_starts(k, guest, n, c))
                continue;
            box_part p = box_cover_line(k, guest, v, &l, g, c, &e, rho, h);
            if (k->moves)
                box_cover(p.lo.hi - p.lo.hi + lane_of(t), &h->time[0], &h->time[1]);
        }
    }
}

/* The paths of all corners. */
FMB_BOX_INLINE void box_cover_paths(const box_kind *k, int guest, const box_view *v,
                                    const box_frame *f, const box_guest *g, lane rho, box_hull *h)
{
    box_direction e;
    box_line l;
    for (int i = 0; i < box_values(k, 1 - guest); i++)
        e.d[i] = v->drift[i];
    for (int j = 0; j < k->dim; j++) {
        e.world[j] = f->speed[j];
        e.own[j] = 0;
    }
    box_line_of(k, 1 - guest, v, e.d, &l);
    for (int c = 0; c < box_corners(k, guest); c++) {
        box_part p = box_cover_line(k, guest, v, &l, g, c, &e, rho, h);
        h->time[0] = lane_min(p.lo.hi, h->time[0]);
        h->time[1] = lane_max(p.hi.hi + (p.lo.hi - p.lo.hi), h->time[1]);
    }
}

#endif
