/* guard.c: see guard.h. */
#include "proof/guard.h"

#include "base/clock.h"

fmb_patience fmb_patience_default(void)
{
    return (fmb_patience){0};
}

fmb_status fmb_guard_begin(fmb_guard *g, const fmb_patience *patience, fmb_mem *mem)
{
    *g = (fmb_guard){.patience = patience ? *patience : fmb_patience_default()};
    if (!(g->patience.max_seconds >= 0))
        return FMB_ERR_ARG;
    if (g->patience.max_seconds > 0)
        g->deadline = fmb_monotonic_seconds() + g->patience.max_seconds;
    mem->limit = g->patience.max_bytes;
    return FMB_OK;
}

static fmb_status ask_guard(void *with)
{
    fmb_guard *g = with;
    if (g->stop == FMB_STOP_DONE && g->patience.give_up && g->patience.give_up(g->patience.self))
        g->stop = FMB_STOP_CANCELLED;
    if (g->stop == FMB_STOP_DONE && g->deadline > 0 && g->asked++ % 16 == 0 &&
        fmb_monotonic_seconds() >= g->deadline)
        g->stop = FMB_STOP_TIME;
    return g->stop == FMB_STOP_DONE ? FMB_OK : FMB_LIMIT;
}

fmb_poll fmb_guard_poll(fmb_guard *g)
{
    return (fmb_poll){ask_guard, g};
}

fmb_stop fmb_guard_stop(const fmb_guard *g)
{
    return g->stop != FMB_STOP_DONE ? g->stop : FMB_STOP_BYTES;
}
