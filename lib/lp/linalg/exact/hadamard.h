/* hadamard.h: bounds on the length of determinants. */
#ifndef FMB_LP_HADAMARD_H
#define FMB_LP_HADAMARD_H

#include "lp/model/row.h"

/* log2 of Hadamard's bound on the minors of n columns column[n] of the rows index[n] and row i: the
 * product of the columns' lengths. Numbers may have any size; no column is 0 in all these rows. */
double fmb_hadamard_bits(const fmb_lp_row *row, size_t i, size_t n, const size_t *index,
                         const size_t *column);

#endif
