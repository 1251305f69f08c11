/* job.c: claims for the ends of variables; see job.h. */
#include "solve/bound/job.h"

fmb_status fmb_bound_claim(fmb_bound_job *j, const fmb_weights *w)
{
    fmb_query *q = j->q;
    fmb_claim *claim;
    FMB_TRY(fmb_evidence_claim(q->claims, FMB_CLAIM_BOUND, &claim));
    claim->var = j->var;
    claim->side = j->side;
    claim->rel = j->end->attained ? FMB_LE : FMB_LT;
    mpq_set(claim->value, j->end->value);
    fmb_status st = fmb_query_push(q, j->p, w, SIZE_MAX, 1, &claim->multipliers);
    FMB_THEN(st, fmb_query_attach_point(q, claim, j->p, j->q->x));
    return fmb_query_finish_claim(q, st);
}

fmb_status fmb_bound_claim_unbounded(fmb_bound_job *j)
{
    fmb_claim *claim;
    if (!j->q->claims)
        return FMB_OK;
    fmb_status st = fmb_evidence_claim(j->q->claims, FMB_CLAIM_UNBOUNDED, &claim);
    if (st != FMB_OK)
        return st;
    claim->var = j->var;
    claim->side = j->side;
    if (j->p) {
        st = fmb_evidence_push_all(j->q->claims, &claim->ray, (size_t)j->p->n, j->p->var, j->q->x);
    } else {
        mpq_set_si(j->q->x[0], j->sign, 1);
        st = fmb_evidence_push(j->q->claims, &claim->ray, (size_t)j->var, j->q->x[0]);
    }
    FMB_THEN(st, fmb_run_poll(&j->q->run));
    return fmb_query_finish_claim(j->q, st);
}
