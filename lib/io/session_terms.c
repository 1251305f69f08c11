/* session_terms.c: changes of a loaded system, with numbers given as text (<fmb/session.h>). */
#include <fmb/gmp.h>

#include "io/terms.h"
#include "num/rationals.h"
#include "solve/query/solver.h"

/* [give, fmb_rationals_free] The numbers of a row of text. Errors: as there; STATE. */
static fmb_status read_numbers_for_session(fmb_solver *v, size_t n, const int *var,
                                           const char *const *coef, const char *b, mpq_t **out)
{
    char wrong[FMB_IO_WRONG_SIZE];
    if (!v)
        return FMB_ERR_ARG;
    if (!fmb_solver_system(v))
        return FMB_ERR_STATE;
    FMB_TRY(fmb_rationals_new(out, n + 1, &v->mem));
    fmb_status st = fmb_io_row_numbers(n, var, coef, b, &v->mem, *out, wrong);
    if (st == FMB_OK)
        return FMB_OK;
    fmb_rationals_free(*out, n + 1, &v->mem);
    return *wrong ? fmb_solver_refuse(v, st, "%s", wrong) : st;
}

fmb_status fmb_solver_add_terms_text(fmb_solver *v, size_t n, const int *var,
                                     const char *const *coef, fmb_rel rel, const char *b)
{
    mpq_t *q;
    FMB_TRY(read_numbers_for_session(v, n, var, coef, b, &q));
    fmb_status st = fmb_solver_add_q(v, n, var, q, rel, q[n]);
    fmb_rationals_free(q, n + 1, &v->mem);
    return st;
}

fmb_status fmb_solver_set_right_text(fmb_solver *v, size_t row, const char *b)
{
    mpq_t *q;
    FMB_TRY(read_numbers_for_session(v, 0, NULL, NULL, b, &q));
    fmb_status st = fmb_solver_set_right_q(v, row, q[0]);
    fmb_rationals_free(q, 1, &v->mem);
    return st;
}
