/* basis.h: columns, and a basis among them with its inverse, dense and in doubles.
 *
 * Columns a_j of d numbers, each scaled so that its largest is about 1. Each stands for an unknown
 * z_j with a range; together they are to make up a target, sum z_j a_j = b. A basis of d columns
 * writes b, less the columns that stand at their upper ends, uniquely; unit vectors fill the places
 * for which there is no column. What comes out are guesses: the caller proves what it uses.
 *
 * Invariant: a column in the basis is not high.
 */
#ifndef FMB_LP_BASIS_H
#define FMB_LP_BASIS_H

#include "base/mem.h"
#include "lp/simplex/dense_inverse.h"

typedef enum fmb_range {
    FMB_RANGE_UP,   /* 0 <= z */
    FMB_RANGE_UNIT, /* 0 <= z <= 1 */
    FMB_RANGE_FREE, /* any z */
    FMB_RANGE_ZERO  /* z = 0: no longer to be used */
} fmb_range;

typedef struct fmb_basis {
    fmb_mem *mem;
    const fmb_kernels *kernels;
    double value_zero, entry_zero; /* less is taken for the rounding error of 0: in values and
                                      gains; in entries that are pivots */
    size_t d, most_d, size, capacity;
    double *at;       /* [d][capacity]: number k of column j is at[k * capacity + j] */
    uint8_t *range;   /* [capacity] of fmb_range */
    bool *is_high;    /* [capacity] stands at its upper end */
    bool *is_basic;   /* [capacity] */
    double *price;    /* [capacity] scratch: a row of the inverse times each column */
    double *gain;     /* [capacity] what a unit of each unknown brings, beyond the prices of rows */
    double *cost;     /* [capacity] what a unit of each brings, where the dual method minds that */
    bool has_cost;    /* it does, and unit vectors have to be >= 0; */
    double enough;    /* it stops where basic unknowns bring less than this */
    double unit_cost; /* of unit vectors */
    bool *is_mirrored; /* [d] the unit vector of that place is its mirror image */
    size_t *candidate; /* [capacity] scratch: columns that may come in */
    size_t *old;       /* [d] scratch */
    size_t *basic;     /* [d] column of each place of the basis; SIZE_MAX: a unit vector, unused */
    fmb_dense_inverse inverse; /* of the basis */
    double *length; /* [d] squares of the lengths of the edges; 1 where there is no cost */
    double *value;  /* [d] of the basic columns, after a search */
    double *normal; /* [d] after a failed search: it tells the target from all that is possible */
    double *edge;   /* [d] scratch: a row of the inverse */
    double *entry;  /* [d] scratch: a column, written in the basis */
    double *rest;   /* [d] scratch: a column, or the target less the high columns */
    size_t highs;   /* columns that are high */
    size_t pivots;  /* since the basis was inverted afresh */
} fmb_basis;

/* No columns, of d numbers. Errors: MEMORY, LIMIT. In any case fmb_basis_clear it. */
fmb_status fmb_basis_init(fmb_basis *b, fmb_mem *mem, const fmb_kernels *kernels, size_t d);
void fmb_basis_clear(fmb_basis *b);
/* Room for that many columns. */
fmb_status fmb_basis_reserve(fmb_basis *b, size_t capacity);
/* No columns again, of d numbers, no more than at first; nothing is allocated. */
void fmb_basis_restart(fmb_basis *b, size_t d);

/* Add a column: its number is the count before it. */
fmb_status fmb_basis_add(fmb_basis *b, const double *v, fmb_range range);
/* Take column j into the basis in place of the unit vector that it replaces best. False: no entry
 * there is larger than least, as if it depended on the others. */
bool fmb_basis_span(fmb_basis *b, size_t j, double least);

/* entry = column j, written in the basis. */
void fmb_basis_write(fmb_basis *b, size_t j);
/* Column j, just written, takes place r. */
void fmb_basis_replace(fmb_basis *b, size_t r, size_t j);
/* Unit vectors fill the basis. */
void fmb_basis_empty(fmb_basis *b);
/* The inverse once more, from unit vectors. */
void fmb_basis_invert(fmb_basis *b);

#endif
