/* cone.h: is a vector a nonnegative combination of others? A guess in doubles.
 *
 * Generators are columns of d numbers, each scaled by a power of 2 so that its largest is about 1.
 * What comes out are guesses: the caller proves what it uses.
 */
#ifndef FMB_LP_CONE_H
#define FMB_LP_CONE_H

#include "trace/run.h"

typedef struct fmb_cone {
    fmb_run *run;
    fmb_mem *mem;
    const fmb_kernels *kernels;
    size_t d, size, capacity; /* generators */
    double *at;               /* [d][capacity]: number k of generator j is at[k * capacity + j] */
    bool *is_free;            /* [capacity] may count negatively */
    bool *is_gone;            /* [capacity] no longer to be used */
    size_t *basic;   /* [d] generator of each place of the basis; SIZE_MAX: a unit vector, unused */
    double *inverse; /* [d][d] of the basis */
    double *value;   /* [d] of the basic generators, after a search */
    double *normal;  /* [d] after a failed search: >= 0 on all generators, < 0 on the target */
    double *price;   /* [capacity] */
    size_t pivots;   /* since the basis was inverted afresh */
} fmb_cone;

typedef enum fmb_guess { FMB_GUESS_NONE = 0, FMB_GUESS_INSIDE, FMB_GUESS_OUTSIDE } fmb_guess;

/* No generators in d dimensions. Errors: MEMORY, LIMIT. In any case fmb_cone_clear it. */
fmb_status fmb_cone_init(fmb_cone *c, fmb_run *run, size_t d);
void fmb_cone_clear(fmb_cone *c);
/* Add a generator: its number is the count before it. */
fmb_status fmb_cone_add(fmb_cone *c, const double *v, bool is_free);
/* Take generator j into the basis in place of a unit vector, if it is independent of the others. */
void fmb_cone_span(fmb_cone *c, size_t j);
/* Is target a combination, without generator `banned` (SIZE_MAX: all may be used)? INSIDE: value
 * has the multipliers of basic. OUTSIDE: normal tells them apart. Errors: LIMIT. */
fmb_status fmb_cone_search(fmb_cone *c, const double *target, size_t banned, fmb_guess *out);

#endif
