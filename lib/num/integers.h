/* integers.h: vectors of integers whose limbs are charged to an fmb_mem. */
#ifndef FMB_NUM_INTEGERS_H
#define FMB_NUM_INTEGERS_H

#include <gmp.h>

#include "base/mem.h"
#include "base/poll.h"

typedef struct fmb_integers {
    mpz_t *z;           /* [size] */
    size_t size, limbs; /* limbs charged */
} fmb_integers;

/* n zeros. Errors: MEMORY, LIMIT. The caller must call fmb_integers_clear even after an error. */
fmb_status fmb_integers_init(fmb_integers *v, size_t n, fmb_mem *mem);
void fmb_integers_clear(fmb_integers *v, fmb_mem *mem);
/* Divide x[n] and den > 0 by their greatest common divisor; if they are long, poll (which may be
 * NULL) is asked meanwhile. Errors: the status of poll; then x and den are unchanged. */
fmb_status fmb_integers_cancel(mpz_t *x, size_t n, mpz_t den, const fmb_poll *poll);
/* Divide z[n] by their greatest common divisor, which goes to `divisor` (1 if all of z are 0).
 * Errors: the status of poll. */
fmb_status fmb_integers_reduce(mpz_t *z, size_t n, mpz_t divisor, const fmb_poll *poll);
/* Charge the memory that the integers hold now. Errors: LIMIT. */
fmb_status fmb_integers_settle(fmb_integers *v, fmb_mem *mem);

#endif
