/* column_units.h: powers of two in which the entries of each column are about as long as those of
 * its rows.
 *
 * Least squares of logarithms, by turns for rows and columns. A row with one entry says nothing
 * about its column. Source: Curtis and Reid 1972, On the automatic scaling of matrices for Gaussian
 * elimination.
 */
#ifndef FMB_LP_COLUMN_UNITS_H
#define FMB_LP_COLUMN_UNITS_H

#include "trace/run.h"

/* Write columns and exponents of the nonzero entries of row i, at most n; returns their number. */
typedef size_t (*fmb_row_exponents)(const void *rows, size_t i, int *column, int *exponent);

/* unit[n] in: 0; out: 2^unit[j] fits column j of the m rows. run: whose limits hold, or NULL.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_column_units(fmb_mem *mem, fmb_run *run, size_t n, size_t m, fmb_row_exponents read,
                            const void *rows, int *unit);

#endif
