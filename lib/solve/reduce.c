/* reduce.c: the irredundant system.
 *
 * Most parts have a strictly interior point. Then the part is feasible, and ray shooting
 * (lp/redundancy/ray_shooting/ray_shooting.h) decides nearly all rows. The exact oracle decides the
 * remaining rows, and the parts without such a point.
 */
#include "base/ways.h"
#include "lp/redundancy/irredundant.h"
#include "lp/redundancy/ray_shooting/ray_shooting.h"
#include "solve/query/solver.h"
#include "system/system_private.h"

/* The reduction of one part. */
typedef struct reduce_progress {
    fmb_query *q;
    const fmb_part *p;
    fmb_lp_row *row; /* [m] */
    fmb_fate *fate;  /* [m] */
} reduce_progress;

/* ---- claims ---------------------------------------------------------------------------------- */

/* Claim row i of the part with multipliers of the part's rows. */
static fmb_status claim_combination(reduce_progress *g, fmb_claim_kind kind, size_t i,
                                    const fmb_weights *w)
{
    fmb_query *q = g->q;
    fmb_claim *claim;
    FMB_TRY(fmb_evidence_claim(q->claims, kind, &claim));
    claim->row = g->p->source[i];
    fmb_status st = fmb_query_push(q, g->p, w, i, 1, &claim->multipliers);
    if (st == FMB_OK && kind == FMB_CLAIM_REDUNDANT && g->p->rel[i] == FMB_EQ)
        st = fmb_query_push(q, g->p, w, i, -1, &claim->reverse);
    return fmb_query_finish_claim(q, st);
}

static fmb_status claim_redundant_row(void *self, size_t i, const fmb_weights *w)
{
    return claim_combination(self, FMB_CLAIM_REDUNDANT, i, w);
}

static fmb_status claim_equality_row(void *self, size_t i, const fmb_weights *w)
{
    return claim_combination(self, FMB_CLAIM_EQUALITY, i, w);
}

static fmb_status claim_irredundant_row(void *self, size_t i, mpq_t *x)
{
    reduce_progress *g = self;
    fmb_claim *claim;
    FMB_TRY(fmb_evidence_claim(g->q->claims, FMB_CLAIM_IRREDUNDANT, &claim));
    claim->row = g->p->source[i];
    fmb_status st = fmb_query_attach_point(g->q, claim, g->p, x);
    return fmb_query_finish_claim(g->q, st);
}

/* ---- one part -------------------------------------------------------------------------------- */

/* List the part's rows, all undecided. */
static fmb_status list_rows_of_part(reduce_progress *g, int part)
{
    fmb_query *q = g->q;
    const fmb_part *p = g->p;
    fmb_status st = fmb_query_write_rows(q, part);
    FMB_TRY(FMB_ARENA_GET(&q->v->arena, g->row, p->m));
    FMB_TRY(FMB_ARENA_GET(&q->v->arena, g->fate, p->m));
    for (size_t i = 0; st == FMB_OK && i < p->m; i++) {
        g->row[i] = (fmb_lp_row){&p->row[i], p->rel[i]};
        g->fate[i] = FMB_FATE_UNKNOWN;
    }
    return st;
}

static bool is_some_row_unknown(const reduce_progress *g)
{
    for (size_t i = 0; i < g->p->m; i++)
        if (g->fate[i] == FMB_FATE_UNKNOWN)
            return true;
    return false;
}

/* Decide rows by ray shooting; *inner: there is a strictly interior point. */
static fmb_status shoot_rays_at_part(reduce_progress *g, const fmb_verdicts *told, bool *inner)
{
    fmb_ray_shooting shooting;
    fmb_status st =
        fmb_ray_shooting_open(&shooting, &g->q->run, (size_t)g->p->n, g->p->m, g->row, inner);
    if (st == FMB_OK && *inner)
        st = fmb_ray_shooting_sort(&shooting, g->fate, told);
    fmb_ray_shooting_close(&shooting);
    return st;
}

/* Let the oracle decide the remaining rows; the part is known to be feasible. */
static fmb_status decide_open_rows(reduce_progress *g, int part, const fmb_verdicts *told)
{
    bool feasible;
    fmb_attempt a = fmb_query_attempt(g->q, part, "oracle", "rows");
    fmb_status st =
        fmb_irredundant(&g->q->run, (size_t)g->p->n, g->p->m, g->row, g->fate, told, &feasible);
    fmb_run_tell_attempt(&g->q->run, a, st, true);
    return st;
}

/* Decide all rows of a part; fate[] is indexed by row of the system. */
static fmb_status decide_rows_of_part(fmb_query *q, int part, fmb_fate *fate)
{
    reduce_progress g = {.q = q, .p = &q->parts.part[part]};
    fmb_verdicts told = {claim_redundant_row, claim_equality_row, claim_irredundant_row, &g};
    const fmb_verdicts *listener = q->claims ? &told : NULL;
    bool inner = false;
    fmb_status st = list_rows_of_part(&g, part);
    if (st != FMB_OK)
        return st;
    if (fmb_ray_shooting_is_affordable((size_t)g.p->n, g.p->m) && fmb_way(FMB_WAY_RAY_SHOOTING)) {
        st = shoot_rays_at_part(&g, listener, &inner);
        fmb_run_tell_attempt(&q->run, fmb_query_attempt(q, part, "ray shooting", "rows"), st,
                             inner);
        fmb_way_answered(FMB_WAY_RAY_SHOOTING, inner);
    }
    if (st == FMB_OK && is_some_row_unknown(&g))
        st = decide_open_rows(&g, part, listener);
    for (size_t i = 0; i < g.p->m; i++)
        fate[g.p->source[i]] = g.fate[i];
    return st;
}

/* ---- all parts ------------------------------------------------------------------------------- */

/* Rows that name no variable are true here, hence redundant: no multipliers are needed. */
static fmb_status drop_constant_rows(fmb_query *q, fmb_fate *fate)
{
    fmb_claim *claim;
    for (size_t i = 0; i < q->s->rows; i++) {
        if (fmb_system_row(q->s, i)->nnz > 0)
            continue;
        fate[i] = FMB_FATE_REDUNDANT;
        if (!q->claims)
            continue;
        FMB_TRY(fmb_evidence_claim(q->claims, FMB_CLAIM_REDUNDANT, &claim));
        claim->row = i;
    }
    return FMB_OK;
}

/* Make a system of the kept rows, in order. LIMIT, and no system, if the memory limit has no room
 * for a copy of s, with which it begins. */
static fmb_status build_reduced_system(const fmb_system *s, const fmb_fate *fate, fmb_mem *mem,
                                       fmb_system **out)
{
    fmb_system *t;
    if (!fmb_mem_charge(mem, s->mem.used))
        return fmb_mem_status(mem);
    fmb_mem_refund(mem, s->mem.used);
    FMB_TRY(fmb_system_copy(s, &t));
    for (size_t i = 0; i < t->rows; i++)
        if (fate[i] == FMB_FATE_EQUALITY)
            t->row[i].rel = FMB_EQ;
    for (size_t i = t->rows; i-- > 0;)
        if (fate[i] == FMB_FATE_REDUNDANT)
            fmb_system_remove(t, i);
    *out = t;
    return FMB_OK;
}

static fmb_status decide_all_rows(fmb_query *q, fmb_fate *fate, fmb_verdict *verdict)
{
    FMB_TRY(fmb_query_decide(q, fmb_query_eliminates(q), verdict));
    if (*verdict != FMB_FEASIBLE)
        return FMB_OK;
    FMB_TRY(drop_constant_rows(q, fate));
    for (int c = 0; c < q->parts.count; c++)
        FMB_TRY(decide_rows_of_part(q, c, fate));
    return FMB_OK;
}

fmb_status fmb_reduce(fmb_solver *v, const fmb_system *s, fmb_fate *fate, fmb_system **out,
                      fmb_result *res)
{
    fmb_query q;
    fmb_verdict verdict = FMB_UNKNOWN;
    fmb_system *reduced = NULL;
    FMB_TRY(fmb_solver_expect(v, s, out != NULL, res));
    size_t rows = fmb_system_rows(s);
    fmb_fate *mine = fmb_mem_zero(&v->mem, rows, sizeof *mine);
    if (!mine) {
        v->answered = false; /* the evidence is that of an older query */
        return FMB_ERR_MEMORY;
    }
    fmb_status st = fmb_query_begin(&q, v, s, "reduce");
    fmb_mem result = {.used = s->mem.used}; /* reserves the memory of the result */
    fmb_mem_enter(&result, &v->mem);
    FMB_THEN(st, decide_all_rows(&q, mine, &verdict));
    fmb_mem_leave(&result);
    if (st == FMB_OK || st == FMB_LIMIT) {
        fmb_status built = verdict == FMB_INFEASIBLE
                               ? fmb_empty_set(s, NULL, fmb_system_dim(s), &reduced)
                               : build_reduced_system(s, mine, &v->mem, &reduced);
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
