/* peer_glpk.c: GLPK's dual simplex in doubles, for verdicts.
 *
 * Outside the clock: the program (rows of one variable as rows too, as any caller would have them).
 * Inside: glp_simplex from the standard basis, GLP_DUALP, no presolver; with objective 0 the
 * standard basis is dual feasible. Doubles and a tolerance: a wrong verdict counts as inexact. No
 * strict rows.
 */
#include <glpk.h>
#include <stdlib.h>

#include "peers.h"

typedef struct state {
    glp_prob *program;
} state;

static void add_row(glp_prob *lp, const problem_row *r, int n, int *index, double *value)
{
    int row = glp_add_rows(lp, 1), terms = 0;
    double b = mpz_get_d(r->a[n]);
    for (int j = 0; j < n; j++) {
        if (mpz_sgn(r->a[j]) == 0)
            continue;
        index[++terms] = j + 1;
        value[terms] = mpz_get_d(r->a[j]);
    }
    glp_set_mat_row(lp, row, terms, index, value);
    glp_set_row_bnds(lp, row, r->rel == FMB_EQ ? GLP_FX : GLP_UP, b, b);
}

static void *open_glpk(const problem *p, const peer_setup *setup)
{
    (void)setup;
    if (p->strict || p->n == 0)
        return NULL;
    state *s = need(calloc(1, sizeof *s));
    int *index = need(calloc((size_t)p->n + 1, sizeof *index));
    double *value = need(calloc((size_t)p->n + 1, sizeof *value));
    glp_term_out(GLP_OFF);
    s->program = glp_create_prob();
    glp_add_cols(s->program, p->n);
    for (int j = 1; j <= p->n; j++)
        glp_set_col_bnds(s->program, j, GLP_FR, 0, 0);
    for (size_t i = 0; i < p->m; i++)
        add_row(s->program, &p->rows[i], p->n, index, value);
    free(index);
    free(value);
    return s;
}

static void ready_glpk(void *self)
{
    state *s = self;
    glp_std_basis(s->program);
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

static void close_glpk(void *self)
{
    state *s = self;
    glp_delete_prob(s->program);
    free(s);
}

const peer peer_glpk = {
    .name = "glpk",
    .library = "glpk",
    .inexact = true,
    .open = open_glpk,
    .ready = ready_glpk,
    .decide = decide_glpk,
    .close = close_glpk,
};
