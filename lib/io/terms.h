/* terms.h: the numbers of a row, each given as a text. */
#ifndef FMB_IO_TERMS_H
#define FMB_IO_TERMS_H

#include <gmp.h>

#include "base/mem.h"

enum { FMB_IO_WRONG_SIZE = 160 };

/* q[k] = coef[k], 0 <= k < n, and q[n] = b. Errors: ARG (a pointer is NULL), PARSE, both with the
 * reason in wrong; MEMORY. */
fmb_status fmb_io_row_numbers(size_t n, const int *var, const char *const *coef, const char *b,
                              const fmb_mem *mem, mpq_t *q, char wrong[FMB_IO_WRONG_SIZE]);

#endif
