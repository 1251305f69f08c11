/* low_words.h: is a number of a basic solution exactly 0? Where frames touch some unknown is at an
 * end of its place, and doubles leave open whether it is there.
 *
 * By Cramer's rule each basic unknown, times det P, is a determinant of whole numbers. Of these the
 * lowest 128 bits are sums of products of the lowest 128 bits of the entries; and a whole number of
 * which doubles know that it is less than 2^126 is 0 iff those bits are. So it does not matter how
 * long the entries are, and nothing is divided.
 */
#ifndef FMB_PAIR_LOW_WORDS_H
#define FMB_PAIR_LOW_WORDS_H

#include "pair/exact_box/exact_box_program.h"

/* det P and det P times the basic unknowns, modulo 2^128. */
typedef struct fmb_exact_box_low {
    fmb_u128 det, x[FMB_EXACT_BOX_DIM];
    double most; /* |det P| is not larger */
} fmb_exact_box_low;

/* Of P x = rest: column k of P is that of unknown basic[k] less that of unknown reference[k], if
 * this is not -1; rest is h less the columns that count once. */
void fmb_exact_box_find_low(const fmb_exact_box_program *s, const int *basic, const int *reference,
                            const bool *is_one, fmb_exact_box_low *out);

/* Is a number exactly 0 that is not larger than `size`? bits: those of det P times that number.
 * False: they do not tell that it is. */
static inline bool fmb_exact_box_is_low_zero(const fmb_exact_box_low *low, fmb_u128 bits,
                                             double size)
{
    return (fmb_u128_low(bits) | fmb_u128_high(bits)) == 0 && low->most * size < 0x1p126;
}

#endif
