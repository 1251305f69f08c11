/* bound.c: the tightest interval of each variable.
 *
 * Each end is a linear program in the variable's own part, from the dictionary of the end before.
 * With method fm the part's other variables are eliminated instead (bound_fm.c). At a limit, the
 * ends not yet known are the best that is proved at little cost (outer.h).
 */
#include "solve/bound.h"

#include "solve/outer.h"

/* ---- claims ---------------------------------------------------------------------------------- */

fmb_status fmb_bound_claim(fmb_bound_job *j, const fmb_weights *w)
{
    fmb_query *q = j->q;
    fmb_claim *claim;
    fmb_status st = fmb_evidence_claim(q->evidence, FMB_CLAIM_BOUND, &claim);
    if (st != FMB_OK)
        return st;
    claim->var = j->var;
    claim->side = j->side;
    claim->rel = j->end->attained ? FMB_LE : FMB_LT;
    mpq_set(claim->value, j->end->value);
    st = fmb_query_push(q, j->p, w, SIZE_MAX, 1, &claim->multipliers);
    if (st == FMB_OK)
        st = fmb_query_attach_point(q, claim, j->p, j->q->x);
    if (st != FMB_OK)
        fmb_evidence_drop_last(q->evidence);
    return st;
}

fmb_status fmb_bound_claim_unbounded(fmb_bound_job *j)
{
    fmb_claim *claim;
    if (!j->q->evidence)
        return FMB_OK;
    fmb_status st = fmb_evidence_claim(j->q->evidence, FMB_CLAIM_UNBOUNDED, &claim);
    if (st != FMB_OK)
        return st;
    claim->var = j->var;
    claim->side = j->side;
    st = fmb_evidence_vector(j->q->evidence, &claim->ray);
    if (st != FMB_OK)
        fmb_evidence_drop_last(j->q->evidence);
    else if (j->p)
        fmb_query_scatter(j->p, j->q->x, claim->ray);
    else
        mpq_set_si(claim->ray[j->var], j->sign, 1);
    return st;
}

/* ---- by the oracle --------------------------------------------------------------------------- */

static fmb_status finish_optimum(fmb_bound_job *j, const fmb_lp *lp)
{
    int step;
    fmb_weights w = {0};
    fmb_lp_value(lp, j->end->value, &step);
    j->end->attained = step == 0;
    fmb_status st = FMB_OK;
    if (j->q->evidence) {
        st = fmb_lp_optimum(lp, j->sign, &w);
        if (st == FMB_OK)
            st = fmb_lp_point(lp, !j->end->attained, j->q->x);
        if (st == FMB_OK)
            st = fmb_bound_claim(j, &w);
    }
    fmb_weights_clear(&w, j->q->run.mem);
    if (st == FMB_OK)
        j->end->kind = FMB_END_FINITE;
    return st;
}

static fmb_status ask_oracle(fmb_bound_job *j, int part)
{
    fmb_lp *lp;
    fmb_lp_end end;
    fmb_status st = fmb_query_oracle(j->q, part, &lp);
    if (st == FMB_OK)
        st = fmb_lp_extreme(lp, j->column, j->sign, &end);
    if (st != FMB_OK)
        return st;
    if (end == FMB_LP_OPTIMUM)
        return finish_optimum(j, lp);
    if (j->q->evidence)
        fmb_lp_ray(lp, j->q->x);
    st = fmb_bound_claim_unbounded(j);
    if (st == FMB_OK)
        j->end->kind = FMB_END_INFINITE;
    return st;
}

/* ---- all of them ----------------------------------------------------------------------------- */

static fmb_status bound_by_oracle(fmb_query *q, int var, fmb_exact_side *side)
{
    int part = q->parts.of_var[var];
    fmb_bound_job j = {.q = q, .var = var};
    fmb_status st = FMB_OK;
    if (part >= 0) {
        j.p = &q->parts.part[part];
        j.column = q->parts.place[var];
    }
    for (int k = FMB_LOWER; st == FMB_OK && k <= FMB_UPPER; k++) {
        j.side = (fmb_side)k;
        j.sign = k == FMB_LOWER ? -1 : 1;
        j.end = &side[k];
        if (part >= 0) {
            st = ask_oracle(&j, part);
        } else {
            st = fmb_bound_claim_unbounded(&j);
            j.end->kind = st == FMB_OK ? FMB_END_INFINITE : FMB_END_UNKNOWN;
        }
    }
    return st;
}

static fmb_status bound_all(fmb_query *q, fmb_box *box)
{
    bool fm = fmb_query_eliminates(q);
    fmb_status st = FMB_OK;
    for (int c = 0; st == FMB_OK && fm && c < q->parts.count; c++)
        st = fmb_bound_by_elimination(q, c, box);
    for (int i = 0; st == FMB_OK && i < box->size; i++)
        if (!fm || q->parts.of_var[box->var[i]] < 0)
            st = bound_by_oracle(q, box->var[i], box->side[i]);
    return st;
}

static bool are_variables(const fmb_system *s, const int *vars, int n)
{
    bool good = n >= 0;
    for (int i = 0; vars && i < n; i++)
        good = good && vars[i] >= 0 && vars[i] < fmb_system_dim(s);
    return good;
}

static fmb_status bound(fmb_query *q, fmb_box *box, fmb_verdict *verdict)
{
    fmb_arena_place place = fmb_arena_tell(&q->v->arena);
    fmb_status st = fmb_query_decide(q, !fmb_query_eliminates(q), verdict);
    if (st == FMB_OK && *verdict == FMB_FEASIBLE)
        st = bound_all(q, box);
    if (st != FMB_LIMIT)
        return st;
    fmb_outer_release(q, place);
    st = fmb_outer_box(q, box, verdict);
    return st == FMB_OK && *verdict != FMB_INFEASIBLE ? FMB_LIMIT : st;
}

fmb_status fmb_bound(fmb_solver *v, const fmb_system *s, const int *vars, int n, fmb_box **out,
                     fmb_result *res)
{
    fmb_query q;
    fmb_box *box = NULL;
    fmb_verdict verdict = FMB_UNKNOWN;
    if (!out || !are_variables(s, vars, n))
        return FMB_ERR_ARG;
    fmb_status st = fmb_query_begin(&q, v, s, "bound");
    fmb_status made = fmb_box_new(vars, vars ? n : fmb_system_dim(s), &v->mem.alloc, &box);
    if (st == FMB_OK)
        st = made == FMB_OK ? bound(&q, box, &verdict) : made;
    else if (st == FMB_LIMIT && made != FMB_OK)
        st = made;
    st = fmb_query_end(&q, st, verdict, res);
    if (st == FMB_OK && verdict != FMB_INFEASIBLE) {
        *out = box;
        return FMB_OK;
    }
    fmb_box_free(box);
    if (st == FMB_OK)
        *out = NULL;
    return st;
}
