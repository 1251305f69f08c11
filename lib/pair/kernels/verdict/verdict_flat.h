/* verdict_flat.h: do two frames with any number of axes meet, in the plane or in space? The normals
 * that decide it are those of flat.h.
 *
 * On a normal n, A spans the values n x of its points x less its origin, B those of its points
 * (while it moves) less A's origin. The gap is that between the two intervals; negative, it is the
 * least depth. If B - A lies in one plane then n is normal to it, or 0, and the gap is not
 * negative.
 *
 * Errors: docs/error-bounds.md, "Any axes". Sizes of directions, and the reach of a pair, are taken
 * to be 2^-100 at least, so that what underflows does not count; the reach is at most 2^100.
 */
#ifndef FMB_PAIR_VERDICT_FLAT_H
#define FMB_PAIR_VERDICT_FLAT_H

#include "frame/flat.h"
#include "pair/kernels/verdict/verdict_gaps.h"

/* A gap is off by this many u times the reach and the sizes of the directions of its normal. */
enum { FLAT_ERROR_PLANE = 24, FLAT_ERROR_SPACE = 96 };

typedef struct flat_pair {
    lane direction[FMB_FLAT_DIRECTIONS][3], size[FMB_FLAT_DIRECTIONS];
    lane shift[3], reach;
} flat_pair;

typedef struct flat_span {
    lane low, high;
} flat_span;

/* The size of a direction, its largest coordinate. */
FMB_INLINE lane flat_size(int dim, const lane *x)
{
    lane most = lane_max_abs(lane_max_abs(lane_of(0x1p-100), x[0]), x[1]);
    return dim == 3 ? lane_max_abs(most, x[2]) : most;
}

FMB_INLINE void flat_add_direction(int dim, int i, flat_pair *p)
{
    p->size[i] = flat_size(dim, p->direction[i]);
}

/* The edges of one side, whose axes are in the rows. */
FMB_INLINE void flat_load_side(int dim, const fmb_flat_side *s, const double *rows, int base,
                               flat_pair *p)
{
    for (int i = 0; i < s->naxes; i++) {
        for (int j = 0; j < dim; j++)
            p->direction[base + i][j] = lane_load(rows + (i * dim + j) * FMB_LANES);
        flat_add_direction(dim, base + i, p);
        p->reach = p->reach + p->size[base + i];
    }
    for (int i = s->naxes; i < s->edges; i++) {
        const uint8_t *ends = fmb_flat_ends(i, s->naxes);
        for (int j = 0; j < dim; j++)
            p->direction[base + i][j] =
                p->direction[base + ends[1]][j] - p->direction[base + ends[0]][j];
        flat_add_direction(dim, base + i, p);
    }
}

FMB_INLINE void flat_load_of(int dim, const fmb_flat_kind *k, const double *block, flat_pair *p)
{
    const double *a = block + dim * FMB_LANES, *b = a + dim * dim * FMB_LANES;
    const double *drift = b + dim * dim * FMB_LANES;
    for (int j = 0; j < dim; j++)
        p->shift[j] = lane_load(block + j * FMB_LANES);
    p->reach = flat_size(dim, p->shift);
    flat_load_side(dim, &k->side[0], a, 0, p);
    flat_load_side(dim, &k->side[1], b, FMB_FLAT_MOST_EDGES, p);
    if (k->moves) {
        for (int j = 0; j < dim; j++)
            p->direction[FMB_FLAT_DRIFT][j] = lane_load(drift + j * FMB_LANES);
        flat_add_direction(dim, FMB_FLAT_DRIFT, p);
        p->reach = p->reach + p->size[FMB_FLAT_DRIFT];
    }
    for (int i = 0; k->needs_world && i < dim; i++) {
        for (int j = 0; j < dim; j++)
            p->direction[FMB_FLAT_WORLD + i][j] = lane_of(i == j);
        p->size[FMB_FLAT_WORLD + i] = lane_of(1);
    }
}

/* Not inlined, as it is long and used by many kernels. */
static FMB_NEVER_CLONED void flat_load(int dim, const fmb_flat_kind *k, const double *block,
                                       flat_pair *p)
{
    if (dim == 2)
        flat_load_of(2, k, block, p);
    else
        flat_load_of(3, k, block, p);
}

/* The interval of one side along the normal n. */
FMB_INLINE flat_span flat_span_of_side(int dim, const fmb_flat_side *s, const lane (*axis)[3],
                                       const lane *n)
{
    flat_span out = {lane_of(0), lane_of(0)};
    for (int i = 0; i < s->naxes; i++) {
        lane at = local_frame_dot(dim, n, axis[i]);
        lane low = lane_min(at, lane_of(0)), high = lane_max(at, lane_of(0));
        if (s->simplex) {
            out.low = lane_min(out.low, low);
            out.high = lane_max(out.high, high);
        } else {
            out.low = out.low + low;
            out.high = out.high + high;
        }
    }
    return out;
}

/* The intervals of both sides along n, each relative to its origin; the second with its drift. */
typedef struct flat_spans {
    lane away; /* the vector between the origins, along n */
    flat_span a, b;
} flat_spans;

FMB_INLINE flat_spans flat_spans_along(int dim, const fmb_flat_kind *k, const flat_pair *p,
                                       const lane *n)
{
    flat_spans s = {local_frame_dot(dim, n, p->shift),
                    flat_span_of_side(dim, &k->side[0], p->direction, n),
                    flat_span_of_side(dim, &k->side[1], p->direction + FMB_FLAT_MOST_EDGES, n)};
    if (k->moves) {
        lane along = local_frame_dot(dim, n, p->direction[FMB_FLAT_DRIFT]);
        s.b.low = s.b.low + lane_min(along, lane_of(0));
        s.b.high = s.b.high + lane_max(along, lane_of(0));
    }
    return s;
}

FMB_INLINE lane flat_gap(int dim, const fmb_flat_kind *k, const flat_pair *p, const lane *n)
{
    flat_spans s = flat_spans_along(dim, k, p, n);
    return lane_max((s.away + s.b.low) - s.a.high, (s.a.low - s.away) - s.b.high);
}

/* The normal number i, and the product of the sizes that it is made of. */
FMB_INLINE lane flat_normal(int dim, const fmb_flat_kind *k, const flat_pair *p, int i, lane *out)
{
    const uint8_t *of = k->normal[i];
    const lane *f = p->direction[of[0]];
    if (dim == 2) {
        out[0] = f[1];
        out[1] = -f[0];
        return p->size[of[0]];
    }
    fmb_cross(f, p->direction[of[1]], out);
    return p->size[of[0]] * p->size[of[1]];
}

FMB_INLINE fmb_pair_bits fmb_flat(int dim, const fmb_flat_kind *k, const double *block)
{
    flat_pair p;
    fmb_gaps gaps = fmb_gaps_none();
    fmb_pair_bits out;
    flat_load(dim, k, block, &p);
    lane_mask known = lane_less(p.reach, lane_of(0x1p100));
    for (int i = 0; i < k->normals; i++) {
        lane n[3];
        lane bound = flat_normal(dim, k, &p, i, n) * p.reach;
        fmb_gaps_class(&gaps, flat_gap(dim, k, &p, n),
                       dim == 2 ? FLAT_ERROR_PLANE : FLAT_ERROR_SPACE, 0, fmb_bound_rounded(bound));
        if (i % 4 == 1 && fmb_gaps_done(&gaps, known, &out))
            return out;
    }
    out = fmb_gaps_bits(&gaps, known);
    out.meet = k->may_meet ? out.meet : 0;
    return out;
}

#endif
