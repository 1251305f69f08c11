/* lp_none.c: built without GLPK; see scaling.h. */
#include "fmb-qualify/scaling/scaling.h"

const char *scaling_lp_name(void)
{
    return NULL;
}

scaling_lp *scaling_lp_open(size_t n, const fmb_frame *p, const fmb_frame *q, fmb_verdict *verdict)
{
    (void)n, (void)p, (void)q, (void)verdict;
    return NULL;
}

void scaling_lp_close(scaling_lp *lp)
{
    (void)lp;
}

fmb_status scaling_lp_run(void *self, size_t first, size_t n)
{
    (void)self, (void)first, (void)n;
    return FMB_ERR_ARG;
}
