/* simplex_methods.h: from corner to corner, by the dual and by the primal method. */
#ifndef FMB_LP_SIMPLEX_METHODS_H
#define FMB_LP_SIMPLEX_METHODS_H

#include "lp/simplex/simplex_state.h"

typedef enum fmb_walk {
    FMB_WALK_ON,      /* not at an end yet */
    FMB_WALK_DONE,    /* all rows hold; or no edge gains */
    FMB_WALK_STOPPED, /* row `odd` cannot hold; or the edge at place `odd` goes on for ever */
    FMB_WALK_LOST     /* too many steps */
} fmb_walk;

/* Until all rows hold, along multipliers of the cost that start nonnegative; the cost is added to
 * on the way. Errors: MEMORY, LIMIT. */
fmb_status fmb_walk_dually(fmb_stand *o, fmb_walk *end, size_t *odd);
/* From where all rows hold to where the cost is greatest. Right sides may be moved a little on the
 * way, and are not moved back. Errors: MEMORY, LIMIT. */
fmb_status fmb_walk_primally(fmb_stand *o, fmb_walk *end, size_t *odd);

/* What an end says is looked at again from a basis computed afresh, so often at most: that may drop
 * a member that depends on others, nearly, which the next step takes in again. */
#define FMB_WALK_MOST_LOOKS 8

/* More steps are a circle. */
static inline size_t fmb_walk_most_steps(const fmb_stand *o)
{
    return 1000 + 20 * (o->n + o->m);
}

#endif
