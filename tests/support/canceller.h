/* canceller.h: a sink that cancels a query at one of its events. */
#ifndef FMB_TEST_CANCELLER_H
#define FMB_TEST_CANCELLER_H

#include <fmb/solve.h>
#include <fmb/trace.h>

typedef struct canceller {
    fmb_solver *v;
    int events; /* events before the cancel; -1: never cancels */
} canceller;

static inline void cancel_at_event(void *self, const fmb_event *e)
{
    canceller *c = self;
    (void)e;
    if (c->events-- == 0)
        fmb_solver_cancel(c->v);
}

#endif
