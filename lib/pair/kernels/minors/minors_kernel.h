/* minors_kernel.h: do two cuboids of four to eight dimensions meet?
 *
 * In coordinates z of A's frame, A is |z_r| <= 1, and B, with all its places from t = 0 to 1, is
 * center + sum x_j g_j, |x_j| <= 1, over its D edges and, if it moves, the drift: n columns in all.
 * Eliminating x and D - 1 - k of the z leaves rows that use k columns S and speak of k + 1
 * coordinates R: by Cramer's rule their coefficients are the minors of the columns S in the rows R
 * but one, and what they say of center and of the other columns are the minors of R with one column
 * more. Such a row misses A iff
 *
 *     |minor of S, center| > sum over r of |minor of S in R less r|
 *                            + sum over j not in S of |minor of S, j|
 *
 * So all is made of minors, each from those with a row and a column less, by its last column. Those
 * of a level are in order of R, and for one R in that of minors_table.h: all sets whose largest
 * column is j stand in a row, and come from those of the columns before j in the same order.
 *
 * Complete: A and B meet in interiors unless a facet of B - A keeps 0 out. D - 1 independent
 * vectors are parallel to it, p edges of A, q of B, and perhaps the drift (d = 1, else 0): in A's
 * frame that is the row of these q + d columns, in B's frame (A and B change places) that of p + d
 * columns. The two numbers sum to D - 1 + d, so levels up to K there and up to K' here have them
 * all if K + K' + 2 > D - 1 + d.
 *
 * Errors: docs/error-bounds.md, "Minors".
 */
#ifndef FMB_PAIR_MINORS_KERNEL_H
#define FMB_PAIR_MINORS_KERNEL_H

#include "pair/kernels/minors/minors_said.h"
#include "pair/kernels/minors/minors_table.h"

/* What is constant in a kernel. */
typedef struct minors_kind {
    int dim, n; /* n columns */
} minors_kind;

/* One frame seen from another. */
typedef struct minors_view {
    lane e[FMB_MINORS_MOST_DIM * FMB_MINORS_MOST]; /* [row][column] */
    lane center[FMB_MINORS_MOST_DIM];
    lane g[FMB_MINORS_MOST_DIM]; /* bounds of a row: docs/error-bounds.md */
    const lane *from;            /* minors of the level before: [rows][columns] */
    lane *to;                    /* room for the next ones */
} minors_view;

/* How many u times the bounds of its rows the error of what a row of k columns says may be. */
FMB_INLINE double minors_error(minors_kind d, int k)
{
    const double entry = d.dim + 3, n = d.n;
    const double center = (n + 2) * entry + n * (n + 1) + 4;
    const double less = k == 0 ? 0 : k * entry + k * (k + 1) / 2 - 1;
    const double more = (k + 1) * entry + (k + 1) * (k + 2) / 2 - 1;
    const double factorial = k == 3 ? 24 : k == 2 ? 6 : k + 1;
    return 1.01 * factorial *
           (center + (n + 3) * (less + k + 1) + less + (n - k) * more + n * (n - k + 1) + n + 3);
}

/* The faces of the one that is looked from. */
FMB_INLINE void minors_faces(minors_kind d, const minors_view *v, minors_said *said)
{
    const lane error = lane_of(minors_error(d, 0) * 0x1p-53);
    for (int r = 0; r < d.dim; r++) {
        lane reach = lane_of(1);
#pragma GCC unroll 8
        for (int j = 0; j < d.n; j++)
            reach = reach + lane_abs(v->e[r * d.n + j]);
        minors_hear(said, lane_abs(v->center[r]) - reach, error * v->g[r]);
    }
}

/* sum (-1)^i factor[i] from[i][s] */
FMB_INLINE lane minors_expand(int k, const lane *factor, const lane *const *from, int s)
{
    lane sum = factor[0] * from[0][s];
#pragma GCC unroll 4
    for (int i = 1; i <= k; i++)
        sum = i % 2 ? lane_fnma(factor[i], from[i][s], sum) : lane_fma(factor[i], from[i][s], sum);
    return sum;
}

/* The number of S with the j-th that is not in it. */
FMB_INLINE int minors_with(int k, int s, int j)
{
    return k == 1   ? FMB_MINORS_WITH_1[s][j]
           : k == 2 ? FMB_MINORS_WITH_2[s][j]
                    : FMB_MINORS_WITH_3[s][j];
}

/* The k + 1 rows of a set, where their minors of the level before are, and the bound on them. */
typedef struct minors_rows {
    int row[4];
    const lane *less[4];
    lane g;
} minors_rows;

FMB_INLINE void minors_find_rows(minors_kind d, const minors_view *v, int k, unsigned set,
                                 minors_rows *out)
{
    unsigned left = set;
    out->g = lane_of(1);
#pragma GCC unroll 4
    for (int i = 0; i <= k; i++, left &= left - 1) {
        out->row[i] = __builtin_ctz(left);
        out->less[i] =
            v->from + FMB_MINORS_RANK[set & ~(1U << out->row[i])] * fmb_minors_choose(d.n, k);
        out->g = out->g * v->g[out->row[i]];
    }
}

/* The minors of these rows. */
FMB_INLINE void minors_make(minors_kind d, const minors_view *v, int k, const minors_rows *rows,
                            lane *to)
{
    lane factor[4];
#pragma GCC unroll 8
    for (int j = k; j < d.n; j++) {
        lane *at = to + fmb_minors_choose(j, k + 1);
#pragma GCC unroll 4
        for (int i = 0; i <= k; i++)
            factor[i] = v->e[rows->row[i] * d.n + j];
        for (int s = 0; s < fmb_minors_choose(j, k); s++)
            at[s] = minors_expand(k, factor, rows->less, s);
    }
}

/* The largest gap of these rows, all sets of columns. */
FMB_INLINE lane minors_gap(minors_kind d, const minors_view *v, int k, const minors_rows *rows,
                           const lane *made)
{
    lane most = lane_of(-INFINITY), factor[4];
#pragma GCC unroll 4
    for (int i = 0; i <= k; i++)
        factor[i] = v->center[rows->row[i]];
    for (int s = 0; s < fmb_minors_choose(d.n, k); s++) {
        lane away = lane_abs(minors_expand(k, factor, rows->less, s));
        lane wide = lane_abs(rows->less[0][s]), reach = lane_abs(made[minors_with(k, s, 0)]);
#pragma GCC unroll 4
        for (int i = 1; i <= k; i++)
            wide = wide + lane_abs(rows->less[i][s]);
#pragma GCC unroll 8
        for (int j = 1; j < d.n - k; j++)
            reach = reach + lane_abs(made[minors_with(k, s, j)]);
        most = lane_max(most, away - (wide + reach));
    }
    return most;
}

/* The rows of k columns; last: their minors are not wanted again. True: all lanes are apart. */
FMB_INLINE bool minors_level(minors_kind d, minors_view *v, int k, bool last, minors_said *said)
{
    const lane error = lane_of(minors_error(d, k) * 0x1p-53);
    lane *made = v->to;
    for (unsigned set = (2U << k) - 1; set < 1U << d.dim;) {
        minors_rows rows;
        minors_find_rows(d, v, k, set, &rows);
        minors_make(d, v, k, &rows, made);
        minors_hear(said, minors_gap(d, v, k, &rows, made), error * rows.g);
        if (minors_all_apart(said))
            return true;
        made += last ? 0 : fmb_minors_choose(d.n, k + 1);
        /* the next set of that size */
        unsigned low = set & -set, carry = set + low;
        set = carry | ((set ^ carry) >> (2 + __builtin_ctz(low)));
    }
    v->from = v->to;
    v->to = made;
    return false;
}

/* ---- two records ----------------------------------------------------------------------------- */

/* Row r of the inverse at `inverse`, times x. */
FMB_INLINE lane minors_coordinate(minors_kind d, const lane *inverse, int r, const lane *x)
{
    lane sum = inverse[r * d.dim] * x[0];
#pragma GCC unroll 8
    for (int k = 1; k < d.dim; k++)
        sum = lane_fma(inverse[r * d.dim + k], x[k], sum);
    return sum;
}

/* The frame b seen from a; apart from one another as `shift` and `drift` say. */
FMB_INLINE void minors_look(minors_kind d, const lane *a, const lane *b, const lane *shift,
                            const lane *drift, lane most, lane *room, minors_view *v)
{
    const lane *inverse = a + d.dim * (d.dim + 2), *reach = a + 2 * d.dim * (d.dim + 1);
#pragma GCC unroll 8
    for (int r = 0; r < d.dim; r++) {
        lane *e = v->e + r * d.n;
        lane sum = e[0] = minors_coordinate(d, inverse, r, b + d.dim);
#pragma GCC unroll 8
        for (int j = 1; j < d.dim; j++)
            sum = sum + (e[j] = minors_coordinate(d, inverse, r, b + d.dim + d.dim * j));
        if (d.n > d.dim)
            sum = sum + (e[d.dim] = minors_coordinate(d, inverse, r, drift));
        v->center[r] =
            lane_fma(lane_of(2), minors_coordinate(d, inverse, r, shift), sum - lane_of(1));
        v->g[r] = lane_max(lane_of(1), reach[r] * most);
    }
    v->from = v->e;
    v->to = room;
}

/* Lanes whose bounds are so small that no product of five overflows. */
FMB_INLINE lane_mask minors_known(minors_kind d, const minors_view *a, const minors_view *b)
{
    lane most = lane_max(a->g[0], b->g[0]);
    for (int r = 1; r < d.dim; r++)
        most = lane_max(most, lane_max(a->g[r], b->g[r]));
    return lane_less(most, lane_of(0x1p200));
}

/* The largest of the sizes of differences, and `size`. */
FMB_INLINE lane minors_most(minors_kind d, const lane *shift, const lane *drift, lane size)
{
    for (int j = 0; j < d.dim; j++)
        size = lane_max_abs(size, shift[j]);
    for (int j = 0; j < d.dim && d.n > d.dim; j++)
        size = lane_max_abs(size, drift[j]);
    return size;
}

/* Lanes of records a and b; room as in minors_kernels.h. */
FMB_INLINE fmb_pair_bits minors_ask(minors_kind d, const lane *a, const lane *b, double *room)
{
    const int moves = d.n > d.dim, speed = d.dim * (d.dim + 1), size = d.dim * (2 * d.dim + 3);
    lane shift[2][FMB_MINORS_MOST_DIM], drift[2][FMB_MINORS_MOST_DIM];
    minors_view v[2];
    minors_said said = {lane_of(-INFINITY), lane_of(-INFINITY), lane_less(lane_of(0), lane_of(1))};
    for (int j = 0; j < d.dim; j++) {
        shift[0][j] = b[j] - a[j];
        shift[1][j] = a[j] - b[j];
        if (moves) {
            drift[0][j] = b[speed + j] - a[speed + j];
            drift[1][j] = a[speed + j] - b[speed + j];
        }
    }
    lane most[2] = {minors_most(d, shift[0], drift[0], b[size]),
                    minors_most(d, shift[0], drift[0], a[size])};
    minors_look(d, a, b, shift[0], drift[0], most[0], (lane *)room, &v[0]);
    minors_look(d, b, a, shift[1], drift[1], most[1], (lane *)room, &v[1]);
    said.known = minors_known(d, &v[0], &v[1]);
    minors_faces(d, &v[0], &said);
    minors_faces(d, &v[1], &said);
    if (minors_all_apart(&said))
        return minors_bits(&said);
    for (int side = 0; side < 2; side++) {
        const int last = (d.dim - 1 - side + moves) / 2;
#pragma GCC unroll 3
        for (int k = 1; k <= last; k++)
            if (minors_level(d, &v[side], k, k == last, &said))
                return minors_bits(&said);
    }
    return minors_bits(&said);
}

#endif
