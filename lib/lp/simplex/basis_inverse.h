/* basis_inverse.h: a basis and its inverse: the edges at a vertex.
 *
 * The rows w_0, ..., w_{n-1} of a basis meet in a point. Edge r, e_r, leaves it along the other
 * rows: w_r.e_r = 1, w_k.e_r = 0. The edges are the columns of the inverse, which is stored
 * explicitly if it is small, otherwise as factors (updated_lu.h).
 */
#ifndef FMB_LP_BASIS_INVERSE_H
#define FMB_LP_BASIS_INVERSE_H

#include "lp/linalg/doubles/updated_lu.h"
#include "lp/simplex/dense_inverse.h"

typedef enum fmb_inverse_kind {
    FMB_INVERSE_BY_SIZE,
    FMB_INVERSE_FACTORS,
    FMB_INVERSE_EXPLICIT
} fmb_inverse_kind;

typedef struct fmb_basis_inverse {
    const fmb_scaled_program *f;
    size_t n;
    bool has_inverse;
    size_t *member; /* [n] the basis: rows, or FMB_UNIT + j */
    size_t *old;    /* [n] scratch */
    fmb_dense_inverse inverse;
    fmb_indexed_vector work; /* [n] scratch, zero between calls */
    fmb_updated_lu lu;
    size_t pivots; /* since the last recomputation */
    bool failed;   /* memory ran out: recompute before any use */
} fmb_basis_inverse;

/* A basis of unit vectors. Errors: MEMORY, LIMIT. The caller must call fmb_basis_inverse_clear even
 * after an error. */
fmb_status fmb_basis_inverse_init(fmb_basis_inverse *c, const fmb_scaled_program *f,
                                  fmb_inverse_kind kind);
void fmb_basis_inverse_clear(fmb_basis_inverse *c);

/* Use these members, with more unit vectors in place of dependent ones; places may change. entry is
 * scratch. Errors: MEMORY, LIMIT. */
fmb_status fmb_basis_inverse_set(fmb_basis_inverse *c, const size_t *member,
                                 fmb_indexed_vector *entry);
/* Put member i, the last one written, as `entry`, at place r, whose edge was the last one computed.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_basis_inverse_replace(fmb_basis_inverse *c, size_t r, size_t i,
                                     const fmb_indexed_vector *entry);
/* Have errors accumulated since the last recomputation? */
bool fmb_basis_inverse_is_stale(const fmb_basis_inverse *c);

/* entry = member i as a combination of the basis: the product of member i with each edge. */
void fmb_basis_inverse_write(fmb_basis_inverse *c, size_t i, fmb_indexed_vector *entry);
/* Solve y times the basis = cost[n]. */
void fmb_basis_inverse_price(fmb_basis_inverse *c, const double *cost, fmb_indexed_vector *y);
void fmb_basis_inverse_edge(fmb_basis_inverse *c, size_t r, fmb_indexed_vector *edge);
/* x = the point where the members meet, with the right sides right[n] by place. */
void fmb_basis_inverse_point(fmb_basis_inverse *c, const double *right, fmb_indexed_vector *x);

#endif
