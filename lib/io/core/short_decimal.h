/* short_decimal.h: decimals whose digits fit a machine word, which nearly all numbers of a text
 * are: read in one pass, and made doubles or rationals without any other number in between. */
#ifndef FMB_IO_SHORT_DECIMAL_H
#define FMB_IO_SHORT_DECIMAL_H

#include "io/core/cursor.h"

/* +-z 10^power; |power| may be anything below 2000. */
typedef struct fmb_short_decimal {
    uint64_t z; /* < 10^19 */
    int power;
    int exponent; /* of it, what is written as such */
    bool minus;
} fmb_short_decimal;

/* The number at c, which is then past it; false, and c where it was, if it has more digits, or is
 * something else. strictly: as JSON has them, with no '+', digits on both sides of a point, and no
 * zeros in front. */
bool fmb_scan_short_decimal(fmb_cursor *c, bool strictly, fmb_short_decimal *out);

/* The double nearest to d, of two that are equally near the even one; false, and nothing is said,
 * where the power is large. */
bool fmb_short_decimal_nearest(const fmb_short_decimal *d, double *out);

/* d itself, canonical; *exact: it is a double. False, and nothing is said, as above. */
bool fmb_short_decimal_value(const fmb_short_decimal *d, mpq_t out, bool *exact);

#endif
