/* answer.c: the point or the conflict of the last answer, read from its evidence. */
#include "num/rationals.h"
#include "solve/query/solver.h"

/* The first claim of that kind in the evidence of the last answer, or NULL. */
static const fmb_claim *find_claim(const fmb_solver *v, fmb_claim_kind kind)
{
    const fmb_evidence *e = v && v->answered ? v->evidence : NULL;
    for (size_t i = 0; i < fmb_evidence_claims(e); i++)
        if (e->claim[i].kind == kind)
            return &e->claim[i];
    return NULL;
}

static fmb_status refuse_missing_claim(fmb_solver *v, const char *what)
{
    if (!v->answered)
        return fmb_solver_refuse(v, FMB_ERR_STATE, "no query has ended with an answer");
    if (!v->evidence)
        return fmb_solver_refuse(v, FMB_ERR_STATE,
                                 "the last query kept no evidence (options.evidence)");
    return fmb_solver_refuse(v, FMB_ERR_STATE, "the last answer has no %s", what);
}

/* ---- points ---------------------------------------------------------------------------------- */

fmb_status fmb_solver_point(fmb_solver *v, double *x)
{
    if (!v || !x)
        return fmb_solver_refuse(v, FMB_ERR_ARG, "x is NULL");
    const fmb_claim *c = find_claim(v, FMB_CLAIM_FEASIBLE);
    if (!c)
        return refuse_missing_claim(v, "point");
    for (int j = 0; j < v->evidence->dim; j++)
        x[j] = 0;
    for (size_t k = 0; k < c->point.size; k++)
        x[c->point.index[k]] = fmb_nearest_double(c->point.value[k]);
    return FMB_OK;
}

/* NULL: the coordinate is 0, or there is no point. */
static mpq_srcptr find_coordinate(const fmb_solver *v, int j)
{
    const fmb_claim *c = find_claim(v, FMB_CLAIM_FEASIBLE);
    return c && j >= 0 ? fmb_sparse_find(&c->point, (size_t)j) : NULL;
}

size_t fmb_solver_point_text(const fmb_solver *v, int j, char *text, size_t size)
{
    return fmb_rational_print(find_coordinate(v, j), text, size);
}

void fmb_solver_point_q(const fmb_solver *v, int j, mpq_t out)
{
    fmb_rational_give(find_coordinate(v, j), out);
}

/* ---- conflicts ------------------------------------------------------------------------------- */

fmb_status fmb_solver_conflict(fmb_solver *v, size_t *n)
{
    if (!v || !n)
        return fmb_solver_refuse(v, FMB_ERR_ARG, "n is NULL");
    const fmb_claim *c = find_claim(v, FMB_CLAIM_INFEASIBLE);
    if (!c)
        return refuse_missing_claim(v, "conflict");
    *n = c->multipliers.size;
    return FMB_OK;
}

size_t fmb_solver_conflict_row(const fmb_solver *v, size_t k)
{
    const fmb_claim *c = find_claim(v, FMB_CLAIM_INFEASIBLE);
    if (!c || k >= c->multipliers.size)
        return SIZE_MAX;
    if (!c->multipliers.mixed)
        return c->multipliers.index[k];
    size_t claim = (size_t)(c - v->evidence->claim);
    size_t row = fmb_evidence_next_row(v->evidence, claim, 0);
    for (; k > 0; k--)
        row = fmb_evidence_next_row(v->evidence, claim, row + 1);
    return row;
}

/* NULL: there is no such multiplier. */
static mpq_srcptr find_conflict_multiplier(const fmb_solver *v, size_t k)
{
    const fmb_claim *c = find_claim(v, FMB_CLAIM_INFEASIBLE);
    return c ? fmb_sparse_find(&c->multipliers, fmb_solver_conflict_row(v, k)) : NULL;
}

double fmb_solver_conflict_multiplier(const fmb_solver *v, size_t k)
{
    return fmb_nearest_double(find_conflict_multiplier(v, k));
}

size_t fmb_solver_conflict_multiplier_text(const fmb_solver *v, size_t k, char *text, size_t size)
{
    return fmb_rational_print(find_conflict_multiplier(v, k), text, size);
}

void fmb_solver_conflict_multiplier_q(const fmb_solver *v, size_t k, mpq_t out)
{
    fmb_rational_give(find_conflict_multiplier(v, k), out);
}
