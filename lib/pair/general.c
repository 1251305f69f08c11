/* general.c: see general.h. */
#include "pair/general.h"

struct fmb_general {
    int dim;
};

fmb_general *fmb_general_new(int dim, fmb_mem *mem)
{
    fmb_general *g = fmb_mem_zero(mem, 1, sizeof *g);
    if (g)
        g->dim = dim;
    return g;
}

void fmb_general_free(fmb_general *g, fmb_mem *mem)
{
    if (g)
        fmb_mem_put(mem, g, 1, sizeof *g);
}

fmb_verdict fmb_general_decide(fmb_general *g, const fmb_frame *p, const fmb_frame *q)
{
    (void)g;
    (void)p;
    (void)q;
    return FMB_UNKNOWN;
}
