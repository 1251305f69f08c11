/* inverse.c: see inverse.h. */
#include "pair/kernels/inverse.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "num/split_double.h"

/* ---- without an error ----------------------------------------------------------------------- */

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

/* The largest power of two of which all of these are multiples, at most `most`, a power of two or
 * 0; 0 if it is less than `least`. */
static double find_grain(const double *x, int n, double most, double least)
{
    const int high = most > 0 ? ilogb(most) : 0, low = find_lowest_bit(x, n, high);
    const double grain = ldexp(1, low < high ? low : high);
    return most > 0 && grain >= least ? grain : 0;
}

/* With v and det about the inverse of the matrix with columns a and the absolute value of its
 * determinant, and all of a multiples of `grain`: is the whole number next to det / grain^n times
 * grain a^-1 whole? Then that number, else 0. No sum of absolute values is above 2^53, so none is
 * rounded. */
static double find_whole(int n, const double *a, const double *v, double grain, double det)
{
    for (int r = 0; r < n; r++)
        for (int c = 0; c < n; c++) {
            double sum = r == c ? -det : 0, size = det;
            for (int j = 0; j < n; j++) {
                double term = rint(v[r * n + j] * grain * det) * (a[c * n + j] / grain);
                sum += term;
                size += fabs(term);
            }
            if (!(sum == 0 && size <= 0x1p53))
                return 0;
        }
    return det;
}

/* ---- records --------------------------------------------------------------------------------- */

void fmb_inverse_write_frame(const fmb_frame *f, double *record)
{
    const size_t dim = (size_t)f->dim;
    memset(record, 0, (size_t)fmb_minors_record(f->dim) * sizeof *record);
    memcpy(record, f->origin, dim * sizeof *record);
    memcpy(record + dim, f->axes, dim * dim * sizeof *record);
    if (f->speed)
        memcpy(record + dim * (dim + 1), f->speed, dim * sizeof *record);
}

void fmb_inverse_write_units(int dim, double *record)
{
    double *whole = record + dim * (2 * dim + 3) + 1;
    const int high = 1024;
    int axes = find_lowest_bit(record + dim, dim * dim, high);
    const int speed = find_lowest_bit(record + dim * (dim + 1), dim, high);
    axes = speed < axes ? speed : axes;
    whole[0] = whole[1] = 0;
    whole[2] = fmb_minors_join_units(axes, find_lowest_bit(record, dim, axes));
}

void fmb_inverse_write_integers(int dim, double *record)
{
    const double *axes = record + dim, *inverse = record + dim * (dim + 2);
    double *whole = record + dim * (2 * dim + 3) + 1;
    const double det = whole[0];
    int power;
    frexp(record[dim * (2 * dim + 3)], &power);
    const double least = ldexp(0x1p-53, power);
    const double coarse = find_grain(axes, dim * dim, ldexp(1, power), least);
    double grain = find_grain(record, dim, coarse, least);
    grain = find_grain(record + dim * (dim + 1), dim, grain, least);
    fmb_inverse_write_units(dim, record);
    if (!(grain > 0))
        return;
    whole[0] = coarse *
               find_whole(dim, axes, inverse, coarse, rint(det / pow(ldexp(coarse, -power), dim)));
    whole[1] = whole[0] > 0 ? grain : 0;
}
