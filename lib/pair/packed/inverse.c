/* inverse.c: see inverse.h.
 *
 * The axes are scaled by a power of two first, such that the largest number is in [1/2, 1). With V
 * an approximate inverse as double-doubles, and the residual R = 1 - A V computed likewise, V + V R
 * is a better one. At the end, A^-1 - V = A^-1 R: if no number of R is greater than 2^-60, a row of
 * this sums to at most 8 2^-60 times the sum of absolute values of that row of A^-1; rounding V to
 * doubles adds at most u of that, so 2 u are enough. R itself: V has no number above 2^30, so eight
 * products and nine sums of double-doubles err by less than 400 u^2 2^30 < 2^-62 (each by at most
 * 4 u^2 times the sum of the absolute values, none above 9 2^30), and what underflows by less than
 * 2^-1000. So computed numbers of R up to 2^-61 will do. A regular R also proves that A is regular.
 *
 * A row of V times the edge with the largest number, less than 1 each, has to give 0 or 1; summed
 * over the edges, a row of V has sum at least 1. So once scaled back, by at most 2^300 and one
 * more, what underflows in the inverse is 2^-750 of reach.
 */
#define FMB_LANES 1

#include "pair/packed/inverse.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "num/split_double.h"
#include "pair/kernels/lane/double_double.h"
#include "pair/kernels/minors_kernels.h"

enum { MOST = FMB_MINORS_MOST_DIM };

static const double LARGEST = 0x1p300, LEAST = 0x1p-300, STEEPEST = 0x1p30, CLEAN = 0x1p-61;

typedef struct square {
    int n;
    double x[MOST][MOST];
} square;

/* ---- a first guess --------------------------------------------------------------------------- */

typedef double twice_a_row[2 * MOST];

/* Move to place c the row, from c on, with the largest number in column c. */
static void bring_pivot(int n, int c, twice_a_row *x)
{
    twice_a_row row;
    int best = c;
    for (int r = c + 1; r < n; r++)
        best = fabs(x[r][c]) > fabs(x[best][c]) ? r : best;
    memcpy(row, x[c], sizeof row);
    memcpy(x[c], x[best], sizeof row);
    memcpy(x[best], row, sizeof row);
}

/* Gauss-Jordan elimination; *det: approximately |determinant|. False: a pivot is 0. */
static bool guess_inverse(const square *a, square *v, double *det)
{
    const int n = v->n = a->n;
    twice_a_row x[MOST] = {{0}};
    for (int r = 0; r < n; r++) {
        memcpy(x[r], a->x[r], (size_t)n * sizeof **x);
        x[r][n + r] = 1;
    }
    *det = 1;
    for (int c = 0; c < n; c++) {
        bring_pivot(n, c, x);
        if (!(fabs(x[c][c]) > LEAST))
            return false;
        *det *= fabs(x[c][c]);
        for (int r = 0; r < n; r++) {
            const double factor = r == c ? 0 : x[r][c] / x[c][c];
            for (int j = 0; j < 2 * n; j++)
                x[r][j] -= factor * x[c][j];
        }
    }
    for (int r = 0; r < n; r++)
        for (int j = 0; j < n; j++)
            v->x[r][j] = x[r][n + j] / x[r][r];
    return true;
}

/* ---- a better one ---------------------------------------------------------------------------- */

static double largest(const square *a)
{
    double most = 0;
    for (int r = 0; r < a->n; r++)
        for (int j = 0; j < a->n; j++)
            most = fabs(a->x[r][j]) > most ? fabs(a->x[r][j]) : most;
    return most;
}

/* 1 - a v, v = hi + lo; its largest absolute value. */
static double find_residual(const square *a, const square *hi, const square *lo, square *out)
{
    out->n = a->n;
    for (int r = 0; r < a->n; r++)
        for (int c = 0; c < a->n; c++) {
            lane2 sum = lane2_of(r == c);
            for (int k = 0; k < a->n; k++)
                sum = lane2_subtract(
                    true, sum,
                    lane2_times(true, lane2_of(a->x[r][k]), (lane2){hi->x[k][c], lo->x[k][c]}));
            out->x[r][c] = sum.hi;
        }
    return largest(out);
}

/* hi + lo + hi residual, as double-doubles */
static void improve(const square *residual, square *hi, square *lo)
{
    const square v = *hi;
    for (int r = 0; r < v.n; r++)
        for (int c = 0; c < v.n; c++) {
            double more = lo->x[r][c];
            for (int k = 0; k < v.n; k++)
                more += v.x[r][k] * residual->x[k][c];
            lane2 sum = two_sum(v.x[r][c], more);
            hi->x[r][c] = sum.hi;
            lo->x[r][c] = sum.lo;
        }
}

/* a has numbers in -1 ... 1. */
static bool find_inverse(const square *a, square *hi, double *det)
{
    enum { STEPS = 4 };
    square lo = {.n = a->n}, residual;
    if (!guess_inverse(a, hi, det))
        return false;
    for (int i = 0; i < STEPS; i++) {
        if (!(largest(hi) <= STEEPEST))
            return false;
        if (find_residual(a, hi, &lo, &residual) <= CLEAN)
            return true;
        improve(&residual, hi, &lo);
    }
    return false;
}

/* ---- without an error ----------------------------------------------------------------------- */

/* The largest power of two of which all of these are multiples, from `most` down to `least`. 0:
 * none is. */
static double find_grain(const double *x, int n, double most, double least)
{
    for (int i = 0; i < n && most >= least;)
        if (x[i] / most == rint(x[i] / most))
            i++;
        else
            most /= 2;
    return most >= least ? most : 0;
}

/* With v and det about the inverse and the absolute value of the determinant of a, whose numbers
 * are multiples of `grain`: is the whole number next to det / grain^n times grain^-1 a^-1 whole?
 * Then that number, else 0. No sum of absolute values is above 2^53, so none is rounded. */
static double find_whole(const square *a, const square *v, double grain, double det)
{
    det = rint(det / pow(grain, a->n));
    for (int r = 0; r < a->n; r++)
        for (int c = 0; c < a->n; c++) {
            double sum = r == c ? -det : 0, size = det;
            for (int j = 0; j < a->n; j++) {
                double term = rint(v->x[r][j] * grain * det) * (a->x[j][c] / grain);
                sum += term;
                size += fabs(term);
            }
            if (!(sum == 0 && size <= 0x1p53))
                return 0;
        }
    return det;
}

/* Write whole and grain after the size, if numbers have few bits; a, v and power as below. */
static void write_whole(const fmb_frame *f, const square *a, const square *v, double det, int power,
                        double *out)
{
    const double least = ldexp(0x1p-53, power);
    const double axes = find_grain(f->axes, f->dim * f->dim, ldexp(1, power), least);
    double grain = find_grain(f->origin, f->dim, axes, least);
    if (f->speed)
        grain = find_grain(f->speed, f->dim, grain, least);
    out[0] = grain > 0 ? axes * find_whole(a, v, ldexp(axes, -power), det) : 0;
    out[1] = out[0] > 0 ? grain : 0;
}

/* The exponent of the lowest bit that is set in any of these; `none` where all are 0. */
static int find_lowest_bit(const double *x, int n, int none)
{
    int low = INT_MAX;
    for (int i = 0; i < n; i++) {
        int e;
        if (fmb_split_double(x[i], &e) != 0 && e < low)
            low = e;
    }
    return low < INT_MAX ? low : none;
}

/* Units of axes and speed, and of the origin. */
static double find_units(const fmb_frame *f)
{
    const int high = 1024;
    int axes = find_lowest_bit(f->axes, f->dim * f->dim, high);
    const int speed = f->speed ? find_lowest_bit(f->speed, f->dim, high) : high;
    axes = speed < axes ? speed : axes;
    return fmb_minors_join_units(axes, find_lowest_bit(f->origin, f->dim, axes));
}

/* ---- records --------------------------------------------------------------------------------- */

static double largest_number(const double *x, int n)
{
    double most = 0;
    for (int i = 0; i < n; i++)
        most = fabs(x[i]) > most ? fabs(x[i]) : most;
    return most;
}

/* Write the inverse, scaled back, and upper bounds of its sums of absolute values. */
static void write_inverse(const square *v, int power, double *inverse, double *reach)
{
    for (int r = 0; r < v->n; r++) {
        double sum = 0;
        for (int j = 0; j < v->n; j++) {
            inverse[r * v->n + j] = ldexp(v->x[r][j], -power);
            sum += fabs(inverse[r * v->n + j]);
        }
        reach[r] = sum * (1 + 0x1p-48);
    }
}

bool fmb_inverse_record(const fmb_frame *f, double *record)
{
    const int dim = f->dim;
    const double size = largest_number(f->axes, dim * dim);
    int power;
    double det;
    square a = {.n = dim}, v;
    if (!(size >= LEAST && size <= LARGEST && largest_number(f->origin, dim) <= LARGEST) ||
        (f->speed && largest_number(f->speed, dim) > LARGEST))
        return false;
    frexp(size, &power);
    for (int i = 0; i < dim; i++)
        for (int j = 0; j < dim; j++)
            a.x[j][i] = ldexp(f->axes[i * dim + j], -power);
    if (!find_inverse(&a, &v, &det))
        return false;
    memset(record, 0, (size_t)fmb_minors_record(dim) * sizeof *record);
    memcpy(record, f->origin, (size_t)dim * sizeof *record);
    memcpy(record + dim, f->axes, (size_t)(dim * dim) * sizeof *record);
    if (f->speed)
        memcpy(record + dim * (dim + 1), f->speed, (size_t)dim * sizeof *record);
    write_inverse(&v, power, record + dim * (dim + 2), record + 2 * dim * (dim + 1));
    record[dim * (2 * dim + 3)] = size;
    write_whole(f, &a, &v, det, power, record + dim * (2 * dim + 3) + 1);
    record[dim * (2 * dim + 3) + 3] = find_units(f);
    return true;
}
