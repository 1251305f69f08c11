/* argument_error.c: checks of arguments, and the error text that the solver keeps. */
#include <stdarg.h>
#include <stdio.h>

#include "solve/query/solver.h"
#include "system/system_private.h"

const char *fmb_solver_trouble(const fmb_solver *v)
{
    return v ? v->error : "";
}

fmb_status fmb_solver_refuse(fmb_solver *v, fmb_status st, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    if (v)
        vsnprintf(v->error, sizeof v->error, format, list);
    va_end(list);
    return st;
}

fmb_status fmb_solver_expect_result(fmb_solver *v, const fmb_result *res)
{
    char why[sizeof v->error];
    if (!res || fmb_sized_is_good(res, sizeof *res, "res", why, sizeof why))
        return FMB_OK;
    return fmb_solver_refuse(v, FMB_ERR_ARG, "%s", why);
}

fmb_status fmb_solver_expect(fmb_solver *v, const fmb_system *s, bool out, const fmb_result *res)
{
    if (v && s && out)
        return fmb_solver_expect_result(v, res);
    return fmb_solver_refuse(v, FMB_ERR_ARG, "%s is NULL", s ? "out" : "s");
}

fmb_status fmb_solver_expect_variables(fmb_solver *v, const fmb_system *s, const char *name,
                                       const int *list, int n)
{
    int dim = fmb_system_dim(s);
    if (n < 0)
        return fmb_solver_refuse(v, FMB_ERR_ARG, "n is %d", n);
    for (int i = 0; list && i < n; i++)
        if (list[i] < 0 || list[i] >= dim)
            return fmb_solver_refuse(v, FMB_ERR_ARG, "%s[%d] is %d, but there are %d variables",
                                     name, i, list[i], dim);
    return FMB_OK;
}
