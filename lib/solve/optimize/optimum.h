/* optimum.h: the layout of an fmb_optimum, the exact optimum of a linear form. */
#ifndef FMB_SOLVE_OPTIMUM_H
#define FMB_SOLVE_OPTIMUM_H

#include "solve/query/exact_intervals.h"

struct fmb_optimum {
    fmb_mem mem;
    fmb_sense sense;
    size_t dim;
    fmb_exact_side best; /* the constant included */
    mpq_t *point, *ray;  /* [dim] */
};

/* [give] Nothing is known yet. Errors: MEMORY. */
fmb_status fmb_optimum_new(fmb_sense sense, size_t dim, const fmb_alloc *hook, fmb_optimum **out);

#endif
