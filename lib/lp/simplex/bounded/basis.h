/* basis.h: columns, and a basis among them with its inverse, dense and in doubles.
 *
 * Columns a_j of d numbers, each scaled so that its largest is about 1. Each belongs to an unknown
 * z_j with a range; together they are to make up a target, sum z_j a_j = b. A basis of d columns
 * writes b, minus the columns at their upper bounds, uniquely; unit vectors fill the places for
 * which there is no column. The results are guesses: the caller proves what it uses.
 *
 * Invariant: a column in the basis is not at its upper bound.
 */
#ifndef FMB_LP_BASIS_H
#define FMB_LP_BASIS_H

#include "base/mem.h"
#include "lp/simplex/dense_inverse.h"

typedef enum fmb_range {
    FMB_RANGE_UP,   /* 0 <= z */
    FMB_RANGE_UNIT, /* 0 <= z <= 1 */
    FMB_RANGE_FREE, /* any z */
    FMB_RANGE_ZERO  /* z = 0: not to be used any more */
} fmb_range;

typedef struct fmb_basis {
    fmb_mem *mem;
    const fmb_kernels *kernels;
    double value_zero, entry_zero; /* less counts as a rounding error of 0: in values and
                                      gains; in entries that are pivots */
    size_t d, most_d, size, capacity;
    double *at;     /* [d][capacity]: number k of column j is at[k * capacity + j] */
    uint8_t *range; /* [capacity] of fmb_range */
    bool *is_high;  /* [capacity] at its upper bound */
    bool *is_basic; /* [capacity] */
    double *price;  /* [capacity] scratch: a row of the inverse times each column */
    double *gain;   /* [capacity] reduced costs: cost minus prices times column */
    size_t *old;    /* [d] scratch */
    size_t *basic;  /* [d] column of each place of the basis; SIZE_MAX: a unit vector, unused */
    fmb_dense_inverse inverse; /* of the basis */
    double *value;             /* [d] of the basic columns, after a search */
    double *normal;            /* [d] after a failed search: separates the target from all sums */
    double *edge;              /* [d] scratch: a row of the inverse */
    double *entry;             /* [d] scratch: a column, written in the basis */
    double *rest;              /* [d] scratch: a column, or the target minus the high columns */
    size_t highs;              /* number of high columns */
    size_t pivots;             /* since the last inversion */
} fmb_basis;

/* No columns, of d numbers. Errors: MEMORY, LIMIT; call fmb_basis_clear even then. */
fmb_status fmb_basis_init(fmb_basis *b, fmb_mem *mem, const fmb_kernels *kernels, size_t d);
void fmb_basis_clear(fmb_basis *b);
/* Make room for that many columns. */
fmb_status fmb_basis_reserve(fmb_basis *b, size_t capacity);
/* Remove all columns; new ones have d numbers, at most as before. Nothing is allocated. */
void fmb_basis_restart(fmb_basis *b, size_t d);

/* Add a column; its number is the number of columns before it. */
fmb_status fmb_basis_add(fmb_basis *b, const double *v, fmb_range range);
/* Put column j into the basis in place of the unit vector that suits best. False: no pivot is
 * larger than least, so the column seems to depend on the others. */
bool fmb_basis_span(fmb_basis *b, size_t j, double least);

/* entry = column j, written in the basis. */
void fmb_basis_write(fmb_basis *b, size_t j);
/* Put column j, just written, at place r. */
void fmb_basis_replace(fmb_basis *b, size_t r, size_t j);
/* Fill the basis with unit vectors. */
void fmb_basis_empty(fmb_basis *b);
/* Recompute the inverse, starting from unit vectors. */
void fmb_basis_invert(fmb_basis *b);

#endif
