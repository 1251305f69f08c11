/* lp_glpk.c: GLPK's dual simplex in doubles on the rows of a pair.
 *
 * Outside the clock: the programs; c and t are columns between 0 and 1, everything else is a row.
 * Inside: glp_simplex from the standard basis, which is dual feasible, as the objective is 0.
 */
#include <glpk.h>
#include <stdlib.h>

#include "common/message.h"
#include "fmb-qualify/scaling/scaling.h"
#include "study/rivals/rows.h"

struct scaling_lp {
    size_t n;
    glp_prob **program; /* [n]; NULL: the first frame has no inverse */
    fmb_verdict *verdict;
    glp_smcp how;
};

const char *scaling_lp_name(void)
{
    return "GLPK";
}

/* Does the row only bound one variable of the second frame, or time? */
static bool is_bound(const study_rows *s, int i)
{
    int variables = 0;
    for (int j = 0; j < s->n; j++)
        variables += s->a[i][j] != 0;
    return i >= s->facets && variables == 1;
}

static void put_row(glp_prob *lp, const study_rows *s, int i)
{
    int row = glp_add_rows(lp, 1), index[STUDY_ROWS_MOST_COLUMNS], terms = 0;
    double value[STUDY_ROWS_MOST_COLUMNS];
    for (int j = 0; j < s->n; j++)
        if (s->a[i][j] != 0) {
            index[++terms] = j + 1;
            value[terms] = s->a[i][j];
        }
    glp_set_mat_row(lp, row, terms, index, value);
    glp_set_row_bnds(lp, row, GLP_UP, 0, s->a[i][s->n]);
}

static glp_prob *program_of(const fmb_frame *p, const fmb_frame *q)
{
    study_rows s;
    if (!study_rows_make(p, q, 0, &s))
        return NULL;
    glp_prob *lp = glp_create_prob();
    glp_add_cols(lp, s.n);
    for (int j = 1; j <= s.n; j++)
        glp_set_col_bnds(lp, j, GLP_DB, 0, 1);
    for (int i = 0; i < s.m; i++)
        if (!is_bound(&s, i))
            put_row(lp, &s, i);
    return lp;
}

scaling_lp *scaling_lp_open(size_t n, const fmb_frame *p, const fmb_frame *q, fmb_verdict *verdict)
{
    scaling_lp *lp = app_need(calloc(1, sizeof *lp));
    lp->n = n;
    lp->program = app_need(calloc(n, sizeof(glp_prob *)));
    lp->verdict = verdict;
    glp_term_out(GLP_OFF);
    glp_init_smcp(&lp->how);
    lp->how.msg_lev = GLP_MSG_OFF;
    lp->how.meth = GLP_DUALP;
    for (size_t i = 0; i < n; i++)
        lp->program[i] = program_of(&p[i], &q[i]);
    return lp;
}

void scaling_lp_close(scaling_lp *lp)
{
    if (!lp)
        return;
    for (size_t i = 0; i < lp->n; i++)
        if (lp->program[i])
            glp_delete_prob(lp->program[i]);
    free(lp->program);
    free(lp);
}

static fmb_verdict decide(glp_prob *program, const glp_smcp *how)
{
    if (!program)
        return FMB_UNKNOWN;
    glp_std_basis(program);
    if (glp_simplex(program, how) != 0)
        return FMB_UNKNOWN;
    int status = glp_get_status(program);
    return status == GLP_OPT ? FMB_FEASIBLE : status == GLP_NOFEAS ? FMB_INFEASIBLE : FMB_UNKNOWN;
}

fmb_status scaling_lp_run(void *self, size_t first, size_t n)
{
    scaling_lp *lp = self;
    for (size_t i = first; i < first + n; i++)
        lp->verdict[i] = decide(lp->program[i], &lp->how);
    return FMB_OK;
}
