/* contact_distance.h: the distance of two frames in the plane or in space, and the nearest points.
 *
 * GJK (gjk.h) for all lanes at once. M is the set of differences a - b, swept while B moves. A lane
 * keeps D vertices of M, perhaps repeated, and the point x nearest to 0 of their hull. The next
 * vertex v is the farthest along -x. The nearest point of the larger hull is v, or inside an edge
 * from v, or in space inside a triangle at v, as the hull before has no point nearer than x. All
 * these candidates are computed, and the nearest of those inside their edge or triangle is taken if
 * it is nearer than x.
 *
 * The result is proved independently: x is finally recomputed from vertices and weights, a point of
 * M, which bounds the distance from above; and each direction w with its farthest vertex m bounds
 * it from below by (w m - 128 u reach |w|) / length of w (docs/error-bounds.md, "Distances, and
 * hulls"). A lane is good if the bounds differ by at most 2^-41 reach; so lanes of frames that
 * touch or meet are never good unless these bounds are both very small.
 */
#ifndef FMB_PAIR_CONTACT_DISTANCE_H
#define FMB_PAIR_CONTACT_DISTANCE_H

#include "pair/kernels/contact/contact_kernel.h"

/* The most steps; lanes that need more are computed one by one. */
enum { DISTANCE_STEPS = 12 };

/* A vertex of M: itself, the one of A, 1 after the drift, else 0; and its weight. */
typedef struct distance_vertex {
    lane x[3], a[3], late, weight;
} distance_vertex;

/* The nearest point so far, and the best lower bound with its direction and length. */
typedef struct distance_state {
    distance_vertex v[3];
    lane x[3], square;
    lane apart, along[3], length;
} distance_state;

FMB_INLINE void distance_pick_vertex(int dim, bool moves, lane_mask m, const distance_vertex *from,
                                     distance_vertex *to)
{
    for (int j = 0; j < dim; j++) {
        to->x[j] = lane_pick(m, from->x[j], to->x[j]);
        to->a[j] = lane_pick(m, from->a[j], to->a[j]);
    }
    if (moves)
        to->late = lane_pick(m, from->late, to->late);
    to->weight = lane_pick(m, from->weight, to->weight);
}

/* ---- support --------------------------------------------------------------------------------- */

/* The vertex of one side that is farthest along sign times w, from its origin. */
FMB_INLINE void distance_farthest(int dim, const fmb_flat_side *s, const lane (*edge)[3],
                                  const lane *w, double sign, lane *out)
{
    lane most = lane_of(0);
    for (int j = 0; j < dim; j++)
        out[j] = lane_of(0);
    for (int i = 0; i < s->naxes; i++) {
        lane at = lane_of(sign) * local_frame_dot(dim, w, edge[i]);
        lane_mask more = lane_less(most, at);
        for (int j = 0; j < dim; j++) {
            lane to = s->simplex ? lane_of(0) : out[j];
            out[j] = lane_pick(more, to + edge[i][j], out[j]);
        }
        most = s->simplex ? lane_max(most, at) : most;
    }
}

/* The vertex of M that is farthest along -w. */
FMB_INLINE void distance_support_of(int dim, const fmb_flat_kind *k, const flat_pair *p,
                                    const lane *w, distance_vertex *out)
{
    lane b[3];
    distance_farthest(dim, &k->side[0], p->direction, w, -1, out->a);
    distance_farthest(dim, &k->side[1], p->direction + FMB_FLAT_MOST_EDGES, w, 1, b);
    out->late = lane_of(0);
    for (int j = 0; j < dim; j++)
        out->x[j] = out->a[j] - (b[j] + p->shift[j]);
    if (!k->moves)
        return;
    const lane *drift = p->direction[FMB_FLAT_DRIFT];
    lane_mask late = lane_less(lane_of(0), local_frame_dot(dim, w, drift));
    out->late = lane_pick(late, lane_of(1), out->late);
    for (int j = 0; j < dim; j++)
        out->x[j] = lane_pick(late, out->x[j] - drift[j], out->x[j]);
}

/* Used in three places; not inlined, as it is long. */
static FMB_NEVER_CLONED void distance_support(int dim, const fmb_flat_kind *k, const flat_pair *p,
                                              const lane *w, distance_vertex *out)
{
    if (dim == 2)
        distance_support_of(2, k, p, w, out);
    else
        distance_support_of(3, k, p, w, out);
}

/* Update the lower bound of the distance by the farthest vertex along -w. */
FMB_INLINE void distance_note(int dim, const lane *w, lane length, const lane *vertex, lane reach,
                              distance_state *s)
{
    lane between = lane_fnma(lane_of(128 * 0x1p-53) * reach, flat_size(dim, w),
                             local_frame_dot(dim, w, vertex));
    lane apart = between / length * lane_of(1 - 0x1p-49);
    lane_mask more = lane_less(s->apart, apart);
    s->apart = lane_pick(more, apart, s->apart);
    s->length = lane_pick(more, length, s->length);
    for (int j = 0; j < dim; j++)
        s->along[j] = lane_pick(more, w[j], s->along[j]);
}

/* ---- the nearest point with a vertex more ---------------------------------------------------- */

/* The vertex v and, from it, the others: edges, their products with each other and with -v. */
typedef struct distance_fan {
    lane e[3][3], g[3][3], h[3];
} distance_fan;

/* The nearest so far: its place, and the weights of the others. */
typedef struct distance_best {
    lane square, x[3], weight[3];
} distance_best;

FMB_INLINE void distance_take(int dim, lane_mask inside, const lane *x, int i, lane wi, int k,
                              lane wk, distance_best *b)
{
    lane square = local_frame_dot(dim, x, x);
    lane_mask m = lane_and(inside, lane_less(square, b->square));
    b->square = lane_pick(m, square, b->square);
    for (int j = 0; j < dim; j++)
        b->x[j] = lane_pick(m, x[j], b->x[j]);
    for (int j = 0; j < dim; j++)
        b->weight[j] = lane_pick(m, j == i ? wi : j == k ? wk : lane_of(0), b->weight[j]);
}

/* The point is turned to right angles with the edge once more, as in gjk.c. */
FMB_INLINE void distance_to_edge(int dim, const distance_fan *f, const lane *v, int i,
                                 distance_best *b)
{
    lane x[3], t = f->h[i] / f->g[i][i];
    lane_mask inside = lane_and(lane_less(lane_of(0), f->h[i]), lane_less(f->h[i], f->g[i][i]));
    for (int j = 0; j < dim; j++)
        x[j] = lane_fma(t, f->e[i][j], v[j]);
    lane off = local_frame_dot(dim, x, f->e[i]) / f->g[i][i];
    for (int j = 0; j < dim; j++)
        x[j] = lane_fnma(off, f->e[i][j], x[j]);
    distance_take(dim, inside, x, i, t, -1, lane_of(0), b);
}

/* Of a triangle that is not nearly flat; two edges that are the same are. */
static FMB_NEVER_CLONED void distance_to_triangle(const distance_fan *f, const lane *v, int i,
                                                  int k, distance_best *b)
{
    lane n[3], x[3];
    fmb_cross(f->e[i], f->e[k], n);
    lane square = local_frame_dot(3, n, n), off = local_frame_dot(3, n, v);
    lane wi = lane_fms(f->h[i], f->g[k][k], f->h[k] * f->g[i][k]);
    lane wk = lane_fms(f->h[k], f->g[i][i], f->h[i] * f->g[i][k]);
    lane_mask inside = lane_and(lane_less(lane_of(0), wi), lane_less(lane_of(0), wk));
    inside = lane_and(inside, lane_less(wi + wk, square));
    inside = lane_and(inside, lane_less(lane_of(0x1p-40) * f->g[i][i] * f->g[k][k], square));
    lane one = lane_of(1) / square;
    for (int j = 0; j < 3; j++)
        x[j] = off * one * n[j];
    distance_take(3, inside, x, i, wi * one, k, wk * one, b);
}

FMB_INLINE void distance_make_fan(int dim, const distance_state *s, const lane *v, distance_fan *f)
{
    for (int i = 0; i < dim; i++) {
        for (int j = 0; j < dim; j++)
            f->e[i][j] = s->v[i].x[j] - v[j];
        f->h[i] = lane_of(0) - local_frame_dot(dim, f->e[i], v);
        for (int k = 0; k <= i; k++)
            f->g[i][k] = f->g[k][i] = local_frame_dot(dim, f->e[i], f->e[k]);
    }
}

/* Where that is nearer: the vertices with a weight, v as the first; in the other places v again. */
FMB_INLINE void distance_keep(int dim, bool moves, lane_mask nearer, const distance_best *b,
                              distance_vertex *v, distance_state *s)
{
    lane_mask with[3];
    v->weight = lane_of(1);
    for (int i = 0; i < dim; i++) {
        with[i] = lane_less(lane_of(0), b->weight[i]);
        v->weight = v->weight - b->weight[i];
        s->v[i].weight = lane_pick(nearer, b->weight[i], s->v[i].weight);
    }
    distance_vertex none = *v, second, third;
    none.weight = lane_of(0);
    second = third = none;
    distance_pick_vertex(dim, moves, with[1], &s->v[1], &second);
    distance_pick_vertex(dim, moves, with[0], &s->v[0], &second);
    if (dim == 3) {
        distance_pick_vertex(dim, moves, lane_and(with[0], with[1]), &s->v[1], &third);
        distance_pick_vertex(dim, moves, with[2], &s->v[2], &third);
        distance_pick_vertex(dim, moves, nearer, &third, &s->v[2]);
    }
    distance_pick_vertex(dim, moves, nearer, v, &s->v[0]);
    distance_pick_vertex(dim, moves, nearer, &second, &s->v[1]);
    s->square = lane_pick(nearer, b->square, s->square);
    for (int j = 0; j < dim; j++)
        s->x[j] = lane_pick(nearer, b->x[j], s->x[j]);
}

/* Where v makes the hull come nearer. */
FMB_INLINE lane_mask distance_step(int dim, bool moves, distance_vertex *v, distance_state *s)
{
    distance_best b = {.square = local_frame_dot(dim, v->x, v->x)};
    for (int j = 0; j < dim; j++) {
        b.x[j] = v->x[j];
        b.weight[j] = lane_of(0);
    }
    distance_fan f;
    distance_make_fan(dim, s, v->x, &f);
    for (int i = 0; i < dim; i++)
        distance_to_edge(dim, &f, v->x, i, &b);
    for (int i = 0; i < 3 && dim == 3; i++)
        distance_to_triangle(&f, v->x, i % 2, i == 0 ? 1 : 2, &b);
    lane_mask nearer = lane_less(b.square, s->square);
    distance_keep(dim, moves, nearer, &b, v, s);
    return nearer;
}

/* ---- blocks ---------------------------------------------------------------------------------- */

/* From between the middles, or so. */
FMB_INLINE void distance_begin(int dim, const fmb_flat_kind *k, const flat_pair *p,
                               distance_state *s)
{
    lane w[3];
    for (int j = 0; j < dim; j++) {
        w[j] = lane_of(0) - p->shift[j];
        for (int side = 0; side < 2; side++) {
            const fmb_flat_side *of = &k->side[side];
            lane sum = lane_of(0);
            for (int i = 0; i < of->naxes; i++)
                sum = sum + p->direction[side * FMB_FLAT_MOST_EDGES + i][j];
            lane share = lane_of((side ? -1 : 1) / (of->simplex ? of->naxes + 1.0 : 2.0));
            w[j] = lane_fma(share, sum, w[j]);
        }
    }
    distance_support(dim, k, p, w, &s->v[0]);
    s->v[0].weight = lane_of(0);
    s->v[1] = s->v[2] = s->v[0];
    s->v[0].weight = lane_of(1);
    s->square = local_frame_dot(dim, s->v[0].x, s->v[0].x);
    s->apart = s->length = lane_of(0);
    for (int j = 0; j < dim; j++) {
        s->x[j] = s->v[0].x[j];
        s->along[j] = lane_of(0);
    }
}

FMB_INLINE void distance_search(int dim, const fmb_flat_kind *k, const flat_pair *p,
                                distance_state *s)
{
    distance_begin(dim, k, p, s);
    for (int step = 0; step < DISTANCE_STEPS; step++) {
        distance_vertex v;
        lane length = contact_root(s->square);
        distance_support(dim, k, p, s->x, &v);
        distance_note(dim, s->x, length, v.x, p->reach, s);
        lane_mask open = lane_less(lane_fma(lane_of(0x1p-42), p->reach, s->apart), length);
        if (!lane_bits(open) || !lane_bits(lane_and(open, distance_step(dim, k->moves, &v, s))))
            return;
    }
}

/* How far both sides go towards each other along the normal, from A's origin. */
FMB_INLINE void distance_write_ends(int dim, const fmb_flat_kind *k, const flat_pair *p,
                                    const lane *normal, fmb_distance_lanes *out)
{
    distance_vertex v;
    lane w[3], b[3];
    for (int j = 0; j < dim; j++)
        w[j] = lane_of(0) - normal[j];
    distance_support(dim, k, p, w, &v);
    for (int j = 0; j < dim; j++)
        b[j] = v.a[j] - v.x[j];
    lane_store(out->low, local_frame_dot(dim, normal, v.a));
    lane_store(out->high, local_frame_dot(dim, normal, b));
    lane_store(out->reach, p->reach);
}

FMB_INLINE void distance_write(int dim, const fmb_flat_kind *k, const flat_pair *p,
                               const distance_state *s, fmb_distance_lanes *out)
{
    lane x[3], a[3], normal[3], time = lane_of(0);
    for (int j = 0; j < dim; j++) {
        x[j] = a[j] = lane_of(0);
        for (int i = 0; i < dim; i++) {
            x[j] = lane_fma(s->v[i].weight, s->v[i].x[j], x[j]);
            a[j] = lane_fma(s->v[i].weight, s->v[i].a[j], a[j]);
        }
        normal[j] = lane_of(0) - s->along[j] / s->length;
    }
    for (int i = 0; k->moves && i < dim; i++)
        time = lane_fma(s->v[i].weight, s->v[i].late, time);
    lane length = contact_root(local_frame_dot(dim, x, x));
    lane_mask good = lane_less(length, lane_fma(lane_of(0x1p-41), p->reach, s->apart));
    good = lane_and(good, lane_less(lane_of(0), s->apart));
    good = lane_and(good, lane_less(lane_of(0x1p-90), p->reach));
    out->good = lane_bits(lane_and(good, lane_less(p->reach, lane_of(0x1p100))));
    lane_store(out->distance, length);
    lane_store(out->time, time);
    for (int j = 0; j < dim; j++) {
        lane b = a[j] - x[j];
        if (k->moves)
            b = lane_fnma(time, p->direction[FMB_FLAT_DRIFT][j], b);
        lane_store(out->normal[j], normal[j]);
        lane_store(out->point[0][j], a[j]);
        lane_store(out->point[1][j], b);
    }
    distance_write_ends(dim, k, p, normal, out);
}

FMB_INLINE void fmb_distance_of_block(int dim, const fmb_flat_kind *k, const double *block,
                                      fmb_distance_lanes *out)
{
    flat_pair p;
    distance_state s;
    flat_load(dim, k, block, &p);
    distance_search(dim, k, &p, &s);
    distance_write(dim, k, &p, &s, out);
}

static FMB_NEVER_CLONED void distance_ask(const fmb_flat_kind *k, const double *block,
                                          fmb_distance_lanes *out)
{
    if (k->dim == 2)
        fmb_distance_of_block(2, k, block, out);
    else
        fmb_distance_of_block(3, k, block, out);
}

#endif
