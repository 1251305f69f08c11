/* contact_kernel.h: the penetration depth of two frames in the plane or in space.
 *
 * The least depth is along one of the normals of flat.h, since the point of the boundary of B - A
 * nearest to 0 lies in one of its facets; the depth in any other direction is no less. So one pass
 * tests all normals, which also gives the verdict: the frames overlap by o / |n| along n, where o
 * is minus the gap of verdict_flat.h, and the least of these is found without a root or a division.
 * With errors e of o and h of |n|, and U the depth along the normal found, rounded up, a second
 * pass proves (o - e) / (|n| + h) >= U - 2^-40 reach for all normals: then the depth found has no
 * larger error than this, whichever normal is the true one.
 *
 * Two parallel edges have no normal, and the computed one is noise. If all its coordinates are that
 * small, products of coordinates are compared exactly; if they are equal, the normal is ignored.
 *
 * Errors: docs/error-bounds.md, "Contacts of pairs". Sizes are as in verdict_flat.h, so a reach is
 * known well only if it is far above the least of them: no lane below 2^-90 is good.
 */
#ifndef FMB_PAIR_CONTACT_KERNEL_H
#define FMB_PAIR_CONTACT_KERNEL_H

#include "pair/kernels/contact/contact_overlap.h"
#include "pair/kernels/lane/error_free.h"

/* The results for each normal: overlap, square of the length, sizes of directions. */
typedef struct contact_rows {
    lane overlap[FMB_FLAT_MOST_NORMALS], square[FMB_FLAT_MOST_NORMALS], size[FMB_FLAT_MOST_NORMALS];
} contact_rows;

/* The least so far. */
typedef struct contact_least {
    lane overlap, square, size, normal[3];
} contact_least;

FMB_INLINE lane contact_root(lane a)
{
#if FMB_LANES > 1
    return LANE(sqrt, a);
#else
    return sqrt(a);
#endif
}

/* ---- normals that are none ------------------------------------------------------------------- */

/* 0 if all nonzero coordinates are at least 2^-400, so that products are exact. */
FMB_INLINE lane contact_tiny(int dim, const lane *x)
{
    lane sum = lane_of(0);
    for (int j = 0; j < dim; j++) {
        lane at = lane_abs(x[j]);
        sum = sum + lane_pick(lane_less(at, lane_of(0x1p-400)), at, lane_of(0));
    }
    return sum;
}

/* 0 if direction i is known without an error. */
FMB_INLINE lane contact_rounded(int dim, const fmb_flat_kind *k, const flat_pair *p, int i)
{
    int side = i >= FMB_FLAT_MOST_EDGES, base = side * FMB_FLAT_MOST_EDGES;
    lane sum = lane_of(0);
    if (i == FMB_FLAT_DRIFT)
        return lane_of(1);
    if (i > FMB_FLAT_DRIFT || i - base < k->side[side].naxes)
        return sum;
    const uint8_t *ends = fmb_flat_ends(i - base, k->side[side].naxes);
    for (int j = 0; j < dim; j++)
        sum =
            sum +
            lane_abs(two_sum(p->direction[base + ends[1]][j], -p->direction[base + ends[0]][j]).lo);
    return sum;
}

/* The lanes where normal i is exactly 0. */
FMB_INLINE lane_mask contact_is_null(int dim, const fmb_flat_kind *k, const flat_pair *p, int i)
{
    const uint8_t *of = k->normal[i];
    const lane *f = p->direction[of[0]], *g = p->direction[of[1]];
    lane sum = contact_rounded(dim, k, p, of[0]);
    if (dim == 2) {
        sum = sum + lane_abs(f[0]) + lane_abs(f[1]);
    } else {
        sum = sum + contact_rounded(dim, k, p, of[1]) + contact_tiny(3, f) + contact_tiny(3, g);
        for (int j = 0; j < 3; j++) {
            lane2 a = two_product(f[j], g[(j + 1) % 3]), b = two_product(f[(j + 1) % 3], g[j]);
            sum = sum + lane_abs(a.hi - b.hi) + lane_abs(a.lo - b.lo);
        }
    }
    return lane_less(sum, lane_of(0x1p-1074));
}

/* ---- the two passes -------------------------------------------------------------------------- */

/* Is o / |n| the least so far? Only normals that are known well are candidates. */
FMB_INLINE void contact_compare(int dim, lane overlap, lane square, lane size, const lane *n,
                                lane side, contact_least *x)
{
    lane_mask less = lane_less(overlap * overlap * x->square, x->overlap * x->overlap * square);
    less = lane_and(less, lane_less(lane_of(0x1p-40) * size * size, square));
    x->overlap = lane_pick(less, overlap, x->overlap);
    x->square = lane_pick(less, square, x->square);
    x->size = lane_pick(less, size, x->size);
    for (int j = 0; j < dim; j++)
        x->normal[j] = lane_pick(less, lane_times_sign(n[j], side), x->normal[j]);
}

/* The lanes where the overlaps along all normals prove that no depth is below `most`, the depth
 * less its allowed error; 2^-50 covers the rounding in this test. */
FMB_INLINE lane_mask contact_prove(const contact_rows *x, int normals, double error, double off,
                                   lane reach, lane depth, lane most)
{
    lane t = most * lane_of(1 + 0x1p-50), worst = lane_of(INFINITY);
    lane per_size = lane_of(error * 0x1p-53) * reach + lane_of(off * 0x1p-53) * depth;
    for (int i = 0; i < normals; i++) {
        lane sure = lane_max(lane_fnma(per_size, x->size[i], x->overlap[i]), lane_of(0));
        worst = lane_min(worst, sure * sure - t * t * x->square[i]);
    }
    lane_mask by_normals = lane_less(lane_of(0), worst);
    return lane_or(by_normals, lane_less(most, lane_of(0x1p-1074)));
}

FMB_INLINE void contact_write(int dim, const contact_least *x, lane length, fmb_contact_lanes *out)
{
    lane_store(out->depth, lane_max(x->overlap / length, lane_of(0)));
    for (int j = 0; j < dim; j++)
        lane_store(out->normal[j], x->normal[j] / length);
}

/* dim and cuboids are constant; cuboids: all axes, and nothing moves. */
FMB_INLINE void fmb_contact_pass(int dim, bool cuboids, const fmb_flat_kind *k, const double *block,
                                 fmb_contact_lanes *out)
{
    const double error = dim == 2 ? FLAT_ERROR_PLANE : FLAT_ERROR_SPACE;
    const double off = dim == 2 ? CONTACT_LENGTH_PLANE : CONTACT_LENGTH_SPACE;
    const int normals = !cuboids ? k->normals : dim == 2 ? 4 : 15;
    flat_pair p;
    contact_rows rows;
    fmb_gaps gaps = fmb_gaps_none();
    contact_least least = {
        lane_of(0x1p500), lane_of(1), lane_of(1), {lane_of(1), lane_of(0), lane_of(0)}};
    lane middle[3];
    flat_load(dim, k, block, &p);
    if (cuboids)
        contact_between_middles(dim, &p, middle);
    lane_mask known = lane_less(p.reach, lane_of(0x1p100));
    for (int i = 0; i < normals; i++) {
        lane n[3], side;
        lane size = flat_normal(dim, k, &p, i, n), square = local_frame_dot(dim, n, n);
        lane overlap = cuboids ? contact_of_cuboids(dim, &p, middle, n, &side)
                               : contact_of_any(dim, k, &p, n, &side);
        contact_compare(dim, overlap, square, size, n, side, &least);
        lane_mask noise = lane_less(square, lane_of(0x1p-96) * size * size);
        if (lane_bits(noise)) { /* a normal that is exactly 0 does not count in the proof */
            noise = contact_is_null(dim, k, &p, i);
            overlap = lane_pick(noise, lane_of(8) * size * p.reach, overlap);
            square = lane_pick(noise, size * size, square);
        }
        fmb_gaps_class(&gaps, -overlap, error, 0, fmb_bound_rounded(size * p.reach));
        rows.overlap[i] = overlap;
        rows.square[i] = square;
        rows.size[i] = size;
        if (i % 4 == 2 && fmb_gaps_done(&gaps, known, &out->bits))
            return;
    }
    out->bits = fmb_gaps_bits(&gaps, known);
    /* where no normal is one, B - A is a segment or a point */
    lane_mask found = lane_less(least.overlap, lane_of(0x1p499));
    out->bits.meet = k->may_meet ? out->bits.meet & lane_bits(found) : 0;
    lane length = contact_root(least.square);
    lane above =
        (least.overlap + fmb_gaps_error(error, 0, fmb_bound_rounded(least.size * p.reach))) /
        (length - lane_of(off * 0x1p-53) * least.size);
    above = lane_max(above * lane_of(1 + 0x1p-50), lane_of(0));
    lane most = lane_max(lane_fnma(lane_of(0x1p-40), p.reach, above), lane_of(0));
    lane_mask wide = lane_and(known, lane_less(lane_of(0x1p-90), p.reach));
    out->good =
        lane_bits(lane_and(wide, contact_prove(&rows, normals, error, off, p.reach, above, most)));
    contact_write(dim, &least, length, out);
}

static inline bool contact_is_of_cuboids(const fmb_flat_kind *k)
{
    return !k->moves && !k->side[0].simplex && !k->side[1].simplex && k->side[0].naxes == k->dim &&
           k->side[1].naxes == k->dim;
}

static FMB_NEVER_CLONED void contact_ask(const fmb_flat_kind *k, const double *block,
                                         fmb_contact_lanes *out)
{
    const bool cuboids = contact_is_of_cuboids(k);
    if (k->dim == 2 && cuboids)
        fmb_contact_pass(2, true, k, block, out);
    else if (k->dim == 2)
        fmb_contact_pass(2, false, k, block, out);
    else if (cuboids)
        fmb_contact_pass(3, true, k, block, out);
    else
        fmb_contact_pass(3, false, k, block, out);
}

#endif
