/* solve.c: FMplex in place of fmb_solve's engines: the same parts, limits and claims. */
#include "solve/query/solver.h"
#include "study/fmplex/fmplex.h"

static fmb_status decide_part(fmb_query *q, const fmb_part *p, fmb_verdict *out)
{
    fmb_weights w = {0};
    bool feasible;
    fmb_status st = fmb_query_write_rows(q, (int)(p - q->parts.part));
    if (st == FMB_OK)
        st = study_fmplex_decide(&q->run, &q->v->arena, p->n, p->m, p->row, p->rel, &q->v->options,
                                 &feasible, q->evidence ? q->x : NULL, q->evidence ? &w : NULL);
    if (st == FMB_OK) {
        *out = feasible ? FMB_FEASIBLE : FMB_INFEASIBLE;
        if (feasible && q->evidence)
            fmb_query_scatter(p, q->x, q->point);
        else if (!feasible)
            st = fmb_query_claim_infeasible(q, p, &w);
    }
    fmb_weights_clear(&w, q->run.mem);
    return st;
}

static fmb_status decide_all_parts(fmb_query *q, fmb_verdict *out)
{
    fmb_verdict verdict = FMB_FEASIBLE;
    if (q->parts.false_row != SIZE_MAX) {
        *out = FMB_INFEASIBLE;
        return fmb_query_claim_false_row(q, q->parts.false_row);
    }
    fmb_status st = fmb_run_poll_now(&q->run);
    for (int c = 0; st == FMB_OK && verdict == FMB_FEASIBLE && c < q->parts.count; c++)
        st = decide_part(q, &q->parts.part[c], &verdict);
    if (st == FMB_OK && verdict == FMB_FEASIBLE)
        st = fmb_query_claim_feasible(q);
    if (st == FMB_OK)
        *out = verdict;
    return st;
}

fmb_status study_fmplex_solve(fmb_solver *v, const fmb_system *s, fmb_result *res)
{
    fmb_query q;
    fmb_verdict verdict = FMB_UNKNOWN;
    fmb_status st = fmb_query_begin(&q, v, s, "solve");
    if (st == FMB_OK)
        st = decide_all_parts(&q, &verdict);
    return fmb_query_end(&q, st, verdict, res);
}
