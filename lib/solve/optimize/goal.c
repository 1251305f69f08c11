/* goal.c: see goal.h. */
#include "solve/optimize/goal.h"

#include <math.h>

#include "num/rationals.h"
#include "system/system_private.h"

/* ---- what it may be -------------------------------------------------------------------------- */

static fmb_status expect_sense(fmb_solver *v, fmb_sense sense)
{
    return sense == FMB_SENSE_MAX || sense == FMB_SENSE_MIN
               ? FMB_OK
               : fmb_solver_refuse(v, FMB_ERR_ARG, "objective->sense is neither MAX nor MIN");
}

static fmb_status expect_doubles(fmb_solver *v, const fmb_system *s, const fmb_objective *o)
{
    fmb_status st = expect_sense(v, o->sense);
    int dim = fmb_system_dim(s);
    if (st == FMB_OK && dim > 0 && !o->coef)
        return fmb_solver_refuse(v, FMB_ERR_ARG, "objective->coef is NULL");
    for (int j = 0; st == FMB_OK && j < dim; j++)
        if (!isfinite(o->coef[j]))
            st = fmb_solver_refuse(v, FMB_ERR_ARG, "objective->coef[%d] is %g", j, o->coef[j]);
    if (st == FMB_OK && !isfinite(o->constant))
        st = fmb_solver_refuse(v, FMB_ERR_ARG, "objective->constant is %g", o->constant);
    return st;
}

static fmb_status expect_rationals(fmb_solver *v, const fmb_system *s, const fmb_objective_q *o)
{
    fmb_status st = expect_sense(v, o->sense);
    int dim = fmb_system_dim(s);
    if (st == FMB_OK && o->n > 0 && (!o->var || !o->coef))
        return fmb_solver_refuse(v, FMB_ERR_ARG, "objective->%s is NULL", o->var ? "coef" : "var");
    for (size_t k = 0; st == FMB_OK && k < o->n; k++)
        if (o->var[k] < 0 || o->var[k] >= dim)
            st = fmb_solver_refuse(v, FMB_ERR_ARG,
                                   "objective->var[%zu] is %d, but there are %d variables", k,
                                   o->var[k], dim);
        else if (mpz_sgn(mpq_denref(o->coef[k])) == 0)
            st = fmb_solver_refuse(v, FMB_ERR_ARG, "objective->coef[%zu] has denominator 0", k);
    if (st == FMB_OK && o->constant && mpz_sgn(mpq_denref(o->constant)) == 0)
        st = fmb_solver_refuse(v, FMB_ERR_ARG, "objective->constant has denominator 0");
    return st;
}

fmb_status fmb_goal_expect(fmb_solver *v, const fmb_system *s, fmb_wish wish)
{
    if (wish.doubles)
        return expect_doubles(v, s, wish.doubles);
    if (wish.rationals)
        return expect_rationals(v, s, wish.rationals);
    return fmb_system_sense(s) != FMB_SENSE_NONE
               ? FMB_OK
               : fmb_solver_refuse(v, FMB_ERR_ARG,
                                   "objective is NULL, and the system has no objective");
}

fmb_sense fmb_wish_sense(const fmb_system *s, fmb_wish wish)
{
    return wish.doubles     ? wish.doubles->sense
           : wish.rationals ? wish.rationals->sense
                            : fmb_system_sense(s);
}

/* ---- filling it ------------------------------------------------------------------------------ */

static void fill_from_doubles(fmb_goal *g, const fmb_objective *o)
{
    for (size_t j = 0; j < g->dim; j++)
        mpq_set_d(g->coef[j], o->coef[j]);
    mpq_set_d(g->constant, o->constant);
}

/* to += from, where from need not be in lowest terms. */
static void add_any_rational(mpq_t to, mpq_srcptr from)
{
    mpq_t t;
    mpq_init(t);
    mpz_set(mpq_numref(t), mpq_numref(from));
    mpz_set(mpq_denref(t), mpq_denref(from));
    mpq_canonicalize(t);
    mpq_add(to, to, t);
    mpq_clear(t);
}

static void fill_from_rationals(fmb_goal *g, const fmb_objective_q *o)
{
    for (size_t k = 0; k < o->n; k++)
        add_any_rational(g->coef[o->var[k]], o->coef[k]);
    if (o->constant)
        add_any_rational(g->constant, o->constant);
}

static void fill_from_system(fmb_goal *g, const fmb_system *s)
{
    mpq_t q;
    mpq_init(q);
    for (size_t k = 0; k < fmb_system_objective_terms(s); k++) {
        int j = fmb_system_objective_term_q(s, k, q);
        mpq_set(g->coef[j], q);
    }
    fmb_system_objective_constant_q(s, g->constant);
    mpq_clear(q);
}

fmb_status fmb_goal_init(fmb_goal *g, const fmb_system *s, fmb_wish wish, fmb_mem *mem)
{
    *g = (fmb_goal){.dim = (size_t)fmb_system_dim(s)};
    mpq_init(g->constant);
    FMB_TRY(fmb_rationals_new(&g->coef, g->dim, mem));
    g->sense = fmb_wish_sense(s, wish);
    if (wish.doubles)
        fill_from_doubles(g, wish.doubles);
    else if (wish.rationals)
        fill_from_rationals(g, wish.rationals);
    else
        fill_from_system(g, s);
    for (size_t j = 0; g->sense == FMB_SENSE_MIN && j < g->dim; j++)
        mpq_neg(g->coef[j], g->coef[j]);
    return FMB_OK;
}

void fmb_goal_clear(fmb_goal *g, fmb_mem *mem)
{
    fmb_rationals_free(g->coef, g->dim, mem);
    mpq_clear(g->constant);
}

bool fmb_goal_names(const fmb_goal *g, const int *var, int n)
{
    for (int j = 0; j < n; j++)
        if (mpq_sgn(g->coef[var[j]]) != 0)
            return true;
    return false;
}
