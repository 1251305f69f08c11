/* verdicts.h: callbacks of the tests for redundancy (irredundant.h). */
#ifndef FMB_LP_VERDICTS_H
#define FMB_LP_VERDICTS_H

#include <gmp.h>

#include "num/weights.h"

/* Called at each decision; each may be NULL. */
typedef struct fmb_verdicts {
    /* Row i follows from rows not yet removed, by the multipliers w. */
    fmb_status (*redundant)(void *self, size_t i, const fmb_weights *w);
    /* Row i always holds with equality: the reverse of row i follows by the multipliers w. */
    fmb_status (*equality)(void *self, size_t i, const fmb_weights *w);
    /* x[n] violates row i and satisfies all other rows not yet removed. */
    fmb_status (*irredundant)(void *self, size_t i, mpq_t *x);
    void *self;
} fmb_verdicts;

/* The state of the tests (pruner.h). */
typedef struct fmb_pruner fmb_pruner;

#endif
