/* rationals.h: vectors of rationals. */
#ifndef FMB_NUM_RATIONALS_H
#define FMB_NUM_RATIONALS_H

#include <gmp.h>

#include "base/mem.h"

/* n rationals, all 0. Errors: MEMORY, LIMIT. */
fmb_status fmb_rationals_new(mpq_t **out, size_t n, fmb_mem *mem);
/* x may be NULL. */
void fmb_rationals_free(mpq_t *x, size_t n, fmb_mem *mem);

/* The double nearest to q; of two equally near ones the even one; beyond the range of doubles the
 * largest one; 0 if q is NULL. */
double fmb_nearest_double(mpq_srcptr q);
/* *out = the double nearest to num / den, den > 0; false if a single division cannot find it. */
bool fmb_nearest_quotient(int64_t num, int64_t den, double *out);
/* The double nearest to the square root of q >= 0, whatever the size of q. */
double fmb_nearest_root(mpq_srcptr q);
/* If q is an integer that fits, *out = q; else false. */
bool fmb_rational_as_integer(mpq_srcptr q, int64_t *out);
/* out = q, or 0 if q is NULL; does nothing if out is NULL. */
void fmb_rational_give(mpq_srcptr q, mpq_ptr out);
/* Print q as "-1/3" (NULL as "0"), with a NUL, to text[size] if it fits there. Returns the length
 * without the NUL. */
size_t fmb_rational_print(mpq_srcptr q, char *text, size_t size);

#endif
