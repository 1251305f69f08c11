/* must.h: calls that must succeed in a test: they fail only if memory runs out. */
#ifndef FMB_TEST_MUST_H
#define FMB_TEST_MUST_H

#include <stdio.h>
#include <stdlib.h>

#include <fmb/solve.h>

/* Stop the program unless st is FMB_OK. */
static inline void must(fmb_status st)
{
    if (st == FMB_OK)
        return;
    fprintf(stderr, "unexpected status: %s\n", fmb_status_text(st));
    abort();
}

/* [give, fmb_solver_free] A solver with these options. */
static inline fmb_solver *must_open(fmb_options o)
{
    fmb_solver *v = NULL;
    o.size = sizeof o;
    must(fmb_solver_new(&o, NULL, &v));
    return v;
}

#endif
