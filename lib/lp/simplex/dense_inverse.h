/* dense_inverse.h: the inverse of a basis of n vectors, dense and in doubles.
 *
 * Vectors w_0, ..., w_{n-1} have places. Edge r, e_r, is given by w_r.e_r = 1 and w_k.e_r = 0. Any
 * vector v is sum_r (v.e_r) w_r: these numbers write v in the basis. Initially all are unit
 * vectors; other vectors take their places one by one.
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
    bool *is_unit; /* [n] no vector has taken that place yet, and one may */
} fmb_dense_inverse;

/* A basis of n unit vectors. Errors: MEMORY, LIMIT; call fmb_dense_inverse_clear even then. */
fmb_status fmb_dense_inverse_init(fmb_dense_inverse *v, fmb_mem *mem, const fmb_kernels *kernels,
                                  size_t n);
void fmb_dense_inverse_clear(fmb_dense_inverse *v, fmb_mem *mem);
/* Back to n unit vectors, n not more than initially. */
void fmb_dense_inverse_restart(fmb_dense_inverse *v, size_t n);

/* entry += factor times number j of all edges: writes a vector in the basis term by term. */
void fmb_dense_inverse_add_term(const fmb_dense_inverse *v, size_t j, double factor, double *entry);
/* entry = the vector a[n], written in the basis. */
void fmb_dense_inverse_write(const fmb_dense_inverse *v, const double *a, double *entry);
/* Put the vector just written, as `entry`, at place r. */
void fmb_dense_inverse_replace(fmb_dense_inverse *v, size_t r, const double *entry);
/* Put it in place of the unit vector that suits best, and return that place. SIZE_MAX: no pivot is
 * larger than least. */
size_t fmb_dense_inverse_span(fmb_dense_inverse *v, const double *entry, double least);
/* Squared lengths of the edges. */
void fmb_dense_inverse_measure(const fmb_dense_inverse *v, double *square);
void fmb_dense_inverse_edge(const fmb_dense_inverse *v, size_t r, double *edge);

#endif
