/* claims.c: what the verbs write into the evidence; see solver.h. */
#include "elim/derive.h"
#include "solve/solver.h"

fmb_status fmb_query_push(fmb_query *q, const fmb_part *p, const fmb_weights *w, size_t target,
                          int sign, fmb_sparse *list)
{
    fmb_status st = FMB_OK;
    mpq_t t, unit;
    mpq_inits(t, unit, NULL);
    mpq_set_si(unit, sign, 1);
    if (target != SIZE_MAX) {
        fmb_part_scale(q->s, p->source[target], t);
        mpq_div(unit, unit, t);
    }
    for (size_t i = 0; st == FMB_OK && i < w->size; i++) {
        size_t source = p->source[w->index[i]];
        fmb_part_scale(q->s, source, t);
        mpq_mul(t, t, w->value[i]);
        mpq_mul(t, t, unit);
        st = fmb_evidence_push(q->evidence, list, source, t);
    }
    mpq_clears(t, unit, NULL);
    return st;
}

/* Open a claim of that kind; the caller fills it and hands the status to settle. */
static fmb_status settle(fmb_query *q, fmb_status st)
{
    if (st != FMB_OK)
        fmb_evidence_drop_last(q->evidence);
    return st;
}

fmb_status fmb_query_claim_infeasible(fmb_query *q, const fmb_part *p, const fmb_weights *w)
{
    fmb_claim *claim;
    if (!q->evidence)
        return FMB_OK;
    fmb_evidence_reset(q->evidence);
    fmb_status st = fmb_evidence_claim(q->evidence, FMB_CLAIM_INFEASIBLE, &claim);
    return st != FMB_OK ? st : settle(q, fmb_query_push(q, p, w, SIZE_MAX, 1, &claim->multipliers));
}

fmb_status fmb_query_claim_clash(fmb_query *q, const fmb_part *p, const fmb_elim *e)
{
    if (!q->evidence)
        return FMB_OK;
    const fmb_derived *r = &e->row[e->clash];
    fmb_weights w = {0};
    mpq_t one; /* 0 = positive is an equality: turn it round */
    mpq_init(one);
    mpq_set_si(one, fmb_vec_sgn(&r->v, (size_t)e->n) > 0 ? -1 : 1, 1);
    fmb_status st = fmb_weights_add(&w, e->clash, one, q->run.mem);
    if (st == FMB_OK)
        st = fmb_elim_derive(e, &w);
    if (st == FMB_OK)
        st = fmb_query_claim_infeasible(q, p, &w);
    fmb_weights_clear(&w, q->run.mem);
    mpq_clear(one);
    return st;
}

fmb_status fmb_query_claim_false_row(fmb_query *q, size_t i)
{
    fmb_claim *claim;
    if (!q->evidence)
        return FMB_OK;
    fmb_status st = fmb_evidence_claim(q->evidence, FMB_CLAIM_INFEASIBLE, &claim);
    if (st != FMB_OK)
        return st;
    mpq_t b;
    mpq_init(b);
    fmb_system_rhs_q(q->s, i, b);
    mpq_set_si(b, mpq_sgn(b) > 0 ? -1 : 1, 1); /* 0 = positive is an equality: turn it round */
    st = fmb_evidence_push(q->evidence, &claim->multipliers, i, b);
    mpq_clear(b);
    return settle(q, st);
}

void fmb_query_scatter(const fmb_part *p, mpq_t *x, mpq_t *dense)
{
    for (int j = 0; j < p->n; j++)
        mpq_set(dense[p->var[j]], x[j]);
}

fmb_status fmb_query_attach_point(fmb_query *q, fmb_claim *claim, const fmb_part *p, mpq_t *x)
{
    fmb_status st = fmb_run_poll(&q->run);
    if (st == FMB_OK)
        st = fmb_evidence_vector(q->evidence, &claim->point);
    if (st != FMB_OK)
        return st;
    for (int j = 0; j < fmb_system_dim(q->s); j++)
        mpq_set(claim->point[j], q->point[j]);
    if (x)
        fmb_query_scatter(p, x, claim->point);
    return FMB_OK;
}

fmb_status fmb_query_claim_feasible(fmb_query *q)
{
    fmb_claim *claim;
    if (!q->evidence)
        return FMB_OK;
    fmb_status st = fmb_evidence_claim(q->evidence, FMB_CLAIM_FEASIBLE, &claim);
    return st != FMB_OK ? st : settle(q, fmb_query_attach_point(q, claim, NULL, NULL));
}
