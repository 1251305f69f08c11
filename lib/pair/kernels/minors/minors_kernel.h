/* minors_kernel.h: do two cuboids of four to eight dimensions meet? (Others: minors_signs.h,
 * minors_mixed.h.)
 *
 * Notation: z are coordinates in A's frame, where A is the cube |z_r| <= 1. B, swept from t = 0 to
 * t = 1, is center + sum x_j g_j, |x_j| <= 1; the n columns g_j are its D edges and, if it moves,
 * the drift. R is a set of k + 1 coordinates, S a set of k columns; (R, S) is the minor of S in R.
 *
 * Rows: eliminating x and the z outside R leaves a linear form y, with y_r = +-(R - r, S) for r in
 * R, and 0 elsewhere. By Cramer's rule y g_j = 0 for j in S, and y v = +-(R, S + v) for any other
 * vector v. The maximum of y over A is sum |y_r|, so y separates A and B iff
 *
 *     |(R, S + center)| > sum over r in R of |(R - r, S)| + sum over j not in S of |(R, S + j)|.
 *
 * Each minor is expanded along its last column into minors of one row and one column less. The
 * minors of a level k are stored by R, those of one R in the order of minors_table.h: all S whose
 * largest column is j are contiguous, in the order of the sets S - j.
 *
 * Completeness: the interiors of A and B meet unless a facet of the polytope B - A has 0 on it or
 * beyond it. Such a facet is parallel to D - 1 independent vectors: p edges of A, q edges of B and
 * perhaps the drift (d = 1, else 0). Its normal is a row of k = q + d in A's frame, and of k = p +
 * d in B's frame (with A and B exchanged). As (q + d) + (p + d) = D - 1 + d, the rows with k <= K
 * in A's frame and k <= K' in B's include every normal if K + K' + 2 > D - 1 + d. At rest K = (D -
 * 1) / 2 and K' = (D - 2) / 2, rounded down, and no normal is tested twice. If B moves, K = D / 2
 * and K' = (D - 1) / 2; rows of level K without the drift are rows of D - 1 - K <= K' columns, too.
 *
 * Errors: docs/error-bounds.md, "Minors".
 */
#ifndef FMB_PAIR_MINORS_KERNEL_H
#define FMB_PAIR_MINORS_KERNEL_H

#include "pair/kernels/minors/minors_mixed.h"
#include "pair/kernels/minors/minors_point.h"
#include "pair/kernels/minors/minors_signs.h"
#include "pair/kernels/minors/minors_whole.h"
#include "pair/kernels/open_rows.h"

/* The gap of a face of the frame whose coordinates are used; sets the sizes of entries. */
FMB_INLINE lane minors_face(minors_kind d, minors_view *v, int r)
{
    lane reach = v->unit, away = v->center[r], most = lane_of(1);
#pragma GCC unroll 8
    for (int j = d.from_cuboid ? d.dim : 0; j < d.n; j++) {
        const lane size = lane_abs(v->e[r * d.n + j]);
        reach = reach + size;
        if (d.from_simplex)
            most = lane_max(most, size);
        else
            v->size[r * d.n + j] = size;
    }
    if (d.from_simplex) {
        v->size[r] = lane_max(most, lane_abs(away) * lane_of(1.0 / (d.n + 3)));
        away = away - v->unit;
    }
    if (d.from_cuboid) {
        const minors_span corners = minors_span_of_corners(d, v->e + r * d.n);
        reach = reach + (corners.most - corners.least);
    }
    return lane_abs(away) - reach;
}
FMB_INLINE void minors_faces(minors_kind d, minors_view *v, minors_said *said)
{
    const lane error = lane_of(minors_error(d, 0) * 0x1p-53);
    for (int r = 0; r < minors_count_rows(d); r++)
        minors_hear(said, minors_face(d, v, r), error * v->g[r]);
}

/* The absolute value of a minor of this level, and of one of the level before; those of entries are
 * stored. */
FMB_INLINE lane minors_size(minors_part part, const lane *made, int s)
{
    return part == MINORS_KEPT ? lane_abs(made[s]) : made[s];
}
FMB_INLINE lane minors_size_less(minors_kind d, const minors_view *v, int k,
                                 const minors_rows *rows, int i, int s)
{
    return k == 1 ? v->size[rows->row[k - i] * d.n + s] : lane_abs(rows->less[i][s]);
}

/* The gap of the row of these coordinates and of columns s; `factor`: the center in them. */
FMB_INLINE lane minors_gap(minors_kind d, const minors_view *v, int k, minors_part part,
                           const minors_rows *rows, const lane *factor, const lane *made, int s)
{
    lane away = minors_expand(k, factor, rows->less, s), wide;
    lane reach = minors_size(part, made, minors_with(k, s, 0));
    if (d.from_simplex) {
        const minors_span span = minors_span_of_row(k, rows, s);
        away = lane_fnma(span.most + span.least, v->unit, away);
        wide = span.most - span.least;
    } else {
        wide = minors_size_less(d, v, k, rows, 0, s);
#pragma GCC unroll 4
        for (int i = 1; i <= k; i++)
            wide = wide + minors_size_less(d, v, k, rows, i, s);
    }
#pragma GCC unroll 8
    for (int j = 1; j < d.n - k; j++)
        reach = reach + minors_size(part, made, minors_with(k, s, j));
    return lane_abs(away) - lane_fma(wide, v->unit, reach);
}

/* The largest gap of these rows. */
FMB_INLINE lane minors_largest_gap(minors_kind d, const minors_view *v, int k, minors_part part,
                                   const minors_rows *rows, const lane *made)
{
    const int first = part == MINORS_DRIFTED ? fmb_minors_choose(d.n - 1, k) : 0;
    lane most = lane_of(-INFINITY), factor[5];
#pragma GCC unroll 5
    for (int i = 0; i <= k; i++)
        factor[i] = v->center[rows->row[i]];
    MINORS_UNROLL
    for (int s = first; s < fmb_minors_choose(d.n, k); s++)
        most = lane_max(most, minors_gap(d, v, k, part, rows, factor, made, s));
    return most;
}

/* The rows of k columns in one set of coordinates; minors that are kept go to `made`. */
FMB_INLINE void minors_hear_rows(minors_kind d, const minors_view *v, int k, minors_part part,
                                 unsigned set, minors_complements *turned, lane *made,
                                 minors_said *said)
{
    minors_rows rows;
    lane own[75]; /* choose(8, 4), and what stands behind */
    lane *to = part == MINORS_KEPT ? made : own;
    minors_find_rows(d, v, k, set, &rows);
    if (d.simplices) {
        minors_test_rows(d, v, k, part, &rows, minors_find_target(d, k, set, turned), to, said);
        return;
    }
    minors_make(d, v, k, part, &rows, to);
    lane error = lane_of(minors_error(d, k) * 0x1p-53) * rows.g;
    minors_hear(said, minors_largest_gap(d, v, k, part, &rows, to), error);
}

/* The rows of k columns; of simplices signs are put to `turned`, too, unless that is NULL. True:
 * all lanes are apart. For four columns the loop is fully unrolled, and minors stay in registers;
 * for more that would not fit the instruction cache. */
FMB_INLINE bool minors_level(minors_kind d, minors_view *v, int k, minors_part part,
                             minors_complements *turned, minors_said *said)
{
    const int kept = part == MINORS_KEPT ? minors_stride(d, k + 1) : 0;
    const unsigned first = (2U << k) - 1, end = 1U << minors_count_rows(d);
    lane *made = v->to;
    if (d.n == 4 && d.dim == minors_count_rows(d)) {
#pragma GCC unroll 16
        for (unsigned set = first; set < 16; set++)
            if (fmb_minors_count(set) == k + 1) {
                minors_hear_rows(d, v, k, part, set, turned, made, said);
                made += kept;
            }
        if (minors_all_apart(said))
            return true;
    } else {
        for (unsigned set = first; set < end; set = minors_next_set(set)) {
            minors_hear_rows(d, v, k, part, set, turned, made, said);
            if (minors_all_apart(said))
                return true;
            made += kept;
        }
    }
    v->from = v->to;
    v->to = made;
    return false;
}

/* ---- two records ----------------------------------------------------------------------------- */

/* Frame b in coordinates of a; `shift` and `drift`: differences of their origins and speeds. */
FMB_INLINE void minors_look(minors_kind d, const lane *a, const lane *b, const lane *shift,
                            const lane *drift, lane most, lane *room, minors_view *v)
{
    const lane *inverse = a + d.dim * (d.dim + 2), *reach = a + 2 * d.dim * (d.dim + 1);
    MINORS_UNROLL_ROWS
    for (int r = 0; r < d.dim; r++) {
        lane *e = v->e + r * d.n;
        lane sum = e[0] = minors_coordinate(d, inverse, r, b + d.dim);
#pragma GCC unroll 8
        for (int j = 1; j < d.dim; j++)
            sum = sum + (e[j] = minors_coordinate(d, inverse, r, b + d.dim + d.dim * j));
        if (d.from_cuboid) {
            const minors_span corners = minors_span_of_corners(d, e);
            sum = corners.most + corners.least;
        }
        if (d.n > d.dim)
            sum = sum + (e[d.dim] = minors_coordinate(d, inverse, r, drift));
        if (!d.from_simplex)
            sum = sum - lane_of(1);
        v->center[r] = lane_fma(lane_of(2), minors_coordinate(d, inverse, r, shift), sum);
        v->g[r] = lane_max(lane_of(1), reach[r] * most);
    }
    v->unit = lane_of(1);
    if (d.from_simplex)
        minors_add_last_barycentric(d, v);
    v->from = v->e;
    v->to = room;
}

/* The mask of lanes whose bounds are so small that no product of five overflows. */
FMB_INLINE lane_mask minors_known(minors_kind d, const minors_view *v)
{
    lane most = v->g[0];
    for (int r = 1; r < minors_count_rows(d); r++)
        most = lane_max(most, v->g[r]);
    return lane_less(most, lane_of(0x1p200));
}

/* The largest of the sizes of differences, and `size`. */
FMB_INLINE lane minors_most(minors_kind d, const lane *shift, const lane *drift, lane size)
{
    for (int j = 0; j < d.dim; j++)
        size = lane_max_abs(size, shift[j]);
    for (int j = 0; j < d.dim && d.moves; j++)
        size = lane_max_abs(size, drift[j]);
    return size;
}

/* Which part of level k is needed for a side. */
FMB_INLINE minors_part minors_part_of(minors_kind d, int side, int k)
{
    return k < (d.n - 1 - side) / 2 ? MINORS_KEPT
           : d.moves && side == 0   ? MINORS_DRIFTED
                                    : MINORS_LAST;
}

/* The last level of a cuboid seen from a simplex, and the part of level k that is needed. */
FMB_INLINE int minors_last_from_simplex(minors_kind d)
{
    return d.dim - 2 + d.moves;
}
FMB_INLINE minors_part minors_part_from_simplex(minors_kind d, int k)
{
    return k < minors_last_from_simplex(d) ? MINORS_KEPT : d.moves ? MINORS_DRIFTED : MINORS_LAST;
}

/* The open lanes, if there are no more than `few`, or 0. */
FMB_INLINE unsigned minors_few_open(const minors_said *said, int few)
{
    const unsigned all = (1U << FMB_LANES) - 1, open = all & ~minors_bits(said).apart;
    return __builtin_popcount(open) <= few ? open : 0;
}

/* All rows except faces of a cuboid seen from a simplex: minors_mixed.h. Returns the lanes that are
 * open where it stops as these are few, else 0. */
FMB_INLINE unsigned minors_levels_from_simplex(minors_kind d, minors_view *v, int few,
                                               minors_said *said)
{
    const int last = minors_last_from_simplex(d);
    unsigned open = 0;
#pragma GCC unroll 4
    for (int k = 1; k <= last; k++) {
        if (minors_level(d, v, k, minors_part_from_simplex(d, k), NULL, said))
            return 0;
        if (k < last && (open = minors_few_open(said, few)) != 0)
            return open;
    }
    return 0;
}

/* The last levels of both sides, of two simplices at rest: minors of B's view, which are smaller,
 * tell A's. */
FMB_INLINE void minors_last_levels(minors_kind d, minors_view v[2], minors_said *said)
{
    const int of_a = (d.n - 1) / 2, of_b = (d.n - 2) / 2;
    minors_complements turned;
    minors_no_complements(d, of_a, &turned);
    if (minors_level(d, &v[1], of_b, MINORS_LAST, &turned, said))
        return;
    for (unsigned set = (2U << of_a) - 1; set < 1U << d.n && !minors_all_apart(said);
         set = minors_next_set(set)) {
        minors_rows rows;
        minors_find_rows(d, &v[0], of_a, set, &rows);
        minors_test_complements(d, of_a, of_b, set, &rows, &turned, said);
    }
}

/* All rows except faces. Levels that both sides need are compiled once, where that is no loss: see
 * minors_level. Returns the lanes that are open where it stops as these are few, else 0. */
FMB_INLINE unsigned minors_levels(minors_kind d, minors_view v[2], int few, minors_said *said)
{
    const bool turns = d.simplices && !d.moves;
    const int last = (d.n - 1) / 2 - turns, last_of_b = (d.n - 2) / 2 - turns;
    unsigned open = 0;
#pragma GCC unroll 3
    for (int k = 1; k <= last; k++) {
        const bool both = k <= last_of_b;
        const minors_part part[2] = {minors_part_of(d, 0, k), minors_part_of(d, 1, k)};
        if (both && part[0] == part[1] && d.n > 4) {
            for (int side = 0; side < 2; side++)
                if (minors_level(d, &v[side], k, part[0], NULL, said))
                    return 0;
        } else if (minors_level(d, &v[0], k, part[0], NULL, said) ||
                   (both && minors_level(d, &v[1], k, part[1], NULL, said))) {
            return 0;
        }
        if (k < last + turns && (open = minors_few_open(said, few)) != 0)
            return open;
    }
    if (turns)
        minors_last_levels(d, v, said);
    return 0;
}

/* The kinds of questions. */
typedef enum minors_how {
    MINORS_AT_0, /* rows; of moving simplices those at t = 0 */
    MINORS_AT_1,
    MINORS_WHOLE, /* likewise, only lanes of integers */
    MINORS_POINT, /* is there a point in both? */
    MINORS_OPEN   /* which rows are open? */
} minors_how;
typedef void minors_lister(int dim, int what, minors_view v[2], fmb_open_rows *out);
typedef struct minors_asked {
    minors_how how;
    unsigned lanes; /* for MINORS_POINT: lanes to decide */
    minors_lister *list;
    fmb_open_rows *rows; /* receives the open rows, from `list` */
    int few;             /* stop early where no more lanes than that are open; 0: never */
} minors_asked;

/* The view of frame `to` from `from`, with memory for its minors, and the tests of faces. For a
 * cuboid and a simplex only the view from the simplex needs memory, and has all of it. */
FMB_INLINE void minors_see(minors_kind d, minors_how how, const lane *from, const lane *to,
                           lane *room, minors_view *v, minors_said *said)
{
    const int speed = d.dim * (d.dim + 1), size = d.dim * (2 * d.dim + 3);
    lane shift[FMB_MINORS_MOST_DIM], drift[FMB_MINORS_MOST_DIM];
    for (int j = 0; j < d.dim; j++) {
        shift[j] = to[j] - from[j];
        if (d.moves)
            drift[j] = to[speed + j] - from[speed + j];
        if (d.simplices && d.moves && how == MINORS_AT_1) {
            shift[j] = shift[j] + drift[j];
            drift[j] = lane_of(0) - drift[j];
        }
    }
    lane most = minors_most(d, shift, drift, to[size]);
    if (d.simplices)
        minors_look_at_corners(d, from, to, shift, drift, most, room, v);
    else
        minors_look(d, from, to, shift, drift, most, room, v);
    said->known = lane_and(said->known, minors_known(d, v));
    if (!d.simplices && how == MINORS_WHOLE)
        said->known = lane_and(said->known, minors_round(d, from + size, to + size, v));
    if (d.simplices)
        minors_corners(d, v, said);
    else
        minors_faces(d, v, said);
}

/* Are further tests of these lanes useless: all are apart, or none is known? */
FMB_INLINE bool minors_is_over(minors_kind d, minors_how how, const minors_said *said)
{
    return minors_all_apart(said) ||
           (!d.simplices && how == MINORS_WHOLE && !lane_bits(said->known));
}

/* Decide lanes of records a and b; room as in minors_kernels.h. Returns, for MINORS_POINT, the
 * lanes that a common point proves to meet, else those that are open where it stops early, or 0. */
FMB_INLINE unsigned minors_ask(minors_kind d, const minors_asked *x, const lane *a, const lane *b,
                               double *room, minors_said *out)
{
    const size_t half = fmb_minors_room(d.dim) / FMB_BLOCK_MOST_LANES / 2;
    minors_view v[2];
    minors_said said = {out->apart, out->meet, out->known};
    unsigned open = 0;
    minors_see(minors_side(d, 0), x->how, a, b, (lane *)room, &v[0], &said);
    if (x->how == MINORS_POINT)
        return minors_find_point(d, &v[0], x->lanes);
    if (!minors_is_over(d, x->how, &said))
        minors_see(minors_side(d, 1), x->how, b, a, (lane *)room + half, &v[1], &said);
    if (x->how == MINORS_OPEN) {
        const int shapes = d.simplices      ? FMB_MINORS_SIMPLICES
                           : d.from_simplex ? FMB_MINORS_MIXED
                                            : 0;
        x->list(d.dim, shapes + d.moves, v, x->rows);
        return 0;
    }
    if (!minors_is_over(d, x->how, &said)) {
        if (d.from_simplex)
            open = minors_levels_from_simplex(d, &v[0], x->few, &said);
        else
            open = minors_levels(d, v, x->few, &said);
    }
    out->apart = said.apart;
    out->meet = said.meet;
    out->known = said.known;
    return open;
}

#endif
