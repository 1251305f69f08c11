/* minors_open.h: lists the rows of a block of pairs that errors leave open; the body of
 * minors_open_*.c, which set FMB_LANES and name the function FMB_MINORS_LIST.
 *
 * Few pairs get here: nothing is unrolled, and the code is shared by all dimensions.
 */
#ifndef FMB_PAIR_MINORS_OPEN_H
#define FMB_PAIR_MINORS_OPEN_H

#include "pair/kernels/minors/minors_kernel.h"

minors_lister FMB_MINORS_LIST;

/* The corners of a simplex whose barycentric coordinates in these rows are 0: they span the face. A
 * single corner has no edges. */
FMB_INLINE unsigned minors_corners_without(int dim, unsigned rows)
{
    const unsigned all = (2U << dim) - 1, left = all & ~rows;
    return (left << 1 & all) | left >> dim;
}

/* List a row that is open in some lanes. It uses the coordinates `set` in the view of `side`, so it
 * is perpendicular to the other edges of that frame, and to the columns of the other one. Its
 * numbers are of the size of `reach`. */
FMB_INLINE void minors_note_row(minors_kind d, int side, unsigned set, unsigned columns, lane gap,
                                lane reach, lane error, fmb_open_rows *out)
{
    unsigned lanes = out->wanted & ~lane_bits(lane_less(gap + error, lane_of(0)));
    const unsigned all = (1U << d.dim) - 1, drift = columns & ~all;
    if (lanes && !out->all)
        lanes &= lane_bits(lane_less(error, reach * lane_of(0x1p-20)));
    if (!lanes)
        return;
    if (out->n == FMB_OPEN_ROWS_MOST) {
        out->full |= lanes;
        return;
    }
    fmb_open_row *row = &out->row[out->n++];
    const unsigned corners = minors_corners_without(d.dim, set);
    const unsigned face = corners & (corners - 1) ? corners : 0; /* a corner has none */
    row->face[side] = (uint16_t)(d.from_simplex ? face : all & ~set);
    row->face[1 - side] = (uint16_t)(columns & all);
    row->face[1] = (uint16_t)(row->face[1] | drift);
    row->from_b = side == 1;
    row->lanes = (uint8_t)lanes;
    out->wanted &= out->all ? ~0U : ~lanes;
}

/* sum (-1)^i factor[i] from[i][s], in a loop. */
static lane minors_list_sum(int k, const lane *factor, const lane *const *from, int s)
{
    lane sum = lane_of(0);
    for (int i = 0; i <= k; i++)
        sum = lane_fma(lane_of(i % 2 ? -1 : 1) * factor[i], from[i][s], sum);
    return sum;
}

/* Like minors_make, for all columns. */
FMB_INLINE void minors_list_make(minors_kind d, const minors_view *v, int k,
                                 const minors_rows *rows, lane *to)
{
    for (int j = k; j < d.n; j++) {
        lane factor[5];
        for (int i = 0; i <= k; i++)
            factor[i] = v->e[rows->row[i] * minors_stride(d, 1) + j];
        for (int s = 0; s < fmb_minors_choose(j, k); s++)
            to[fmb_minors_choose(j, k + 1) + s] = minors_list_sum(k, factor, rows->less, s);
    }
}

/* The gap of columns s, as minors_gap computes it; *size is the sum that was subtracted. */
FMB_INLINE lane minors_list_gap(minors_kind d, const minors_view *v, int k, const minors_rows *rows,
                                const lane *made, int s, lane *size)
{
    lane factor[5], reach = lane_of(0), away;
    for (int i = 0; i <= k; i++)
        factor[i] = v->center[rows->row[i]];
    away = minors_list_sum(k, factor, rows->less, s);
    if (d.from_simplex) {
        minors_span span = minors_no_span();
        for (int i = 0; i <= k; i++)
            span = minors_widen(span, lane_of(i % 2 ? -1 : 1) * rows->less[i][s]);
        away = away - (span.most + span.least);
        reach = span.most - span.least;
    } else {
        for (int i = 0; i <= k; i++)
            reach = reach + lane_abs(rows->less[i][s]);
    }
    for (int j = 0; j < d.n - k; j++)
        reach = reach + lane_abs(made[minors_with(k, s, j)]);
    *size = reach;
    return lane_abs(away) - reach;
}

/* The sign, in the test of these rows and columns s, of the i-th row, or, negated, of column i - k
 * - 1: if the frames are apart along this row, no two of these signs are opposite (minors_signs.h).
 */
FMB_INLINE lane minors_list_sign(minors_kind d, const minors_view *v, int k,
                                 const minors_rows *rows, int s, int i)
{
    lane factor[5];
    if (i <= k)
        return lane_of(i % 2 ? -1 : 1) * rows->less[i][s];
    for (int r = 0; r <= k; r++)
        factor[r] = lane_of(-1) * v->e[rows->row[r] * minors_stride(d, 1) + i - k - 1];
    return minors_list_sum(k, factor, rows->less, s);
}

/* The largest and the least of the signs from `from` up to `to`, without those of used columns. */
FMB_INLINE minors_span minors_list_span(minors_kind d, const minors_view *v, int k,
                                        const minors_rows *rows, unsigned columns, int s, int from,
                                        int to, minors_span span)
{
    for (int i = from; i < to; i++)
        if (i <= k || !(columns >> (i - k - 1) & 1)) {
            const lane sign = minors_list_sign(d, v, k, rows, s, i);
            span = (minors_span){lane_max(span.most, sign), lane_min(span.least, sign)};
        }
    return span;
}

/* Lanes where no two have certainly different signs. */
FMB_INLINE unsigned minors_list_passed(minors_span span, lane error)
{
    return lane_bits(lane_less(lane_min(span.most, lane_of(0) - span.least), error));
}

/* List a test that wanted lanes pass up to errors: the faces of all corners that lie on its plane,
 * or nearly so. */
FMB_INLINE void minors_note_test(minors_kind d, const minors_view *v, int side, int k,
                                 const minors_rows *rows, unsigned set, unsigned columns, int s,
                                 lane error, fmb_open_rows *out)
{
    const int n = d.n + k + 1;
    minors_span span = {lane_of(-INFINITY), lane_of(INFINITY)};
    span = minors_list_span(d, v, k, rows, columns, s, 0, k + 1, span);
    if (!(minors_list_passed(span, error) & out->wanted))
        return;
    span = minors_list_span(d, v, k, rows, columns, s, k + 1, n, span);
    const lane size = lane_max(span.most, lane_of(0) - span.least) * lane_of(0x1p-20);
    const unsigned passed = minors_list_passed(span, error) & lane_bits(lane_less(error, size));
    for (unsigned left = out->wanted & passed; left && out->n < FMB_OPEN_ROWS_MOST;
         left &= left - 1) {
        unsigned without = set, with = columns;
        for (int i = 0; i < n; i++) {
            const lane sign = minors_list_sign(d, v, k, rows, s, i);
            if (!(lane_bits(lane_less(lane_abs(sign), error)) & left & -left))
                continue;
            without &= i <= k ? ~(1U << rows->row[i]) : ~0U;
            with |= i <= k ? 0 : 1U << (i - k - 1);
        }
        fmb_open_row *row = &out->row[out->n++];
        row->face[side] = (uint16_t)minors_corners_without(d.dim, without);
        row->face[1 - side] = (uint16_t)with;
        row->from_b = side == 1;
        row->lanes = (uint8_t)(left & -left);
    }
    out->wanted &= ~passed;
}

/* Of k columns of a side. Few pairs get here: not in the kernels, and once for all dimensions. */
static FMB_NEVER_CLONED void minors_list_level(minors_kind d, int side, minors_view *v, int k,
                                               minors_part part, fmb_open_rows *out)
{
    const int kept = part == MINORS_KEPT ? minors_stride(d, k + 1) : 0;
    const lane error =
        lane_of((d.simplices ? minors_sign_error(d, k) : minors_error(d, k)) * 0x1p-53);
    lane *made = v->to;
    for (unsigned set = (2U << k) - 1; set < 1U << minors_count_rows(d) && out->wanted;
         set = minors_next_set(set)) {
        minors_rows rows;
        lane own[75], *to = kept ? made : own, size;
        minors_find_rows(d, v, k, set, &rows);
        if (kept || !d.simplices)
            minors_list_make(d, v, k, &rows, to);
        unsigned columns = (1U << k) - 1;
        for (int s = 0; columns < 1U << d.n; s++, columns = minors_next_set(columns))
            if (d.simplices) {
                minors_note_test(d, v, side, k, &rows, set, columns, s, error * rows.g, out);
            } else if (part != MINORS_DRIFTED || columns >> d.dim) {
                const lane gap = minors_list_gap(d, v, k, &rows, to, s, &size);
                minors_note_row(d, side, set, columns, gap, size, error * rows.g, out);
            }
        made += kept;
    }
    v->from = v->to;
    v->to = made;
}

/* The last level of a side. */
FMB_INLINE int minors_last_level(minors_kind d, int side)
{
    return d.from_cuboid ? 0 : d.from_simplex ? minors_last_from_simplex(d) : (d.n - 1 - side) / 2;
}

/* The tests of single rows. */
FMB_INLINE void minors_list_corners(minors_kind d, int side, minors_view *v, fmb_open_rows *out)
{
    const lane one = lane_of(1), error = lane_of(minors_sign_error(d, 0) * 0x1p-53);
    for (int r = 0; r < minors_count_rows(d) && out->wanted; r++) {
        const minors_rows rows = {.row = {r}, .less = {&one}};
        minors_note_test(d, v, side, 0, &rows, 1U << r, 0, 0, error * v->g[r], out);
    }
}

/* List all open rows of two cuboids, or of a cuboid and a simplex; or, also for two simplices, one
 * row of each wanted lane, whose numbers are much larger than its error. */
void FMB_MINORS_LIST(int dim, int what, minors_view v[2], fmb_open_rows *out)
{
    for (int k = 0; k < dim && out->wanted; k++)
        for (int side = 0; side < 2; side++) {
            const minors_kind d = minors_side(minors_kind_of(dim, what), side);
            const lane error = lane_of(minors_error(d, 0) * 0x1p-53);
            if (k == 0 && d.simplices)
                minors_list_corners(d, side, &v[side], out);
            for (int r = 0; k == 0 && !d.simplices && r < minors_count_rows(d); r++)
                minors_note_row(d, side, 1U << r, 0, minors_face(d, &v[side], r), lane_of(INFINITY),
                                error * v[side].g[r], out);
            if (k > 0 && k <= minors_last_level(d, side))
                minors_list_level(d, side, &v[side], k,
                                  d.from_simplex ? minors_part_from_simplex(d, k)
                                                 : minors_part_of(d, side, k),
                                  out);
        }
}

#endif
