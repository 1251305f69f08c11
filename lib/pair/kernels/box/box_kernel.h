/* box_kernel.h: the box of the common points of two frames that meet.
 *
 * Every end is reached at a vertex of the common points. In space, a vertex lies on an edge of A or
 * on an edge of B: all edges of each frame are clipped against the other. In space and time it
 * lies on an edge of A or B at t = 0 or t = 1, or on the path of a corner of A or B, or it is where
 * an edge of A meets an edge of B on its way (three dimensions). Proof: docs/theory.md,
 * theorem 37.
 *
 * Ends in the world: a point has at most 10 roundings, each of a number at most
 *
 *     far = largest origin + 3 (alpha + beta) + largest speed + largest shift and drift,
 *
 * so all are moved out by 12 u far (docs/error-bounds.md, "World"); with M the largest coordinate
 * of a corner at t = 0 or 1, alpha, beta, the speeds, shift and drift are at most 2 M, or 4 M for
 * drift: far <= 21 M, and ends exceed the exact ones by at most 2 * 12 * 21 u M < 1e-13 M for this,
 * and by 2 gap M, or 4 gap M where u and t both are off, for the gap of edges.
 */
#ifndef FMB_PAIR_BOX_KERNEL_H
#define FMB_PAIR_BOX_KERNEL_H

#include "pair/kernels/box/box_cross.h"
#include "pair/kernels/box/box_still.h"
#include "pair/kernels/pair_kernels.h"

typedef struct box_pair {
    box_frame frame[2]; /* A, B */
    lane far;
    lane_mask known; /* numbers have sizes for which all error bounds hold */
} box_pair;

FMB_BOX_INLINE const double *box_load(int dim, const double *rows, lane *x, lane *most)
{
    for (int j = 0; j < dim; j++) {
        x[j] = lane_load(rows + j * FMB_LANES);
        *most = lane_max(*most, lane_abs(x[j]));
    }
    return rows + dim * FMB_LANES;
}

/* Load a pair; a block has a cuboid before a simplex. */
FMB_BOX_INLINE void box_pair_of(const box_kind *k, const double *block, box_pair *p)
{
    const int d = k->dim, swapped = k->shape[0] == FMB_SIMPLEX && k->shape[1] == FMB_CUBOID;
    const double *rows = block + d * FMB_LANES; /* shift is computed anew, with its lower half */
    lane edges[2] = {lane_of(0), lane_of(0)}, places = lane_of(0), speeds = lane_of(0);
    for (int f = 0; f < 2; f++)
        for (int l = 0; l < d; l++)
            rows = box_load(d, rows, p->frame[f ^ swapped].axes[l], &edges[f]);
    rows += k->moves ? d * FMB_LANES : 0;
    for (int f = 0; f < 2; f++)
        rows = box_load(d, rows, p->frame[f ^ swapped].origin, &places);
    for (int f = 0; f < 2; f++)
        if (k->moves)
            rows = box_load(d, rows, p->frame[f ^ swapped].speed, &speeds);
        else
            for (int j = 0; j < d; j++)
                p->frame[f ^ swapped].speed[j] = lane_of(0);
    p->far = lane_of(3) * (places + speeds + edges[0] + edges[1]);
    lane edge = lane_max(edges[0], edges[1]), most = lane_max(lane_max(places, speeds), edge);
    p->known = lane_and(lane_less(lane_of(0x1p-40), lane_min(edges[0], edges[1])),
                        lane_less(most, lane_of(0x1p40)));
}

FMB_BOX_INLINE void box_store_ends(int dim, const lane lower[3], const lane upper[3],
                                   double *answer)
{
    for (int j = 0; j < dim; j++) {
        lane_store(answer + j * FMB_LANES, lower[j]);
        lane_store(answer + (dim + j) * FMB_LANES, upper[j]);
    }
}

/* Coordinates and times are within 0 ... 1. */
FMB_BOX_INLINE void box_store(const box_kind *k, const box_pair *p, box_hull *h, const lane *blur,
                              double *answer)
{
    const lane zero = lane_of(0), one = lane_of(1), out = lane_of(12 * 0x1p-53);
    const lane round = lane_of(8 * 0x1p-53);
    const int d = k->dim;
    for (int j = 0; j < d; j++) {
        h->world[0][j] = h->world[0][j] - out * p->far;
        h->world[1][j] = h->world[1][j] + out * p->far;
        h->inside[0][j] = lane_max(h->inside[0][j] - blur[j], zero);
        h->inside[1][j] = lane_min(h->inside[1][j] + blur[j], one);
        lane_store(answer + (4 * d + 2 + j) * FMB_LANES, h->sum[j] / h->points);
    }
    box_store_ends(d, h->world[0], h->world[1], answer);
    box_store_ends(d, h->inside[0], h->inside[1], answer + 2 * d * FMB_LANES);
    lane first = k->moves ? lane_max(h->time[0] - round, zero) : zero;
    lane last = k->moves ? lane_min(h->time[1] + round, one) : one;
    lane_store(answer + 4 * d * FMB_LANES, first);
    lane_store(answer + (4 * d + 1) * FMB_LANES, last);
}

/* The guest in the host; not inlined, shared by lines of either precision. */
#define BOX_VIEW(name, dimension)                                                                  \
    static FMB_NEVER_CLONED void name(const box_kind *of, int guest, const box_frame *host,        \
                                      const box_frame *own, box_view *v, box_guest *g)             \
    {                                                                                              \
        const box_kind k = {dimension, of->moves, of->fine, {of->shape[0], of->shape[1]}};         \
        box_view_of(&k, guest, host, own, v);                                                      \
        box_guest_of(&k, guest, v, own, g);                                                        \
    }

BOX_VIEW(box_view_in_plane, 2)
BOX_VIEW(box_view_in_space, 3)

/* Only dim and fine are constants, as otherwise there would be 28 copies of this code. If not fine,
 * lines are clipped in doubles; all else is in double-doubles. */
FMB_BOX_INLINE unsigned box_kernel(int dim, bool fine, bool moves, int a, int b,
                                   const double *block, double *answer)
{
    const box_kind kind = {dim, moves, fine, {a, b}}, *k = &kind;
    lane blur[3], rho, most_blur = lane_of(0);
    box_pair p;
    box_hull h;
    box_pair_of(k, block, &p);
    box_hull_empty(&h);
    lane_mask known = p.known;
    for (int guest = 0; guest < 2; guest++) {
        const box_frame *host = &p.frame[1 - guest], *own = &p.frame[guest];
        box_view v;
        box_guest g;
        if (dim == 2)
            box_view_in_plane(k, guest, host, own, &v, &g);
        else
            box_view_in_space(k, guest, host, own, &v, &g);
        rho = lane_of(1) / v.size.hi;
        box_cover_edges(k, guest, &v, own, &g, 0, rho, &h);
        if (moves) {
            box_cover_paths(k, guest, &v, own, &g, rho, &h);
            if (guest == 1 && dim == 3)
                box_cover_contacts(a, b, &v, own, &g, &h);
            box_guest_move(k, guest, &v, own, &g);
            box_cover_edges(k, guest, &v, own, &g, 1, rho, &h);
        }
        for (int j = 0; guest == 0 && j < dim; j++) {
            blur[j] = lane_of(fine ? 1.5 : 2.25) * rho * v.error[j] + lane_of(8 * 0x1p-53);
            most_blur = lane_max(most_blur, blur[j]);
        }
        known = lane_and(known, v.known);
    }
    lane inside = lane_fma(lane_of(2), most_blur, h.inside_gap);
    lane_mask near = lane_less(lane_max(h.gap + h.gap, inside), lane_of(9e-13));
    box_store(k, &p, &h, blur, answer);
    return lane_bits(lane_and(lane_and(known, near), lane_less(lane_of(0), h.points)));
}

/* A table of these is in pair_kernels.h. */
#define BOX_ANY(name, dim, fine)                                                                   \
    static FMB_NEVER_CLONED unsigned name(bool moves, int a, int b, const double *block,           \
                                          double *answer)                                          \
    {                                                                                              \
        return box_kernel(dim, fine, moves, a, b, block, answer);                                  \
    }

BOX_ANY(box_2, 2, false)
BOX_ANY(box_2_fine, 2, true)
BOX_ANY(box_3, 3, false)
BOX_ANY(box_3_fine, 3, true)

#define BOX_STILL(name, dim)                                                                       \
    static unsigned name(bool moves, int a, int b, const double *block, double *answer)            \
    {                                                                                              \
        (void)moves;                                                                               \
        if (STILL_APART(dim))                                                                      \
            return still_kernel(dim, a, b, block, answer);                                         \
        if (a == FMB_CUBOID)                                                                       \
            return b == FMB_CUBOID ? still_kernel(dim, FMB_CUBOID, FMB_CUBOID, block, answer)      \
                                   : still_kernel(dim, FMB_CUBOID, FMB_SIMPLEX, block, answer);    \
        return b == FMB_CUBOID ? still_kernel(dim, FMB_SIMPLEX, FMB_CUBOID, block, answer)         \
                               : still_kernel(dim, FMB_SIMPLEX, FMB_SIMPLEX, block, answer);       \
    }

BOX_STILL(still_2, 2)
BOX_STILL(still_3, 3)

#define FMB_BOXES                                                                                  \
    {                                                                                              \
        {{still_2, box_2}, {still_3, box_3}}, {{box_2, box_2_fine}, {box_3, box_3_fine}},          \
            {{box_2_fine, NULL}, {box_3_fine, NULL}},                                              \
    }

#endif
