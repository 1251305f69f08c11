/* minors_inverse.h: the inverses of records (minors_kernels.h), of FMB_LANES records at a time.
 *
 * The axes are scaled by a power of two first, such that the largest number is in [1/2, 1). With V
 * an approximate inverse and the residual R = 1 - A V, computed as if in twice the precision, V + V
 * R is a better one. At the end, A^-1 - V = A^-1 R: if no number of R is greater than 2^-60, a row
 * of this sums to at most 8 2^-60 times the sum of absolute values of that row of A^-1; rounding V
 * to doubles adds at most u of that, so 2 u are enough. R itself: V, the sum of two doubles, has no
 * number above 2^30, and A none above 1. So each of eight sums splits off an error of at most 9
 * 2^30 u, and the rest of each product is at most 2^31 u. These are added up with less than 11 + 11
 * + 88 roundings of 2^30 u each time, an error of less than 8 110 2^30 u^2 < 2^-66; and what
 * underflows is less than 2^-1000. So computed numbers of R up to 2^-61 will do. A regular R also
 * proves that A is regular.
 *
 * A row of V times the edge with the largest number, less than 1 each, has to give 0 or 1; summed
 * over the edges, a row of V has sum at least 1. So once scaled back, by at most 2^300 and one
 * more, what underflows in the inverse is 2^-750 of reach.
 *
 * Sign of the determinant: the pivots are those of A + E. No number exceeds 2^7 1.01 in elimination
 * with row exchanges, where factors are at most 1 + 3 u; so each of seven updates of a number is
 * off by at most 4 2^7 u, and a row of E sums to less than 8 7 4 2^7 1.01 u < 2^15 u. A row of A^-1
 * sums to at most 8 2^30 1.01. So the norm of A^-1 E is less than 2^-4, and A + t E is regular for
 * all t from 0 to 1: both determinants have the same sign. Where it is negative two axes are
 * exchanged: all axes in records turn the same way.
 *
 * Source: Ogita, Rump, Oishi 2005, Accurate sum and dot product (residuals).
 */
#ifndef FMB_PAIR_MINORS_INVERSE_H
#define FMB_PAIR_MINORS_INVERSE_H

#include "pair/kernels/lane/error_free.h"
#include "pair/kernels/minors_kernels.h"

/* All numbers of a frame are smaller, and the largest of its axes is larger. */
#define MINORS_LARGEST 0x1p300
#define MINORS_LEAST   0x1p-300
/* All numbers of a scaled inverse are smaller, and those of its residual. */
#define MINORS_STEEPEST 0x1p30
#define MINORS_CLEAN    0x1p-61

enum { MINORS_SQUARE = (int)FMB_MINORS_MOST_DIM * (int)FMB_MINORS_MOST_DIM };

/* The axes of a lane are the columns of a, row by row; v is the inverse hi + lo. */
typedef struct minors_inversion {
    int n;
    lane a[MINORS_SQUARE], hi[MINORS_SQUARE], lo[MINORS_SQUARE], residual[MINORS_SQUARE];
    lane det; /* approximately the determinant of a */
} minors_inversion;

/* False for NaN. */
static lane_mask minors_is_below(lane a, double most)
{
    return lane_less(lane_abs(a), lane_of(most));
}

/* The largest absolute value of n numbers. */
static lane minors_largest(const lane *x, int n)
{
    lane most = lane_of(0);
    for (int i = 0; i < n; i++)
        most = lane_max_abs(most, x[i]);
    return most;
}

/* 2^-p, with 2^(p - 1) <= size < 2^p, of a size between 2^-300 and 2^300. */
static lane minors_scale_of(lane size)
{
    const lane_word exponent = LANE_WORD(size) >> 52;
    return LANE_OF_WORD((2045 - exponent) << 52);
}

/* ---- a first guess --------------------------------------------------------------------------- */

/* Exchange n numbers of two rows in some lanes. */
static void minors_exchange(lane_mask where, lane *a, lane *b, int n)
{
    for (int j = 0; j < n; j++) {
        lane first = lane_pick(where, b[j], a[j]);
        b[j] = lane_pick(where, a[j], b[j]);
        a[j] = first;
    }
}

/* Gauss-Jordan elimination with row exchanges: fills hi and det. Returns the lanes without a pivot
 * next to 0. */
static lane_mask minors_guess_inverse(minors_inversion *w)
{
    const int n = w->n;
    lane x[MINORS_SQUARE], *v = w->hi, over[FMB_MINORS_MOST_DIM];
    lane_mask good = lane_less(lane_of(0), lane_of(1));
    w->det = lane_of(1);
    for (int i = 0; i < n * n; i++) {
        x[i] = w->a[i];
        v[i] = lane_of(i % (n + 1) == 0);
    }
    for (int c = 0; c < n; c++) {
        for (int r = c + 1; r < n; r++) {
            lane_mask larger = lane_less(lane_abs(x[c * n + c]), lane_abs(x[r * n + c]));
            if (lane_bits(larger) == 0)
                continue;
            minors_exchange(larger, x + c * n + c, x + r * n + c, n - c);
            minors_exchange(larger, v + c * n, v + r * n, n);
            w->det = lane_pick(larger, lane_of(0) - w->det, w->det);
        }
        good = lane_and(good, lane_less(lane_of(MINORS_LEAST), lane_abs(x[c * n + c])));
        w->det = w->det * x[c * n + c];
        over[c] = lane_of(1) / x[c * n + c];
        for (int r = 0; r < n; r++) {
            if (r == c)
                continue;
            lane factor = x[r * n + c] * over[c];
            for (int j = c + 1; j < n; j++)
                x[r * n + j] = lane_fnma(factor, x[c * n + j], x[r * n + j]);
            for (int j = 0; j < n; j++)
                v[r * n + j] = lane_fnma(factor, v[c * n + j], v[r * n + j]);
        }
    }
    for (int i = 0; i < n * n; i++)
        v[i] = v[i] * over[i / n];
    return good;
}

/* ---- a better one ---------------------------------------------------------------------------- */

/* One number of 1 - a v. */
static lane minors_residual_at(const minors_inversion *w, int r, int c)
{
    lane sum = lane_of(r == c), rest = lane_of(0);
    for (int k = 0; k < w->n; k++) {
        lane a = w->a[r * w->n + k];
        lane2 product = two_product(a, w->hi[k * w->n + c]);
        lane2 next = two_sum(sum, -product.hi);
        rest = rest + (next.lo - lane_fma(a, w->lo[k * w->n + c], product.lo));
        sum = next.hi;
    }
    return sum + rest;
}

/* hi + lo + hi residual, rounded to two doubles, in the lanes that are open. */
static void minors_improve(minors_inversion *w, lane_mask open)
{
    const int n = w->n;
    lane v[MINORS_SQUARE];
    for (int i = 0; i < n * n; i++)
        v[i] = w->hi[i];
    for (int i = 0; i < n * n; i++) {
        lane more = w->lo[i];
        for (int k = 0; k < n; k++)
            more = lane_fma(v[i / n * n + k], w->residual[k * n + i % n], more);
        lane2 next = two_sum(v[i], more);
        w->hi[i] = lane_pick(open, next.hi, w->hi[i]);
        w->lo[i] = lane_pick(open, next.lo, w->lo[i]);
    }
}

/* Fills hi. Returns the lanes where it is as accurate as inverse.h says. */
static unsigned minors_find_inverse(minors_inversion *w)
{
    enum { STEPS = 4 };
    lane_mask open = minors_guess_inverse(w);
    unsigned clean = 0;
    for (int i = 0; i < w->n * w->n; i++)
        w->lo[i] = lane_of(0);
    for (int step = 0; step < STEPS; step++) {
        for (int i = 0; i < w->n * w->n; i++)
            w->residual[i] = minors_residual_at(w, i / w->n, i % w->n);
        open = lane_and(open, minors_is_below(minors_largest(w->hi, w->n * w->n), MINORS_STEEPEST));
        lane off = minors_largest(w->residual, w->n * w->n);
        clean |= lane_bits(lane_and(open, lane_less(off, lane_of(MINORS_CLEAN))));
        open = lane_and(open, lane_less(lane_of(MINORS_CLEAN), off));
        if (lane_bits(open) == 0)
            break;
        minors_improve(w, open);
    }
    return clean;
}

/* ---- records --------------------------------------------------------------------------------- */

/* Lanes whose frames have no number that is too large; NaN is. */
static lane_mask minors_have_good_numbers(int dim, const lane *record)
{
    lane_mask good = lane_less(lane_of(0), lane_of(1));
    for (int i = 0; i < dim * (dim + 2); i++)
        good = lane_and(good, minors_is_below(record[i], MINORS_LARGEST));
    return good;
}

/* Exchange the first two axes in some lanes. */
static void minors_turn_record(int dim, lane_mask where, lane *record)
{
    lane *axes = record + dim, *inverse = record + dim * (dim + 2);
    lane *reach = record + 2 * dim * (dim + 1);
    minors_exchange(where, axes, axes + dim, dim);
    minors_exchange(where, inverse, inverse + dim, dim);
    minors_exchange(where, reach, reach + 1, 1);
}

/* Fill in inverse, reach and size from origin, axes and speed, and the determinant of the scaled
 * axes in place of whole. Returns the lanes that are good. */
static unsigned minors_fill_records(int dim, lane *record)
{
    minors_inversion w;
    lane *to = record + dim * (dim + 2), *reach = record + 2 * dim * (dim + 1);
    lane size = minors_largest(record + dim, dim * dim);
    lane_mask good =
        lane_and(minors_have_good_numbers(dim, record), lane_less(lane_of(MINORS_LEAST), size));
    lane scale = minors_scale_of(lane_pick(good, size, lane_of(1)));
    w.n = dim;
    for (int i = 0; i < dim * dim; i++)
        w.a[i] = record[dim + i % dim * dim + i / dim] * scale;
    unsigned clean = minors_find_inverse(&w);
    for (int r = 0; r < dim; r++) {
        lane sum = lane_of(0);
        for (int j = 0; j < dim; j++) {
            lane x = to[r * dim + j] = w.hi[r * dim + j] * scale;
            sum = sum + lane_abs(x);
        }
        reach[r] = sum * lane_of(1 + 0x1p-48);
    }
    record[dim * (2 * dim + 3)] = size;
    record[dim * (2 * dim + 3) + 1] = lane_abs(w.det);
    minors_turn_record(dim, lane_less(w.det, lane_of(0)), record);
    return clean & lane_bits(good);
}

#endif
