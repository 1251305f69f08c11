/* simplex_methods.h: walks from vertex to vertex, by the dual and by the primal method. */
#ifndef FMB_LP_SIMPLEX_METHODS_H
#define FMB_LP_SIMPLEX_METHODS_H

#include "lp/simplex/simplex_state.h"

typedef enum fmb_simplex_end {
    FMB_SIMPLEX_RUNNING, /* not at an end yet */
    FMB_SIMPLEX_DONE,    /* primal feasible; or no edge gains */
    FMB_SIMPLEX_STOPPED, /* row `odd` is infeasible; or the edge at place `odd` is unbounded */
    FMB_SIMPLEX_ITERATION_LIMIT /* too many steps */
} fmb_simplex_end;

/* Walk until the vertex is primal feasible, with multipliers of the cost that are nonnegative
 * initially; the cost may be perturbed. Errors: MEMORY, LIMIT. */
fmb_status fmb_dual_simplex(fmb_simplex_state *o, fmb_simplex_end *end, size_t *odd);
/* From a primal feasible vertex, walk to the largest cost. Right sides may be perturbed, and are
 * not restored. Errors: MEMORY, LIMIT. */
fmb_status fmb_primal_simplex(fmb_simplex_state *o, fmb_simplex_end *end, size_t *odd);

/* A step of either method; *end if there is none. Errors: MEMORY, LIMIT. */
typedef fmb_status fmb_simplex_step(fmb_simplex_state *o, fmb_simplex_end *end, size_t *odd);

/* simplex_walk.c: steps until there is none, at most `most_steps` with those before. `refreshed`,
 * unless NULL, is called at the beginning and after each time the basis was recomputed. Errors:
 * MEMORY, LIMIT. */
fmb_status fmb_simplex_walk(fmb_simplex_state *o, size_t most_steps, fmb_simplex_step *step,
                            void (*refreshed)(fmb_simplex_state *o), fmb_simplex_end *end,
                            size_t *odd);

/* With more steps than this the walk is taken to be cycling. */
static inline size_t fmb_simplex_most_pivots(const fmb_simplex_state *o)
{
    return 1000 + 20 * (o->n + o->m);
}

#endif
