/* claims.c: what the verbs write into the evidence; see solver.h. */
#include "elim/store/derive.h"
#include "solve/query/solver.h"
#include "system/system_private.h"

fmb_status fmb_query_push(fmb_query *q, const fmb_part *p, const fmb_weights *w, size_t target,
                          int sign, fmb_sparse_vector *list)
{
    fmb_status st = FMB_OK;
    mpq_t t, unit;
    mpq_inits(t, unit, NULL);
    mpq_set_si(unit, sign, 1);
    if (target != SIZE_MAX) {
        st = fmb_part_scale(q->s, p->source[target], &q->run, t);
        mpq_div(unit, unit, t);
    }
    for (size_t i = 0; st == FMB_OK && i < w->size; i++) {
        size_t source = p->source[w->index[i]];
        st = fmb_part_scale(q->s, source, &q->run, t);
        mpq_mul(t, t, w->value[i]);
        mpq_mul(t, t, unit);
        FMB_THEN(st, fmb_evidence_push(q->evidence, list, source, t));
    }
    mpq_clears(t, unit, NULL);
    return st;
}

fmb_status fmb_query_finish_claim(fmb_query *q, fmb_status st)
{
    if (st != FMB_OK)
        fmb_evidence_drop_last(q->evidence);
    return st;
}

/* Multipliers of a conflict may be scaled at will: in lowest terms they are coprime integers. */
static fmb_status reduce_to_lowest_terms(fmb_evidence *e, fmb_sparse_vector *list)
{
    mpq_t scale; /* least common denominator over greatest common numerator */
    mpz_ptr common = mpq_denref(scale);
    fmb_status st = FMB_OK;
    mpq_init(scale);
    mpz_set_ui(mpq_numref(scale), 1);
    mpz_set_ui(common, list->size == 0);
    for (size_t k = 0; k < list->size; k++)
        if (mpz_cmp_ui(mpq_denref(list->value[k]), 1) != 0)
            mpz_lcm(mpq_numref(scale), mpq_numref(scale), mpq_denref(list->value[k]));
    for (size_t k = 0; mpz_cmp_ui(common, 1) != 0 && k < list->size; k++)
        mpz_gcd(common, common, mpq_numref(list->value[k]));
    if (mpq_cmp_ui(scale, 1, 1) != 0)
        st = fmb_evidence_scale(e, list, scale);
    mpq_clear(scale);
    return st;
}

fmb_status fmb_query_claim_infeasible(fmb_query *q, const fmb_part *p, const fmb_weights *w)
{
    fmb_claim *claim;
    if (!q->evidence)
        return FMB_OK;
    fmb_evidence_reset(q->evidence);
    FMB_TRY(fmb_evidence_claim(q->evidence, FMB_CLAIM_INFEASIBLE, &claim));
    fmb_status st = fmb_query_push(q, p, w, SIZE_MAX, 1, &claim->multipliers);
    FMB_THEN(st, reduce_to_lowest_terms(q->evidence, &claim->multipliers));
    fmb_sparse_sort(&claim->multipliers);
    return fmb_query_finish_claim(q, st);
}

fmb_status fmb_query_derive(fmb_query *q, const fmb_elim *e, uint32_t r, const mpq_t factor,
                            fmb_weights *w)
{
    FMB_TRY(fmb_weights_add(w, r, factor, q->run.mem));
    return fmb_elim_derive(e, w);
}

fmb_status fmb_query_claim_clash(fmb_query *q, const fmb_part *p, const fmb_elim *e)
{
    if (!q->evidence)
        return FMB_OK;
    const fmb_derived *r = &e->row[e->clash];
    fmb_weights w = {0};
    mpq_t one; /* 0 = positive is an equality: negate it */
    mpq_init(one);
    mpq_set_si(one, fmb_vec_sgn(&r->v, (size_t)e->n) > 0 ? -1 : 1, 1);
    fmb_status st = fmb_query_derive(q, e, e->clash, one, &w);
    FMB_THEN(st, fmb_query_minimize_conflict(q, p, &w));
    FMB_THEN(st, fmb_query_claim_infeasible(q, p, &w));
    fmb_weights_clear(&w, q->run.mem);
    mpq_clear(one);
    return st;
}

fmb_status fmb_query_claim_false_row(fmb_query *q, size_t i)
{
    fmb_claim *claim;
    if (!q->evidence)
        return FMB_OK;
    FMB_TRY(fmb_evidence_claim(q->evidence, FMB_CLAIM_INFEASIBLE, &claim));
    mpq_t b;
    mpq_init(b);
    fmb_system_rhs_q(q->s, i, b);
    mpq_set_si(b, mpq_sgn(b) > 0 ? -1 : 1, 1); /* 0 = positive is an equality: negate it */
    fmb_status st = fmb_evidence_push(q->evidence, &claim->multipliers, i, b);
    mpq_clear(b);
    return fmb_query_finish_claim(q, st);
}

void fmb_query_scatter(const fmb_part *p, mpq_t *x, mpq_t *dense)
{
    for (int j = 0; j < p->n; j++)
        mpq_set(dense[p->var[j]], x[j]);
}

fmb_status fmb_query_attach_point(fmb_query *q, fmb_claim *claim, const fmb_part *p, mpq_t *x)
{
    FMB_TRY(fmb_run_poll_now(&q->run));
    for (int j = 0; j < fmb_system_dim(q->s); j++) {
        bool moved = x && q->parts.of_var[j] == p - q->parts.part;
        mpq_srcptr value = moved ? x[q->parts.place[j]] : q->point[j];
        FMB_TRY(fmb_evidence_push(q->evidence, &claim->point, (size_t)j, value));
    }
    return FMB_OK;
}

fmb_status fmb_query_claim_feasible(fmb_query *q)
{
    fmb_claim *claim;
    if (!q->evidence)
        return FMB_OK;
    FMB_TRY(fmb_evidence_claim(q->evidence, FMB_CLAIM_FEASIBLE, &claim));
    return fmb_query_finish_claim(q, fmb_query_attach_point(q, claim, NULL, NULL));
}

/* ---- rows that follow ------------------------------------------------------------------------ */

static fmb_status fill_implied_claim(fmb_query *q, const fmb_part *p, const fmb_vec *row,
                                     const mpq_t factor, fmb_rel rel, fmb_claim *claim)
{
    fmb_status st = FMB_OK;
    bool scaled = mpq_cmp_ui(factor, 1, 1) != 0;
    mpq_t t;
    mpq_init(t);
    claim->rel = rel;
    for (int j = 0; st == FMB_OK && j <= p->n; j++) {
        fmb_vec_get_q(row, (size_t)j, t);
        if (scaled)
            mpq_mul(t, t, factor);
        if (j < p->n)
            st = fmb_evidence_push(q->evidence, &claim->terms, (size_t)p->var[j], t);
        else
            mpq_set(claim->value, t);
    }
    mpq_clear(t);
    return st;
}

fmb_status fmb_query_claim_implied(fmb_query *q, const fmb_part *p, const fmb_vec *row,
                                   const mpq_t factor, fmb_rel rel, const fmb_weights *proof,
                                   const fmb_weights *reverse)
{
    fmb_claim *claim;
    FMB_TRY(fmb_evidence_claim(q->evidence, FMB_CLAIM_IMPLIED, &claim));
    fmb_status st = fill_implied_claim(q, p, row, factor, rel, claim);
    FMB_THEN(st, fmb_query_push(q, p, proof, SIZE_MAX, 1, &claim->multipliers));
    if (st == FMB_OK && rel == FMB_EQ)
        st = fmb_query_push(q, p, reverse ? reverse : proof, SIZE_MAX, reverse ? 1 : -1,
                            &claim->reverse);
    return fmb_query_finish_claim(q, st);
}

static fmb_status claim_derived_row(fmb_query *q, const fmb_part *p, const fmb_elim *e, uint32_t r,
                                    fmb_rel rel, const fmb_weights *reverse)
{
    fmb_weights w = {0};
    mpq_t one;
    if (!q->claims)
        return FMB_OK;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    fmb_status st = fmb_query_derive(q, e, r, one, &w);
    FMB_THEN(st, fmb_query_claim_implied(q, p, &e->row[r].v, one, rel, &w, reverse));
    fmb_weights_clear(&w, q->run.mem);
    mpq_clear(one);
    return st;
}

fmb_status fmb_query_put_row(fmb_query *q, const fmb_part *p, const fmb_elim *e, uint32_t r,
                             fmb_rel rel, const fmb_weights *reverse, const int *place,
                             fmb_system *out)
{
    FMB_TRY(claim_derived_row(q, p, e, r, rel, reverse));
    return fmb_system_append_dense(out, (size_t)p->n, p->var, place, &e->row[r].v, rel);
}
