/* simplex_methods.h: from vertex to vertex, by the dual and by the primal method. */
#ifndef FMB_LP_SIMPLEX_METHODS_H
#define FMB_LP_SIMPLEX_METHODS_H

#include "lp/simplex/simplex_state.h"

typedef enum fmb_simplex_end {
    FMB_SIMPLEX_RUNNING, /* not at an end yet */
    FMB_SIMPLEX_DONE,    /* primal feasible; or no edge gains */
    FMB_SIMPLEX_STOPPED, /* row `odd` cannot hold; or the edge at place `odd` goes on for ever */
    FMB_SIMPLEX_ITERATION_LIMIT /* too many steps */
} fmb_simplex_end;

/* Until the vertex is primal feasible, along multipliers of the cost that start nonnegative; the
 * cost is added to on the way. Errors: MEMORY, LIMIT. */
fmb_status fmb_dual_simplex(fmb_simplex_state *o, fmb_simplex_end *end, size_t *odd);
/* From a primal feasible vertex to where the cost is greatest. Right sides may be moved a little on
 * the way, and are not moved back. Errors: MEMORY, LIMIT. */
fmb_status fmb_primal_simplex(fmb_simplex_state *o, fmb_simplex_end *end, size_t *odd);

/* What an end says is looked at again from a basis computed afresh, so often at most: that may drop
 * a member that depends on others, nearly, which the next step takes in again. */
#define FMB_SIMPLEX_MOST_CHECKS 8

/* More steps are a circle. */
static inline size_t fmb_simplex_most_pivots(const fmb_simplex_state *o)
{
    return 1000 + 20 * (o->n + o->m);
}

#endif
