/* minors_rows.h: minors of one order, expanded into minors with a row and a column less. */
#ifndef FMB_PAIR_MINORS_ROWS_H
#define FMB_PAIR_MINORS_ROWS_H

#include "pair/kernels/minors/minors_view.h"

/* Row r of the inverse at `inverse`, times x. */
FMB_INLINE lane minors_coordinate(minors_kind d, const lane *inverse, int r, const lane *x)
{
    lane sum = inverse[r * d.dim] * x[0];
#pragma GCC unroll 8
    for (int k = 1; k < d.dim; k++)
        sum = lane_fma(inverse[r * d.dim + k], x[k], sum);
    return sum;
}

/* The last barycentric coordinate of each column, and its bound: for corners of a simplex all
 * coordinates sum to 1, for edges and drifts to 0. */
FMB_INLINE void minors_add_last_row(minors_kind d, minors_view *v)
{
    const int row = minors_stride(d, 1);
    v->g[d.dim] = lane_of(1);
#pragma GCC unroll 8
    for (int r = 0; r < d.dim; r++)
        v->g[d.dim] = v->g[d.dim] + v->g[r];
#pragma GCC unroll 8
    for (int j = 0; j < d.n; j++) {
        lane last = lane_of(d.simplices && j <= d.dim);
#pragma GCC unroll 8
        for (int r = 0; r < d.dim; r++)
            last = last - v->e[r * row + j];
        v->e[d.dim * row + j] = last;
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

/* The number of the set S plus the j-th element not in S. */
FMB_INLINE int minors_with(int k, int s, int j)
{
    return k == 1   ? FMB_MINORS_WITH_1[s][j]
           : k == 2 ? FMB_MINORS_WITH_2[s][j]
           : k == 3 ? FMB_MINORS_WITH_3[s][j]
                    : FMB_MINORS_WITH_4[s][j];
}

/* The k + 1 rows of a set R, less[i]: the minors of the level before in R without the i-th row, and
 * the bound g of the minors in R: the product of the bounds of the rows, or for a view from a
 * simplex the largest product of the bound of one row and the sizes of the others. */
typedef struct minors_rows {
    int row[5];
    const lane *less[5];
    lane g;
} minors_rows;

FMB_INLINE void minors_find_rows(minors_kind d, const minors_view *v, int k, unsigned set,
                                 minors_rows *out)
{
    unsigned left = set;
    lane size = out->g = lane_of(1);
#pragma GCC unroll 5
    for (int i = 0; i <= k; i++, left &= left - 1) {
        out->row[i] = __builtin_ctz(left);
        out->less[i] = v->from + FMB_MINORS_RANK[set & ~(1U << out->row[i])] * minors_stride(d, k);
        if (d.simplices || d.from_simplex) {
            out->g = i == 0 ? v->g[out->row[0]]
                            : lane_max(out->g * v->size[out->row[i]], size * v->g[out->row[i]]);
            size = size * v->size[out->row[i]];
        } else {
            out->g = out->g * v->g[out->row[i]];
        }
    }
}

/* Which part of a level is needed. */
typedef enum minors_part {
    MINORS_KEPT,   /* all rows; their minors are kept for the next level */
    MINORS_LAST,   /* all rows */
    MINORS_DRIFTED /* the rows with the drift, the last column */
} minors_part;

/* Compute the minors of these rows; only their absolute values, unless part is MINORS_KEPT. */
FMB_INLINE void minors_make(minors_kind d, const minors_view *v, int k, minors_part part,
                            const minors_rows *rows, lane *to)
{
    const int first = part == MINORS_DRIFTED ? d.n - 1 : k;
    lane factor[5];
#pragma GCC unroll 8
    for (int j = first; j < d.n; j++) {
        lane *at = to + fmb_minors_choose(j, k + 1);
#pragma GCC unroll 4
        for (int i = 0; i <= k; i++)
            factor[i] = v->e[rows->row[i] * d.n + j];
        for (int s = 0; s < fmb_minors_choose(j, k); s++)
            at[s] = part == MINORS_KEPT ? minors_expand(k, factor, rows->less, s)
                                        : lane_abs(minors_expand(k, factor, rows->less, s));
    }
}

/* Before the loop over sets of columns, choose(8, 3) of them at most, whose numbers are then
 * constant: a fifth faster from six columns on. It is not worth its compilation where lanes are
 * few. */
#if FMB_LANES >= 4
#define MINORS_UNROLL _Pragma("GCC unroll 64")
#else
#define MINORS_UNROLL
#endif

/* Before the loop over rows of coordinates: in pieces it is up to an eighth slower where lanes are
 * eight and all are apart, and elsewhere not. */
#if FMB_LANES == 8
#define MINORS_UNROLL_ROWS _Pragma("GCC unroll 8")
#else
#define MINORS_UNROLL_ROWS
#endif

/* The next set of the same size. */
FMB_INLINE unsigned minors_next_set(unsigned set)
{
    unsigned low = set & -set, carry = set + low;
    return carry | (set ^ carry) >> (2 + __builtin_ctz(low));
}

#endif
