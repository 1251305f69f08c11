/* ends.c: see ends.h. */
#include "solve/bound/ends.h"

#include "num/rationals.h"

fmb_status fmb_found_end_init(fmb_found_end *f, size_t n, bool with_claims, fmb_mem *mem)
{
    *f = (fmb_found_end){0};
    mpq_init(f->value);
    return with_claims ? fmb_rationals_new(&f->x, n, mem) : FMB_OK;
}

void fmb_found_end_clear(fmb_found_end *f, size_t n, fmb_mem *mem)
{
    mpq_clear(f->value);
    fmb_weights_clear(&f->w, mem);
    fmb_rationals_free(f->x, n, mem);
}

static fmb_status read_answer(const fmb_oracle *o, int sign, fmb_found_end *f)
{
    if (f->end == FMB_ORACLE_UNBOUNDED) {
        return f->x ? fmb_oracle_ray(o, f->x) : FMB_OK;
    }
    fmb_status st = fmb_oracle_value(o, f->value);
    if (sign < 0)
        mpq_neg(f->value, f->value);
    if (st == FMB_OK && f->x)
        st = fmb_oracle_point(o, f->x);
    return st == FMB_OK && f->x ? fmb_oracle_multipliers(o, &f->w) : st;
}

fmb_status fmb_find_end(fmb_oracle *o, int column, int sign, fmb_mem *mem, fmb_found_end *f)
{
    fmb_weights cost = {0};
    mpq_t one;
    mpq_init(one);
    mpq_set_si(one, sign, 1);
    fmb_status st = fmb_weights_add(&cost, (uint32_t)column, one, mem);
    FMB_THEN(st, fmb_oracle_maximize(o, &cost, &f->end, &f->attained));
    FMB_THEN(st, read_answer(o, sign, f));
    f->known = st == FMB_OK;
    fmb_weights_clear(&cost, mem);
    mpq_clear(one);
    return st;
}

/* Swap f's point with the query's x, which fmb_bound_claim and fmb_bound_claim_unbounded read. */
static void lend_point(fmb_bound_job *j, fmb_found_end *f)
{
    for (int k = 0; f->x && k < j->p->n; k++)
        mpq_swap(j->q->x[k], f->x[k]);
}

fmb_status fmb_note_end(fmb_bound_job *j, fmb_found_end *f)
{
    lend_point(j, f);
    if (f->end == FMB_ORACLE_UNBOUNDED) {
        FMB_TRY(fmb_bound_claim_unbounded(j));
        j->end->kind = FMB_END_INFINITE;
        return FMB_OK;
    }
    mpq_set(j->end->value, f->value);
    j->end->attained = f->attained;
    if (j->q->claims) {
        FMB_TRY(fmb_query_take_oracle_weights(j->q, j->p, &f->w));
        FMB_TRY(fmb_bound_claim(j, &f->w));
    }
    j->end->kind = FMB_END_FINITE;
    return FMB_OK;
}
