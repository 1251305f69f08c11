/* rationals.h: vectors of rationals. */
#ifndef FMB_NUM_RATIONALS_H
#define FMB_NUM_RATIONALS_H

#include <gmp.h>

#include "base/mem.h"

/* n rationals, 0 at first. Errors: MEMORY, LIMIT. */
fmb_status fmb_rationals_new(mpq_t **out, size_t n, fmb_mem *mem);
/* x may be NULL. */
void fmb_rationals_free(mpq_t *x, size_t n, fmb_mem *mem);

/* The double nearest to q, of two that are equally near the even one, the largest beyond that; 0
 * for NULL. */
double fmb_nearest_double(mpq_srcptr q);
/* *out = the double nearest to num / den, where one division finds it; den > 0. */
bool fmb_nearest_quotient(int64_t num, int64_t den, double *out);
/* The double nearest to the root of q >= 0, whatever the size of q. */
double fmb_nearest_root(mpq_srcptr q);
/* q as such an integer, if it is one. */
bool fmb_rational_as_integer(mpq_srcptr q, int64_t *out);
/* out = q, 0 for NULL; nothing where out is NULL. */
void fmb_rational_give(mpq_srcptr q, mpq_ptr out);
/* "-1/3" and a NUL to text[size], if it has room for that; how long it is without the NUL. "0" for
 * NULL. */
size_t fmb_rational_print(mpq_srcptr q, char *text, size_t size);

#endif
