/* options_read.c: the options of a caller become those of a solver, or are refused with a reason.
 */
#include <string.h>

#include "num/kernels/kernels.h"
#include "solve/query/solver.h"

fmb_status fmb_options_read(fmb_solver *v, const fmb_options *o)
{
    if (!fmb_sized_take(&v->options, sizeof v->options, o, "options", v->error, sizeof v->error))
        return FMB_ERR_ARG;
    fmb_status st = fmb_options_expect(v, &v->options);
    if (st == FMB_OK && !fmb_kernels_choose(v->options.simd))
        st = fmb_solver_refuse(v, FMB_ERR_ARG, "simd: the processor lacks these instructions");
    if (st == FMB_OK)
        st = fmb_rules_read(v, &v->options);
    v->usual_rules = v->options.rules || v->options.presolve ? -1 : v->rules;
    v->options.rules = v->options.presolve = NULL; /* they were borrowed */
    return st;
}

size_t fmb_options_trouble(const fmb_options *o, char *text, size_t size)
{
    fmb_solver v = {.rules = 0};
    if (o)
        (void)fmb_options_read(&v, o);
    return fmb_text_give(v.error, text, size);
}
