/* integers.h: vectors of integers whose limbs are charged. */
#ifndef FMB_NUM_INTEGERS_H
#define FMB_NUM_INTEGERS_H

#include <gmp.h>

#include "base/mem.h"
#include "base/poll.h"

typedef struct fmb_integers {
    mpz_t *z;           /* [size] */
    size_t size, limbs; /* limbs charged */
} fmb_integers;

/* n zeros. Errors: MEMORY, LIMIT. In any case fmb_integers_clear it. */
fmb_status fmb_integers_init(fmb_integers *v, size_t n, fmb_mem *mem);
void fmb_integers_clear(fmb_integers *v, fmb_mem *mem);
/* Divide x[n] and den > 0 by their greatest common divisor; where they are long poll, unless it is
 * NULL, is asked. Errors: what it says; then they are as they were. */
fmb_status fmb_integers_cancel(mpz_t *x, size_t n, mpz_t den, const fmb_poll *poll);
/* Divide z[n] by their greatest common divisor, which is also set; 1 where all are 0. Errors: the
 * same. */
fmb_status fmb_integers_reduce(mpz_t *z, size_t n, mpz_t divisor, const fmb_poll *poll);
/* Charge what the numbers hold now. Errors: LIMIT. */
fmb_status fmb_integers_settle(fmb_integers *v, fmb_mem *mem);

#endif
