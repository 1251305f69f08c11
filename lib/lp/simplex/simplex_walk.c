/* simplex_walk.c: what both methods do between steps; see simplex_methods.h. */
#include "lp/simplex/simplex_methods.h"

/* Most checks of a result with a recomputed basis: recomputing may drop a member that depends on
 * others, nearly, which the next step puts in again. */
#define MOST_CHECKS 8

/* Of a brief walk only the cost is new. */
static fmb_status begin_walk(fmb_simplex_state *o)
{
    if (!o->is_brief || fmb_basis_inverse_is_stale(&o->basis))
        return fmb_simplex_state_refresh(o);
    fmb_simplex_state_price(o);
    return FMB_OK;
}

/* The result is checked once more with a recomputed basis. */
fmb_status fmb_simplex_walk(fmb_simplex_state *o, size_t most_steps, fmb_simplex_step *step,
                            void (*refreshed)(fmb_simplex_state *o), fmb_simplex_end *end,
                            size_t *odd)
{
    bool fresh = true;
    int looks = 0;
    fmb_status st = begin_walk(o);
    if (refreshed)
        refreshed(o);
    *end = FMB_SIMPLEX_RUNNING;
    while (st == FMB_OK && *end == FMB_SIMPLEX_RUNNING) {
        if (o->steps > most_steps)
            *end = FMB_SIMPLEX_ITERATION_LIMIT;
        else
            st = step(o, end, odd);
        bool ended = *end == FMB_SIMPLEX_DONE || *end == FMB_SIMPLEX_STOPPED;
        bool looks_again = ended && !fresh && !o->is_brief && looks++ < MOST_CHECKS;
        if (st == FMB_OK && (looks_again || (!ended && fmb_basis_inverse_is_stale(&o->basis)))) {
            st = fmb_simplex_state_refresh(o);
            if (refreshed)
                refreshed(o);
            *end = FMB_SIMPLEX_RUNNING;
            ended = true;
        }
        fresh = ended;
        fmb_run_count(o->f->run, fmb_simplex_state_work(o));
        FMB_THEN(st, fmb_run_poll(o->f->run));
    }
    return st;
}
