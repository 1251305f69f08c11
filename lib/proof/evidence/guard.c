/* guard.c: see guard.h. */
#include "proof/evidence/guard.h"

#include "base/clock.h"
#include "base/sized.h"

/* Check and copy the limits; why[size]: what is wrong with them, "" with FMB_OK. */
static fmb_status take_patience(const fmb_patience *p, fmb_patience *ours, char *why, size_t size)
{
    if (!fmb_sized_take(ours, sizeof *ours, p, "patience", why, size))
        return FMB_ERR_ARG;
    if (ours->max_seconds >= 0)
        return FMB_OK;
    snprintf(why, size, "max_seconds is %g", ours->max_seconds);
    return FMB_ERR_ARG;
}

size_t fmb_patience_trouble(const fmb_patience *p, char *text, size_t size)
{
    fmb_patience ours;
    char why[160];
    (void)take_patience(p, &ours, why, sizeof why);
    return fmb_text_give(why, text, size);
}

fmb_status fmb_guard_begin(fmb_guard *g, const fmb_patience *patience, fmb_mem *mem)
{
    char why[160];
    *g = (fmb_guard){0};
    if (take_patience(patience, &g->patience, why, sizeof why) != FMB_OK)
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
