/* short_decimal.h: decimals whose digits fit a machine word, as nearly all numbers of a text do:
 * read in one pass, and converted directly to doubles or rationals. */
#ifndef FMB_IO_SHORT_DECIMAL_H
#define FMB_IO_SHORT_DECIMAL_H

#include "io/core/cursor.h"

/* +-z 10^power; |power| may be anything below 2000. */
typedef struct fmb_short_decimal {
    uint64_t z; /* < 10^19 */
    int power;
    int exponent; /* the part of power that is written as an exponent */
    bool minus;
} fmb_short_decimal;

/* Read the number at c, and move past it; false, with c unchanged, if it has more digits, or is no
 * number. strictly: as in JSON, with no '+', digits on both sides of a point, and no leading zeros.
 */
bool fmb_scan_short_decimal(fmb_cursor *c, bool strictly, fmb_short_decimal *out);

/* The double nearest to d, ties to even; false, with *out undefined, where the power is large. */
bool fmb_short_decimal_nearest(const fmb_short_decimal *d, double *out);

/* The exact value of d, canonical; *exact: it is a double. False: as above. */
bool fmb_short_decimal_value(const fmb_short_decimal *d, mpq_t out, bool *exact);

#endif
