/* modular_kernel.h: what a few rows leave free, where its numbers are short.
 *
 * If rows of integers leave one vector free that is 0 on all of them, it is made of minors of as
 * many of them as are independent. It is found modulo one prime of 61 bits: so it is right if the
 * minors are shorter than that. Nothing is proved here; whoever asks looks whether it is so. A
 * square system B x = right is of this kind: (x, 1) is 0 on the rows of (B, -right).
 *
 * Source: Cabay 1971, Exact solution of linear equations, for one modulus that is large enough.
 */
#ifndef FMB_LP_MODULAR_KERNEL_H
#define FMB_LP_MODULAR_KERNEL_H

#include "num/prime.h"

typedef struct fmb_modular_kernel {
    size_t n, columns; /* rows, and columns, at most n + 1 */
    fmb_prime q;
    uint64_t *a;           /* [n][n + 2] entries; last, by what the row has been multiplied */
    uint64_t **row;        /* [n] rows of a, those with pivots first */
    size_t *column;        /* [n] columns of the pivots */
    uint64_t *w, *inverse; /* [n + 1] scratch */
    int64_t *v;            /* [n + 1] what is found: coprime */
} fmb_modular_kernel;

/* Errors: MEMORY, LIMIT. In any case fmb_modular_kernel_clear it. */
fmb_status fmb_modular_kernel_init(fmb_modular_kernel *h, fmb_mem *mem, size_t n);
void fmb_modular_kernel_clear(fmb_modular_kernel *h, fmb_mem *mem);

/* So many columns of zeros; then one entry becomes x, |x| < 2^62. */
void fmb_modular_kernel_zero(fmb_modular_kernel *h, size_t columns);
static inline void fmb_modular_kernel_put(fmb_modular_kernel *h, size_t i, size_t j, int64_t x)
{
    h->a[i * (h->n + 2) + j] = fmb_prime_of_signed(&h->q, x);
}
/* A guess: v[columns] is 0 on all rows. False: not one vector is free, but several or none. The
 * entries are gone. */
bool fmb_modular_kernel_find(fmb_modular_kernel *h);

#endif
