/* low_words.h: is a number of a basic solution exactly 0? Where frames touch, some basic unknown is
 * at an end of its place, which doubles cannot decide.
 *
 * By Cramer's rule each basic unknown times det P is a determinant of integers. Its lowest 128 bits
 * are sums of products of the lowest 128 bits of the entries; and an integer that doubles prove to
 * be less than 2^126 is 0 iff these bits are 0. So the length of the entries does not matter, and
 * nothing is divided.
 */
#ifndef FMB_PAIR_LOW_WORDS_H
#define FMB_PAIR_LOW_WORDS_H

#include "pair/exact_box/exact_box_program.h"

/* det P and det P times the basic unknowns, modulo 2^128. */
typedef struct fmb_exact_box_low {
    fmb_u128 det, x[FMB_EXACT_BOX_DIM];
    double most; /* an upper bound of |det P| */
} fmb_exact_box_low;

/* For P x = rest: column k of P is that of unknown basic[k] minus that of unknown reference[k],
 * unless this is -1; rest is h minus the columns of unknowns that are 1 (is_one). */
void fmb_exact_box_find_low(const fmb_exact_box_program *s, const int *basic, const int *reference,
                            const bool *is_one, fmb_exact_box_low *out);

/* Is a number of absolute value at most `size` exactly 0? bits: the lowest of det P times it.
 * False: it is not proved to be 0. */
static inline bool fmb_exact_box_is_low_zero(const fmb_exact_box_low *low, fmb_u128 bits,
                                             double size)
{
    return (fmb_u128_low(bits) | fmb_u128_high(bits)) == 0 && low->most * size < 0x1p126;
}

#endif
