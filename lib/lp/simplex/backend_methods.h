/* backend_methods.h: what stands behind a backend (backend.h): a simplex in doubles, as a table.
 *
 * What a function is about is noted in the scaled program before it is called. Errors of those that
 * have a status: MEMORY, LIMIT.
 */
#ifndef FMB_LP_BACKEND_METHODS_H
#define FMB_LP_BACKEND_METHODS_H

#include "lp/model/scaled_program.h"
#include "lp/simplex/backend.h"

typedef struct fmb_backend_methods {
    /* *out is NULL where this method wants no such program. */
    fmb_status (*open)(const fmb_scaled_program *f, void **out);
    void (*close)(void *self);
    /* What to lean to (or NULL) and the cost are scaled as the columns are. */
    fmb_status (*search)(void *self, const double *lean, fmb_hint *h);
    fmb_status (*maximize)(void *self, const double *cost, fmb_hint *h);
    fmb_status (*grow)(void *self);
    /* Row i goes off or on; if off, it leaves the basis. */
    fmb_status (*switch_row)(void *self, size_t i);
    fmb_status (*place)(void *self, const size_t *basis);
    void (*shift)(void *self);
    /* The right side of row i alone is another one. */
    void (*shift_row)(void *self, size_t i);
    /* Where the last question ended, scaled as the columns are: x[n]. */
    void (*point)(void *self, double *x);
} fmb_backend_methods;

/* Our own; the second one has factors of the basis however few columns there are, for tests. */
extern const fmb_backend_methods fmb_backend_revised_simplex, fmb_backend_revised_simplex_lu;

/* A backend with this method behind it, for tests; *out is NULL where it wants no such program.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_backend_open_with(fmb_run *run, const fmb_program *p,
                                 const fmb_backend_methods *side, fmb_backend **out);

#endif
