/* hadamard.c: see hadamard.h.
 *
 * Entries of a column are scaled by the longest one, as squares of long ones exceed doubles. Then
 * the sum of squares is at least 1/4, and underflow in it is less than its rounding error.
 */
#include "lp/linalg/exact/hadamard.h"

#include <math.h>

/* The bits of the longest entry of a column in the rows. */
static size_t longest_entry(const fmb_lp_row *row, size_t i, size_t n, const size_t *index,
                            size_t column)
{
    size_t most = fmb_vec_entry_bits(row[i].v, column);
    for (size_t k = 0; k < n; k++) {
        size_t bits = fmb_vec_entry_bits(row[index[k]].v, column);
        most = bits > most ? bits : most;
    }
    return most;
}

/* The square of an entry times 2^-most. */
static double squared_entry(const fmb_vec *v, size_t column, size_t most)
{
    long exponent = 0;
    double a = v->z ? mpz_get_d_2exp(&exponent, v->z[column]) : (double)v->s[column];
    long shift = exponent - (long)most < -2000 ? -2000 : exponent - (long)most;
    a = ldexp(a, (int)shift);
    return a * a;
}

double fmb_hadamard_bits(const fmb_lp_row *row, size_t i, size_t n, const size_t *index,
                         const size_t *column)
{
    double bits = 0;
    for (size_t e = 0; e < n; e++) {
        size_t most = longest_entry(row, i, n, index, column[e]);
        double square = squared_entry(row[i].v, column[e], most);
        for (size_t k = 0; k < n; k++)
            square += squared_entry(row[index[k]].v, column[e], most);
        bits += (double)most + log2(square) / 2;
    }
    return bits;
}
