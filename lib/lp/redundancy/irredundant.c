/* irredundant.c: removing redundant rows one after another; see irredundant.h. */
#include "lp/redundancy/irredundant.h"

#include "lp/dictionary/dictionary_read.h"
#include "lp/redundancy/active_test.h"
#include "num/rationals.h"

typedef struct pass {
    fmb_lp *lp;
    const fmb_rel *rel;
    fmb_fate *fate;
    bool *slack; /* [m] known to be positive somewhere */
    const fmb_verdicts *told;
    bool as_given;  /* inequalities stay inequalities */
    mpq_t *x;       /* [n] scratch */
    double *center; /* [n] roughly inside: the mean of the points seen */
    size_t points;  /* so far, of which center is the sum */
} pass;

/* Multipliers at hand: the minimum (-1) or maximum (1) of a slack. */
static fmb_status tell_with_multipliers(pass *p, size_t i, int sign,
                                        fmb_status (*whom)(void *, size_t, const fmb_weights *))
{
    fmb_weights w = {0};
    if (!whom)
        return FMB_OK;
    fmb_status st = fmb_lp_optimum(p->lp, sign, &w);
    if (st == FMB_OK)
        st = whom(p->told->self, i, &w);
    fmb_weights_clear(&w, p->lp->run->mem);
    return st;
}

static fmb_status drop_redundant_row(pass *p, size_t i)
{
    p->fate[i] = FMB_FATE_REDUNDANT;
    return tell_with_multipliers(p, i, -1, p->told ? p->told->redundant : NULL);
}

/* ---- equalities ------------------------------------------------------------------------------ */

static fmb_status lock_equality_row(pass *p, size_t i)
{
    bool depends;
    fmb_status st = fmb_lp_lock(p->lp, i, &depends);
    if (st != FMB_OK)
        return st;
    if (depends)
        return drop_redundant_row(p, i);
    p->fate[i] = FMB_FATE_KEPT;
    return FMB_OK;
}

/* Every slack that is positive at the current point is no implicit equality. */
static void note_positive_slacks(pass *p)
{
    fmb_lp_add_point(p->lp, p->center);
    p->points++;
    for (size_t i = 0; i < p->lp->m; i++)
        p->slack[i] = p->slack[i] || fmb_lp_is_slack(p->lp, i);
}

/* A strict row is never tight on a feasible system. Otherwise the largest slack decides. */
static fmb_status find_implicit_equality(pass *p, size_t i)
{
    fmb_lp_end end;
    bool depends;
    if (p->slack[i])
        return FMB_OK;
    fmb_status st = fmb_lp_widen_slack(p->lp, i, &end);
    if (st == FMB_OK)
        note_positive_slacks(p);
    if (st != FMB_OK || end != FMB_LP_OPTIMUM || p->as_given)
        return st;
    fmb_weights reverse = {0};
    st = fmb_lp_optimum(p->lp, 1, &reverse);
    if (st == FMB_OK)
        st = fmb_lp_lock(p->lp, i, &depends);
    if (st == FMB_OK && depends) {
        st = drop_redundant_row(p, i);
    } else if (st == FMB_OK) {
        p->fate[i] = FMB_FATE_EQUALITY;
        if (p->told && p->told->equality)
            st = p->told->equality(p->told->self, i, &reverse);
    }
    fmb_weights_clear(&reverse, p->lp->run->mem);
    return st;
}

/* ---- inequalities ---------------------------------------------------------------------------- */

static fmb_status test_row_redundant(pass *p, size_t i)
{
    fmb_lp_end end;
    fmb_status st = fmb_lp_test_active(p->lp, i, p->center, p->x, &end);
    if (st != FMB_OK)
        return st;
    if (end == FMB_LP_OPTIMUM)
        return drop_redundant_row(p, i);
    p->fate[i] = FMB_FATE_KEPT;
    if (p->told && p->told->irredundant)
        st = p->told->irredundant(p->told->self, i, p->x);
    return st == FMB_OK ? fmb_lp_restore(p->lp) : st;
}

/* With fewer rows sleeping saves nothing. */
#define MANY_ROWS 64

static void prepare_active_tests(pass *p)
{
    for (int j = 0; p->points > 0 && j < p->lp->n; j++)
        p->center[j] /= (double)p->points;
    if (p->lp->m >= MANY_ROWS)
        fmb_lp_deactivate(p->lp);
}

static fmb_status run_three_passes(pass *p)
{
    fmb_status st = FMB_OK;
    size_t m = p->lp->m;
    for (size_t i = 0; st == FMB_OK && i < m; i++)
        if (p->rel[i] == FMB_EQ)
            st = lock_equality_row(p, i);
    note_positive_slacks(p);
    for (size_t i = 0; st == FMB_OK && i < m; i++)
        if (p->rel[i] == FMB_LE && p->fate[i] == FMB_FATE_UNKNOWN)
            st = find_implicit_equality(p, i);
    prepare_active_tests(p);
    for (size_t i = m; st == FMB_OK && i-- > 0;)
        if (p->fate[i] == FMB_FATE_UNKNOWN)
            st = test_row_redundant(p, i);
    return st;
}

static fmb_status allocate_pass(pass *p)
{
    fmb_mem *mem = p->lp->run->mem;
    p->slack = fmb_mem_zero(mem, p->lp->m, sizeof *p->slack);
    p->center = fmb_mem_zero(mem, (size_t)p->lp->n, sizeof *p->center);
    if (!p->slack || !p->center)
        return fmb_mem_status(mem);
    return fmb_rationals_new(&p->x, (size_t)p->lp->n, mem);
}

static fmb_status decide_rows_in_passes(pass *p)
{
    fmb_mem *mem = p->lp->run->mem;
    fmb_status st = allocate_pass(p);
    if (st == FMB_OK)
        st = run_three_passes(p);
    fmb_rationals_free(p->x, (size_t)p->lp->n, mem);
    fmb_mem_put(mem, p->center, (size_t)p->lp->n, sizeof *p->center);
    fmb_mem_put(mem, p->slack, p->lp->m, sizeof *p->slack);
    return st;
}

fmb_status fmb_irredundant(fmb_lp *lp, const fmb_rel *rel, fmb_fate *fate, const fmb_verdicts *told)
{
    return decide_rows_in_passes(&(pass){.lp = lp, .rel = rel, .fate = fate, .told = told});
}

fmb_status fmb_redundant(fmb_lp *lp, const fmb_rel *rel, fmb_fate *fate)
{
    return decide_rows_in_passes(&(pass){.lp = lp, .rel = rel, .fate = fate, .as_given = true});
}
