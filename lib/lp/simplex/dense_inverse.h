/* dense_inverse.h: the inverse of a basis of n vectors, dense and in doubles.
 *
 * Vectors w_0, ..., w_{n-1} stand at places. Edge r, e_r, is where w_r.e_r = 1 and w_k.e_r = 0. Any
 * vector v is sum_r (v.e_r) w_r: these numbers write v in the basis. At first unit vectors stand
 * everywhere; others take their places one by one.
 */
#ifndef FMB_LP_DENSE_INVERSE_H
#define FMB_LP_DENSE_INVERSE_H

#include "base/mem.h"
#include "num/kernels/kernels.h"

typedef struct fmb_dense_inverse {
    const fmb_kernels *kernels;
    size_t n, most_n;
    double *at;    /* [n][n] number j of edge r is at[j * n + r] */
    double *work;  /* [n] scratch */
    bool *is_unit; /* [n] no vector has taken that place yet */
} fmb_dense_inverse;

/* Of n unit vectors. Errors: MEMORY, LIMIT. In any case fmb_dense_inverse_clear it. */
fmb_status fmb_dense_inverse_init(fmb_dense_inverse *v, fmb_mem *mem, const fmb_kernels *kernels,
                                  size_t n);
void fmb_dense_inverse_clear(fmb_dense_inverse *v, fmb_mem *mem);
/* Of n unit vectors again, no more than at first. */
void fmb_dense_inverse_restart(fmb_dense_inverse *v, size_t n);

/* entry += factor times number j of all edges: a vector is written term by term. */
void fmb_dense_inverse_add_term(const fmb_dense_inverse *v, size_t j, double factor, double *entry);
/* entry = the vector a[n], written in the basis. */
void fmb_dense_inverse_write(const fmb_dense_inverse *v, const double *a, double *entry);
/* The vector that was just written takes place r. */
void fmb_dense_inverse_replace(fmb_dense_inverse *v, size_t r, const double *entry);
/* It takes the place of the unit vector that it replaces best. SIZE_MAX: no entry there is larger
 * than least. */
size_t fmb_dense_inverse_span(fmb_dense_inverse *v, const double *entry, double least);
void fmb_dense_inverse_edge(const fmb_dense_inverse *v, size_t r, double *edge);

#endif
