/* verdicts.h: what is told while rows are tested for redundancy (irredundant.h). */
#ifndef FMB_LP_VERDICTS_H
#define FMB_LP_VERDICTS_H

#include <gmp.h>

#include "num/weights.h"

/* Told of each decision as it falls. */
typedef struct fmb_verdicts {
    /* Row i is a combination (w) of rows not yet gone. */
    fmb_status (*redundant)(void *self, size_t i, const fmb_weights *w);
    /* Row i always holds with equality: w combines rows to its reverse. */
    fmb_status (*equality)(void *self, size_t i, const fmb_weights *w);
    /* x[n] satisfies all rows not yet gone but row i. */
    fmb_status (*irredundant)(void *self, size_t i, mpq_t *x);
    void *self;
} fmb_verdicts;

/* Rows of which some are decided (pruner.h). */
typedef struct fmb_pruner fmb_pruner;

#endif
