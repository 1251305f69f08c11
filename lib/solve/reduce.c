/* reduce.c: the irredundant system. */
#include "solve/irredundant.h"
#include "solve/solver.h"
#include "system/system.h"

/* What the claims of a part need. */
typedef struct context {
    fmb_query *q;
    const fmb_part *p;
} context;

static fmb_status claim_combination(context *c, fmb_claim_kind kind, size_t i, const fmb_weights *w)
{
    fmb_query *q = c->q;
    fmb_claim *claim;
    fmb_status st = fmb_evidence_claim(q->evidence, kind, &claim);
    if (st != FMB_OK)
        return st;
    claim->row = c->p->source[i];
    st = fmb_query_push(q, c->p, w, i, 1, &claim->multipliers);
    if (st == FMB_OK && kind == FMB_CLAIM_REDUNDANT && c->p->rel[i] == FMB_EQ)
        st = fmb_query_push(q, c->p, w, i, -1, &claim->reverse);
    if (st != FMB_OK)
        fmb_evidence_drop_last(q->evidence);
    return st;
}

static fmb_status claim_redundant(void *self, size_t i, const fmb_weights *w)
{
    return claim_combination(self, FMB_CLAIM_REDUNDANT, i, w);
}

static fmb_status claim_equality(void *self, size_t i, const fmb_weights *w)
{
    return claim_combination(self, FMB_CLAIM_EQUALITY, i, w);
}

static fmb_status claim_irredundant(void *self, size_t i, mpq_t *x)
{
    context *c = self;
    fmb_claim *claim;
    fmb_status st = fmb_evidence_claim(c->q->evidence, FMB_CLAIM_IRREDUNDANT, &claim);
    if (st != FMB_OK)
        return st;
    claim->row = c->p->source[i];
    st = fmb_query_attach_point(c->q, claim, c->p, x);
    if (st != FMB_OK)
        fmb_evidence_drop_last(c->q->evidence);
    return st;
}

/* Decide the rows of one part; fate[rows] is by row of the system. */
static fmb_status reduce_part(fmb_query *q, int part, fmb_fate *fate)
{
    const fmb_part *p = &q->parts.part[part];
    context c = {q, p};
    fmb_verdicts told = {claim_redundant, claim_equality, claim_irredundant, &c};
    fmb_lp *lp;
    fmb_fate *mine = fmb_arena_get(&q->v->arena, p->m, sizeof *mine);
    if (!mine)
        return fmb_mem_status(q->run.mem);
    for (size_t i = 0; i < p->m; i++)
        mine[i] = FMB_FATE_UNKNOWN;
    fmb_status st = fmb_query_oracle(q, part, &lp);
    if (st == FMB_OK)
        st = fmb_irredundant(lp, p->rel, mine, q->evidence ? &told : NULL);
    for (size_t i = 0; i < p->m; i++)
        fate[p->source[i]] = mine[i];
    return st;
}

/* Rows that name no variable are true here, and follow from nothing at all. */
static fmb_status drop_constants(fmb_query *q, fmb_fate *fate)
{
    fmb_status st = FMB_OK;
    fmb_claim *claim;
    for (size_t i = 0; st == FMB_OK && i < q->s->rows; i++) {
        if (fmb_system_row(q->s, i)->nnz > 0)
            continue;
        fate[i] = FMB_FATE_REDUNDANT;
        if (!q->evidence)
            continue;
        st = fmb_evidence_claim(q->evidence, FMB_CLAIM_REDUNDANT, &claim);
        if (st == FMB_OK)
            claim->row = i;
    }
    return st;
}

/* The rows that stay, in their order. */
static fmb_status build(const fmb_system *s, const fmb_fate *fate, fmb_system **out)
{
    fmb_system *t;
    fmb_status st = fmb_system_copy(s, &t);
    if (st != FMB_OK)
        return st;
    for (size_t i = 0; i < t->rows; i++)
        if (fate[i] == FMB_FATE_EQUALITY)
            t->row[i].rel = FMB_EQ;
    for (size_t i = t->rows; i-- > 0;)
        if (fate[i] == FMB_FATE_REDUNDANT)
            fmb_system_remove(t, i);
    *out = t;
    return FMB_OK;
}

static fmb_status reduce(fmb_query *q, fmb_fate *fate, fmb_verdict *verdict)
{
    fmb_status st = fmb_query_decide(q, true, verdict);
    if (st != FMB_OK || *verdict != FMB_FEASIBLE)
        return st;
    st = drop_constants(q, fate);
    for (int c = 0; st == FMB_OK && c < q->parts.count; c++)
        st = reduce_part(q, c, fate);
    return st;
}

fmb_status fmb_reduce(fmb_solver *v, const fmb_system *s, fmb_fate *fate, fmb_system **out,
                      fmb_result *res)
{
    fmb_query q;
    fmb_verdict verdict = FMB_UNKNOWN;
    fmb_system *reduced = NULL;
    size_t rows = fmb_system_rows(s);
    fmb_fate *mine = out ? fmb_mem_zero(&v->mem, rows, sizeof *mine) : NULL;
    if (!out)
        return FMB_ERR_ARG;
    if (!mine) {
        v->answered = false; /* the evidence at hand is that of an older query */
        return FMB_ERR_MEMORY;
    }
    fmb_status st = fmb_query_begin(&q, v, s, "reduce");
    if (st == FMB_OK)
        st = reduce(&q, mine, &verdict);
    if (st == FMB_OK || st == FMB_LIMIT) {
        fmb_status built = verdict == FMB_INFEASIBLE
                               ? fmb_empty_set(s, NULL, fmb_system_dim(s), &reduced)
                               : build(s, mine, &reduced);
        st = built != FMB_OK ? built : st;
    }
    st = fmb_query_end(&q, st, verdict, res);
    if (st == FMB_OK) {
        for (size_t i = 0; fate && i < rows; i++)
            fate[i] = mine[i];
        *out = reduced;
    }
    fmb_mem_put(&v->mem, mine, rows, sizeof *mine);
    return st;
}
