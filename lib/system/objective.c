/* objective.c: the linear form that a system may carry. It is stored as a row whose right side is
 * the constant, so the functions for rows make it, too.
 */
#include <math.h>

#include "system/system_private.h"

static fmb_status expect_sense(fmb_system *s, fmb_sense sense)
{
    return sense == FMB_SENSE_MAX || sense == FMB_SENSE_MIN
               ? FMB_OK
               : fmb_system_refuse(s, "sense %d is none", (int)sense);
}

/* Check a form in doubles. */
static fmb_status expect_form(fmb_system *s, fmb_sense sense, double constant)
{
    FMB_TRY(expect_sense(s, sense));
    return !isfinite(constant) ? fmb_system_refuse(s, "constant is %g", constant) : FMB_OK;
}

/* Make the last row the objective. */
static fmb_status turn_last_row_into_objective(fmb_system *s, fmb_sense sense)
{
    fmb_system_drop_objective(s);
    s->objective = s->row[--s->rows];
    s->sense = sense;
    return FMB_OK;
}

fmb_status fmb_system_set_objective(fmb_system *s, const fmb_objective *o)
{
    if (!s)
        return FMB_ERR_ARG;
    if (!o || o->sense == FMB_SENSE_NONE) {
        fmb_system_drop_objective(s);
        return FMB_OK;
    }
    FMB_TRY(expect_form(s, o->sense, o->constant));
    FMB_TRY(fmb_system_add(s, o->coef, FMB_LE, o->constant));
    return turn_last_row_into_objective(s, o->sense);
}

fmb_status fmb_system_set_objective_terms(fmb_system *s, fmb_sense sense, size_t n, const int *var,
                                          const double *coef, double constant)
{
    FMB_TRY(s ? expect_form(s, sense, constant) : FMB_ERR_ARG);
    FMB_TRY(fmb_system_add_terms(s, n, var, coef, FMB_LE, constant));
    return turn_last_row_into_objective(s, sense);
}

fmb_status fmb_system_set_objective_terms_int(fmb_system *s, fmb_sense sense, size_t n,
                                              const int *var, const int64_t *coef, int64_t constant)
{
    FMB_TRY(s ? expect_sense(s, sense) : FMB_ERR_ARG);
    FMB_TRY(fmb_system_add_terms_int(s, n, var, coef, FMB_LE, constant));
    return turn_last_row_into_objective(s, sense);
}

fmb_status fmb_system_set_objective_q(fmb_system *s, const fmb_objective_q *o)
{
    if (!s)
        return FMB_ERR_ARG;
    if (!o || o->sense == FMB_SENSE_NONE) {
        fmb_system_drop_objective(s);
        return FMB_OK;
    }
    FMB_TRY(expect_sense(s, o->sense));
    if (o->constant && mpz_sgn(mpq_denref(o->constant)) == 0)
        return fmb_system_refuse(s, "constant has denominator 0");
    mpq_t zero;
    mpq_init(zero);
    fmb_status st =
        fmb_system_add_q(s, o->n, o->var, o->coef, FMB_LE, o->constant ? o->constant : zero);
    mpq_clear(zero);
    return st == FMB_OK ? turn_last_row_into_objective(s, o->sense) : st;
}

fmb_status fmb_system_carry_objective(fmb_system *t, const fmb_system *s, const int *place)
{
    bool named = s->sense != FMB_SENSE_NONE;
    for (size_t k = 0; named && k < s->objective.nnz; k++)
        named = place[s->objective.var[k]] >= 0;
    if (!named)
        return FMB_OK;
    FMB_TRY(fmb_system_copy_row(t, &s->objective));
    fmb_sysrow *row = &t->row[t->rows - 1];
    for (size_t k = 0; k < row->nnz; k++)
        row->var[k] = place[row->var[k]];
    return turn_last_row_into_objective(t, s->sense);
}

fmb_sense fmb_system_sense(const fmb_system *s)
{
    return s ? s->sense : FMB_SENSE_NONE;
}
