/* box_cyrus_beck.h: the part of a line segment, y + s d for 0 <= s <= 1, that is in the host.
 *
 * y and d are values of the guest in the host's coordinates (box_view.h): corners and edges, or
 * corners and the drift. Where value i of the host asks for y_i + s d_i >= 0, s = -y_i / d_i is the
 * lower end if d_i > 0, and the upper end if d_i < 0; y_i + s d_i <= size likewise. As |s| <= 1,
 * y_i + s d_i is known within error_i; so the exact part lies within the one for >= -error_i, and
 * contains the one for >= error_i: ends move by margin = error_i / |d_i|, out and in. 16 units more
 * cover the rounding of an end: docs/error-bounds.md, "Clipping".
 *
 * |d_i| is taken to be at least 2^-10 error_i: this changes it by at most that much, which error_i
 * has room for (a part of the unit that is left).
 *
 * Of each part there are an outer and an inner version. Outer empty: there is certainly no point.
 * Inner not empty: there certainly is one, and the outer ends exceed the exact ones by at most
 * `gap`, the distance between the versions. Otherwise gap is infinite.
 *
 * Source: Cyrus, Beck, Generalized two- and three-dimensional clipping, 1978.
 */
#ifndef FMB_PAIR_BOX_CYRUS_BECK_H
#define FMB_PAIR_BOX_CYRUS_BECK_H

#include "pair/kernels/box/box_hull.h"

typedef struct box_line {
    lane2 d[BOX_VALUES];
    lane r[BOX_VALUES], margin[BOX_VALUES]; /* r = 1 / d */
} box_line;

typedef struct box_part {
    lane2 lo, hi;      /* outer; NaN where empty */
    lane middle, half; /* of them, in doubles */
    lane gap;          /* 0 where empty */
} box_part;

FMB_BOX_INLINE void box_line_of(const box_kind *k, int host, const box_view *v, const lane2 *d,
                                box_line *l)
{
    for (int i = 0; i < box_values(k, host); i++) {
        lane least = lane_of(0x1p-10) * v->error[i];
        lane_mask tiny = lane_less(lane_abs(d[i].hi), least);
        l->d[i] = lane2_pick(k->fine, tiny, lane2_of(lane_times_sign(least, d[i].hi)), d[i]);
        l->r[i] = lane_of(1) / l->d[i].hi;
        l->margin[i] = lane_fma(v->error[i], lane_abs(l->r[i]), lane_of(16 * LANE2_UNIT(k->fine)));
    }
}

typedef struct box_ends {
    lane2 outer[2], inner[2]; /* lower, upper */
} box_ends;

FMB_BOX_INLINE void box_raise(const box_kind *k, box_ends *e, lane2 lo, lane2 margin)
{
    e->outer[0] = lane2_max(k->fine, lane2_subtract(k->fine, lo, margin), e->outer[0]);
    e->inner[0] = lane2_max(k->fine, lane2_add(k->fine, lo, margin), e->inner[0]);
}

FMB_BOX_INLINE void box_lower(const box_kind *k, box_ends *e, lane2 hi, lane2 margin)
{
    e->outer[1] = lane2_min(k->fine, lane2_add(k->fine, hi, margin), e->outer[1]);
    e->inner[1] = lane2_min(k->fine, lane2_subtract(k->fine, hi, margin), e->inner[1]);
}

/* 0 <= y + s d <= size */
FMB_BOX_INLINE void box_between(const box_kind *k, const box_line *l, int i, lane2 y, lane2 size,
                                box_ends *e)
{
    lane2 s = lane2_over(k->fine, lane2_minus(y), l->d[i], l->r[i]);
    lane2 t = lane2_over(k->fine, lane2_subtract(k->fine, size, y), l->d[i], l->r[i]);
    box_raise(k, e, lane2_min(k->fine, s, t), lane2_of(l->margin[i]));
    box_lower(k, e, lane2_max(k->fine, s, t), lane2_of(l->margin[i]));
}

/* 0 <= y + s d; the other end stays at 0 or 1 */
FMB_BOX_INLINE void box_above(const box_kind *k, const box_line *l, int i, lane2 y, box_ends *e)
{
    const lane2 zero = lane2_of(lane_of(0)), one = lane2_of(lane_of(1)), m = lane2_of(l->margin[i]);
    lane2 s = lane2_over(k->fine, lane2_minus(y), l->d[i], l->r[i]);
    lane_mask rises = lane_less(zero.hi, l->d[i].hi);
    box_ends other = *e;
    box_raise(k, &other, lane2_pick(k->fine, rises, s, zero), m);
    box_lower(k, &other, lane2_pick(k->fine, rises, one, s), m);
    for (int version = 0; version < 2; version++) {
        lane2 *to = version ? e->inner : e->outer, *from = version ? other.inner : other.outer;
        to[0] = lane2_pick(k->fine, rises, from[0], to[0]);
        to[1] = lane2_pick(k->fine, rises, to[1], from[1]);
    }
}

/* The part is widened a little on either side to cover the rounding of both numbers. */
FMB_BOX_INLINE void box_measure(box_part *p)
{
    p->middle = lane_of(0.5) * (p->lo.hi + p->hi.hi);
    p->half = lane_fma(lane_of(0.5), p->hi.hi - p->lo.hi, lane_of(0x1p-52));
}

FMB_BOX_INLINE box_part box_part_of(const box_kind *k, const box_ends *e)
{
    const lane zero = lane_of(0), none = lane_of(NAN);
    box_part part = {.lo = e->outer[0], .hi = e->outer[1]};
    lane_mask empty = lane_less(lane2_compare(k->fine, e->outer[1], e->outer[0]), zero);
    lane_mask doubtful = lane_less(lane2_compare(k->fine, e->inner[1], e->inner[0]), zero);
    lane below = lane2_compare(k->fine, e->inner[0], e->outer[0]);
    lane above = lane2_compare(k->fine, e->outer[1], e->inner[1]);
    part.gap = lane_pick(doubtful, lane_of(HUGE_VAL), lane_max(below, above));
    part.gap = lane_pick(empty, zero, part.gap);
    part.lo.hi = lane_pick(empty, none, part.lo.hi);
    part.hi.hi = lane_pick(empty, none, part.hi.hi);
    box_measure(&part);
    return part;
}

FMB_BOX_INLINE box_part box_clip_segment(const box_kind *k, int host, const box_view *v,
                                         const box_line *l, const lane2 *y)
{
    const lane2 zero = lane2_of(lane_of(0)), one = lane2_of(lane_of(1));
    box_ends e = {{zero, one}, {zero, one}};
    for (int i = 0; i < box_values(k, host); i++)
        if (k->shape[host] == FMB_SIMPLEX)
            box_above(k, l, i, y[i], &e);
        else
            box_between(k, l, i, y[i], v->size, &e);
    return box_part_of(k, &e);
}

#endif
