/* change_session.c: the public functions of sessions (<fmb/session.h>). */
#include <math.h>

#include "solve/query/solver.h"
#include "solve/session/session_state.h"

/* ---- load ------------------------------------------------------------------------------------ */

fmb_status fmb_solver_load(fmb_solver *v, const fmb_system *s)
{
    fmb_session *c;
    FMB_TRY(fmb_solver_expect(v, s, true, NULL));
    FMB_TRY(fmb_session_new(&v->mem, s, &v->handles, &c));
    fmb_session_free(v->session);
    v->session = c;
    v->error[0] = '\0';
    return FMB_OK;
}

void fmb_solver_unload(fmb_solver *v)
{
    if (!v)
        return;
    fmb_session_free(v->session);
    v->session = NULL;
}

const fmb_system *fmb_solver_system(const fmb_solver *v)
{
    return v && v->session ? v->session->s : NULL;
}

/* ---- rows by handle -------------------------------------------------------------------------- */

fmb_row fmb_solver_row(const fmb_solver *v, size_t number)
{
    return v && v->session && number < fmb_system_rows(v->session->s)
               ? v->session->row[number].handle
               : 0;
}

fmb_row fmb_solver_last_row(const fmb_solver *v)
{
    return fmb_solver_row(v, fmb_system_rows(fmb_solver_system(v)) - 1);
}

size_t fmb_solver_row_number(const fmb_solver *v, fmb_row row)
{
    return v && v->session ? fmb_session_find(v->session, row) : SIZE_MAX;
}

/* ---- changes --------------------------------------------------------------------------------- */

static fmb_status expect_loaded_system(fmb_solver *v)
{
    if (!v)
        return FMB_ERR_ARG;
    v->error[0] = '\0';
    return v->session ? FMB_OK : FMB_ERR_STATE;
}

static fmb_status expect_loaded_row(fmb_solver *v, size_t row)
{
    fmb_status st = expect_loaded_system(v);
    size_t rows = st == FMB_OK ? fmb_system_rows(v->session->s) : 0;
    if (st != FMB_OK || row < rows)
        return st;
    return fmb_solver_refuse(v, FMB_ERR_ARG, "row is %zu, but there are %zu", row, rows);
}

/* " (cap)" for a row with the label "cap"; "" for one without a label. */
static const char *describe_label(const fmb_solver *v, size_t row, char text[80])
{
    const char *label = fmb_system_label(v->session->s, row);
    snprintf(text, 80, "%s%.70s%s", label ? " (" : "", label ? label : "", label ? ")" : "");
    return text;
}

/* Refuse a right side for an existing row; what: the reason. */
static fmb_status refuse_right_side(fmb_solver *v, size_t row, const char *what)
{
    char label[80];
    return fmb_solver_refuse(v, FMB_ERR_ARG, "right side of row %zu%s %s", row,
                             describe_label(v, row, label), what);
}

static fmb_status begin_addition(fmb_solver *v)
{
    FMB_TRY(expect_loaded_system(v));
    return fmb_session_reserve(v->session);
}

/* Finish after appending a row with status st. */
static fmb_status end_addition(fmb_solver *v, fmb_status st)
{
    if (st == FMB_OK)
        fmb_session_note_added(v->session);
    else if (st == FMB_ERR_ARG)
        return fmb_solver_refuse(v, st, "%s", fmb_system_trouble(v->session->s));
    return st;
}

fmb_status fmb_solver_add(fmb_solver *v, const double *a, fmb_rel rel, double b)
{
    FMB_TRY(begin_addition(v));
    return end_addition(v, fmb_system_add(v->session->s, a, rel, b));
}

fmb_status fmb_solver_add_int(fmb_solver *v, const int64_t *a, fmb_rel rel, int64_t b)
{
    FMB_TRY(begin_addition(v));
    return end_addition(v, fmb_system_add_int(v->session->s, a, rel, b));
}

fmb_status fmb_solver_add_q(fmb_solver *v, size_t n, const int *var, mpq_t *coef, fmb_rel rel,
                            const mpq_t b)
{
    FMB_TRY(begin_addition(v));
    return end_addition(v, fmb_system_add_q(v->session->s, n, var, coef, rel, b));
}

fmb_status fmb_solver_remove(fmb_solver *v, size_t row)
{
    FMB_TRY(expect_loaded_row(v, row));
    FMB_TRY(fmb_session_reserve(v->session));
    fmb_session_remove(v->session, row);
    return FMB_OK;
}

fmb_status fmb_solver_set_right_q(fmb_solver *v, size_t row, const mpq_t b)
{
    FMB_TRY(expect_loaded_row(v, row));
    if (!b || mpz_sgn(mpq_denref(b)) == 0)
        return refuse_right_side(v, row, b ? "has denominator 0" : "is NULL");
    FMB_TRY(fmb_session_reserve(v->session));
    return fmb_session_set_right(v->session, row, b);
}

fmb_status fmb_solver_set_right(fmb_solver *v, size_t row, double b)
{
    FMB_TRY(expect_loaded_row(v, row));
    if (!isfinite(b))
        return refuse_right_side(v, row, isnan(b) ? "is nan" : "is infinite");
    mpq_t q;
    mpq_init(q);
    mpq_set_d(q, b);
    fmb_status st = fmb_solver_set_right_q(v, row, q);
    mpq_clear(q);
    return st;
}

fmb_status fmb_solver_set_label(fmb_solver *v, size_t row, const char *label)
{
    FMB_TRY(expect_loaded_row(v, row));
    FMB_TRY(fmb_session_reserve(v->session));
    return fmb_session_set_label(v->session, row, label);
}

fmb_status fmb_solver_add_variable(fmb_solver *v, const char *name, int *index)
{
    FMB_TRY(begin_addition(v));
    fmb_status st = fmb_system_add_variable(v->session->s, name, index);
    if (st == FMB_OK)
        fmb_session_note_variable(v->session);
    else if (st == FMB_ERR_ARG)
        return fmb_solver_refuse(v, st, "%s", fmb_system_trouble(v->session->s));
    return st;
}

/* ---- levels ---------------------------------------------------------------------------------- */

fmb_status fmb_solver_push(fmb_solver *v)
{
    FMB_TRY(expect_loaded_system(v));
    return fmb_session_push(v->session);
}

fmb_status fmb_solver_pop(fmb_solver *v)
{
    FMB_TRY(expect_loaded_system(v));
    if (v->session->levels == 0)
        return FMB_ERR_STATE;
    fmb_session_pop(v->session);
    return FMB_OK;
}
