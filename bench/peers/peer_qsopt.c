/* peer_qsopt.c: QSopt_ex, exact linear programming, for verdicts.
 *
 * Outside the clock: the program with objective 0 and free columns, and a copy of it for each run.
 * Inside: QSexact_solver with the dual simplex (doubles, then more digits, then rationals until the
 * answer is exact). No strict rows.
 */
#include <stdlib.h>

#include <qsopt_ex/QSopt_ex.h>

#include "peers.h"

typedef struct state {
    mpq_QSprob program, work;
} state;

static bool add_row(mpq_QSprob q, const problem_row *r, int n)
{
    int *index = need(calloc((size_t)n + 1, sizeof *index)), terms = 0;
    mpq_t *value = need(calloc((size_t)n + 1, sizeof *value));
    for (int j = 0; j < n; j++) {
        mpq_init(value[j]);
        if (mpz_sgn(r->a[j]) == 0)
            continue;
        index[terms] = j;
        mpq_set_z(value[terms++], r->a[j]);
    }
    mpq_init(value[n]);
    mpq_set_z(value[n], r->a[n]);
    bool good = mpq_QSadd_row(q, terms, index, (const mpq_t *)value, (const mpq_t *)&value[n],
                              r->rel == FMB_EQ ? 'E' : 'L', NULL) == 0;
    for (int j = 0; j <= n; j++)
        mpq_clear(value[j]);
    free(index);
    free(value);
    return good;
}

static void *open_qsopt(const problem *p, const peer_setup *setup)
{
    (void)setup;
    if (p->strict || p->n == 0)
        return NULL;
    if (!__QSexact_setup)
        QSexactStart();
    state *s = need(calloc(1, sizeof *s));
    bool good = true;
    mpq_t zero;
    mpq_init(zero);
    s->program = need(mpq_QScreate_prob("problem", QS_MIN));
    for (int j = 0; j < p->n; j++)
        good &= mpq_QSnew_col(s->program, zero, mpq_ILL_MINDOUBLE, mpq_ILL_MAXDOUBLE, NULL) == 0;
    for (size_t i = 0; i < p->m; i++)
        good &= add_row(s->program, &p->rows[i], p->n);
    mpq_clear(zero);
    return good ? s : NULL;
}

static void forget(state *s)
{
    if (s->work)
        mpq_QSfree_prob(s->work);
    s->work = NULL;
}

static void ready_qsopt(void *self)
{
    state *s = self;
    forget(s);
    s->work = need(mpq_QScopy_prob(s->program, "copy"));
}

static fmb_verdict decide_qsopt(void *self)
{
    state *s = self;
    int status = 0;
    if (QSexact_solver(s->work, NULL, NULL, NULL, DUAL_SIMPLEX, &status) != 0)
        return FMB_UNKNOWN;
    return status == QS_LP_OPTIMAL      ? FMB_FEASIBLE
           : status == QS_LP_INFEASIBLE ? FMB_INFEASIBLE
                                        : FMB_UNKNOWN;
}

static void close_qsopt(void *self)
{
    state *s = self;
    forget(s);
    mpq_QSfree_prob(s->program);
    free(s);
}

const peer peer_qsopt = {
    .name = "qsopt",
    .library = "qsopt",
    .open = open_qsopt,
    .ready = ready_qsopt,
    .decide = decide_qsopt,
    .close = close_qsopt,
};
