/* peer_glpk.c: GLPK's simplex in doubles, for verdicts, boxes and optima.
 *
 * Outside the clock: the program (rows of one variable as rows too, as any caller would have them).
 * Inside: glp_simplex from the standard basis, GLP_DUALP, no presolver; with objective 0 the
 * standard basis is dual feasible. A box takes the primal simplex 2n times, each time from where
 * the last one ended; an optimum once, from the standard basis. Doubles and a tolerance: a wrong
 * verdict counts as inexact. No strict rows.
 */
#include <glpk.h>
#include <math.h>
#include <stdlib.h>

#include <fmb/gmp.h>

#include "peers.h"

typedef struct state {
    glp_prob *program;
    const problem *problem;
    peer_question question;
    peer_numbers numbers;
} state;

/* Row i with its original numbers: integers might exceed the range of doubles. */
static void add_row(glp_prob *lp, const fmb_system *s, size_t i, int *index, double *value)
{
    int row = glp_add_rows(lp, 1), terms = (int)fmb_system_terms(s, i);
    mpq_t q;
    mpq_init(q);
    for (int k = 0; k < terms; k++) {
        index[k + 1] = fmb_system_term_q(s, i, (size_t)k, q) + 1;
        value[k + 1] = mpq_get_d(q);
    }
    fmb_system_rhs_q(s, i, q);
    double b = mpq_get_d(q);
    glp_set_mat_row(lp, row, terms, index, value);
    glp_set_row_bnds(lp, row, fmb_system_rel(s, i) == FMB_EQ ? GLP_FX : GLP_UP, b, b);
    mpq_clear(q);
}

static void *open_glpk(const problem *p, const peer_setup *setup)
{
    if (p->strict || p->n == 0)
        return NULL;
    state *s = need(calloc(1, sizeof *s));
    int *index = need(calloc((size_t)p->n + 1, sizeof *index));
    double *value = need(calloc((size_t)p->n + 1, sizeof *value));
    s->problem = p;
    s->question = setup->question;
    s->numbers.value = need(calloc(2 * (size_t)p->n, sizeof(double)));
    glp_term_out(GLP_OFF);
    s->program = glp_create_prob();
    glp_add_cols(s->program, p->n);
    for (int j = 1; j <= p->n; j++)
        glp_set_col_bnds(s->program, j, GLP_FR, 0, 0);
    for (size_t i = 0; i < p->m; i++)
        add_row(s->program, p->system, i, index, value);
    free(index);
    free(value);
    return s;
}

static void load_objective(state *s)
{
    const fmb_system *from = s->problem->system;
    mpq_t q;
    mpq_init(q);
    for (size_t k = 0; k < fmb_system_objective_terms(from); k++) {
        int j = fmb_system_objective_term_q(from, k, q);
        glp_set_obj_coef(s->program, j + 1, mpq_get_d(q));
    }
    fmb_system_objective_constant_q(from, q);
    glp_set_obj_coef(s->program, 0, mpq_get_d(q));
    mpq_clear(q);
}

static void ready_glpk(void *self)
{
    state *s = self;
    glp_std_basis(s->program);
    for (int j = 0; j <= s->problem->n; j++)
        glp_set_obj_coef(s->program, j, 0);
    if (s->question == PEER_OPTIMIZE)
        load_objective(s);
    s->numbers.n = 0;
}

static fmb_verdict decide_glpk(void *self)
{
    state *s = self;
    glp_smcp how;
    glp_init_smcp(&how);
    how.msg_lev = GLP_MSG_OFF;
    how.meth = GLP_DUALP;
    if (glp_simplex(s->program, &how) != 0)
        return FMB_UNKNOWN;
    int status = glp_get_status(s->program);
    return status == GLP_OPT ? FMB_FEASIBLE : status == GLP_NOFEAS ? FMB_INFEASIBLE : FMB_UNKNOWN;
}

/* Optimize from the last basis: FEASIBLE, and the optimum is noted. */
static fmb_verdict optimize_further(state *s, int direction)
{
    glp_smcp how;
    glp_init_smcp(&how);
    how.msg_lev = GLP_MSG_OFF;
    how.meth = GLP_PRIMAL;
    glp_set_obj_dir(s->program, direction);
    if (glp_simplex(s->program, &how) != 0)
        return FMB_UNKNOWN;
    int status = glp_get_status(s->program);
    if (status == GLP_NOFEAS)
        return FMB_INFEASIBLE;
    if (status != GLP_OPT && status != GLP_UNBND)
        return FMB_UNKNOWN;
    double infinity = direction == GLP_MAX ? INFINITY : -INFINITY;
    s->numbers.value[s->numbers.n++] = status == GLP_OPT ? glp_get_obj_val(s->program) : infinity;
    return FMB_FEASIBLE;
}

static fmb_verdict box_glpk(void *self)
{
    state *s = self;
    fmb_verdict v = FMB_FEASIBLE;
    for (int j = 1; j <= s->problem->n && v == FMB_FEASIBLE; j++) {
        glp_set_obj_coef(s->program, j, 1);
        v = optimize_further(s, GLP_MIN);
        if (v == FMB_FEASIBLE)
            v = optimize_further(s, GLP_MAX);
        glp_set_obj_coef(s->program, j, 0);
    }
    return v;
}

static fmb_verdict optimize_glpk(void *self)
{
    state *s = self;
    fmb_sense sense = fmb_system_sense(s->problem->system);
    return sense ? optimize_further(s, sense == FMB_SENSE_MAX ? GLP_MAX : GLP_MIN) : FMB_UNKNOWN;
}

static const peer_numbers *numbers_glpk(void *self)
{
    state *s = self;
    return &s->numbers;
}

static void close_glpk(void *self)
{
    state *s = self;
    glp_delete_prob(s->program);
    free(s->numbers.value);
    free(s);
}

const peer peer_glpk = {
    .name = "glpk",
    .library = "glpk",
    .inexact = true,
    .open = open_glpk,
    .ready = ready_glpk,
    .decide = decide_glpk,
    .box = box_glpk,
    .optimize = optimize_glpk,
    .numbers = numbers_glpk,
    .close = close_glpk,
};
