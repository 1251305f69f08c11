/* solver.c: life of a solver, and the frame of every query; see solver.h. */
#include "solve/solver.h"

#include <string.h>

#include "solve/prune_lp.h"

static bool is_sound(const fmb_options *o)
{
    return o->arith >= FMB_ARITH_AUTO && o->arith <= FMB_ARITH_GMP &&
           o->method >= FMB_METHOD_AUTO && o->method <= FMB_METHOD_FMPLEX &&
           o->order >= FMB_ORDER_PAIRS && o->order <= FMB_ORDER_FILL &&
           o->rebase >= FMB_REBASE_AUTO && o->rebase <= FMB_REBASE_NEVER &&
           fmb_kernels_choose(o->simd) && o->max_seconds >= 0;
}

fmb_status fmb_solver_new(const fmb_options *o, const fmb_alloc *hook, fmb_solver **out)
{
    fmb_options options = o ? *o : fmb_options_default();
    if (!out || !is_sound(&options))
        return FMB_ERR_ARG;
    fmb_mem mem;
    fmb_mem_init(&mem, hook, 0);
    fmb_solver *v = fmb_mem_zero(&mem, 1, sizeof *v);
    if (!v)
        return FMB_ERR_MEMORY;
    v->mem = mem;
    v->options = options;
    atomic_init(&v->cancel, 0);
    fmb_arena_init(&v->arena, &v->mem);
    fmb_status st = fmb_rules_read(v, &options);
    v->usual_rules = options.rules || options.presolve ? -1 : v->rules;
    v->options.rules = v->options.presolve = NULL; /* they were borrowed */
    if (st == FMB_OK)
        *out = v;
    else
        fmb_solver_free(v);
    return st;
}

void fmb_solver_free(fmb_solver *v)
{
    if (!v)
        return;
    fmb_evidence_free(v->evidence);
    fmb_arena_clear(&v->arena);
    fmb_mem mem = v->mem;
    fmb_mem_put(&mem, v, 1, sizeof *v);
}

void fmb_solver_cancel(fmb_solver *v)
{
    atomic_store_explicit(&v->cancel, 1, memory_order_relaxed);
}

void fmb_solver_set_chooser(fmb_solver *v, fmb_chooser chooser)
{
    v->chooser = chooser;
}

void fmb_solver_set_sink(fmb_solver *v, fmb_sink sink)
{
    v->sink = sink;
}

fmb_status fmb_solver_evidence(const fmb_solver *v, fmb_evidence **out)
{
    if (!v->answered || !v->evidence)
        return FMB_ERR_STATE;
    return fmb_evidence_copy(v->evidence, out);
}

/* ---- queries --------------------------------------------------------------------------------- */

static fmb_status open_evidence(fmb_query *q)
{
    fmb_solver *v = q->v;
    if (!v->options.evidence)
        return FMB_OK;
    size_t dim = (size_t)fmb_system_dim(q->s);
    fmb_status st = fmb_evidence_new((int)dim, fmb_system_rows(q->s), &v->mem.alloc, &v->evidence);
    if (st != FMB_OK)
        return st;
    q->evidence = v->evidence;
    q->evidence->mem.limit = v->options.max_bytes;
    st = fmb_vector_new(&q->point, dim, &v->mem);
    return st == FMB_OK ? fmb_vector_new(&q->x, dim, &v->mem) : st;
}

fmb_status fmb_query_begin(fmb_query *q, fmb_solver *v, const fmb_system *s, const char *name)
{
    *q = (fmb_query){.v = v, .s = s};
    v->answered = false;
    fmb_evidence_free(v->evidence);
    v->evidence = NULL;
    if (v->options.max_bytes > 0)
        fmb_arena_clear(&v->arena); /* what older queries left shall not count for this one */
    fmb_arena_reset(&v->arena);
    atomic_store_explicit(&v->cancel, 0, memory_order_relaxed);
    fmb_run_begin(&q->run, &v->mem, &v->options, &v->cancel, v->sink, name);
    fmb_status st = fmb_rules_agree(v, name);
    if (st == FMB_OK)
        st = open_evidence(q);
    if (st == FMB_OK)
        st = fmb_parts_split(&q->parts, s, &q->run, &v->arena, fmb_query_is_wide(q),
                             (v->steps & FMB_STEP_COMPONENTS) != 0);
    if (st != FMB_OK)
        return st;
    size_t parts = (size_t)q->parts.count;
    q->lp = fmb_arena_get(&v->arena, parts, sizeof *q->lp);
    if (!q->lp)
        return fmb_mem_status(&v->mem);
    for (size_t i = 0; i < parts; i++)
        q->lp[i] = NULL;
    return FMB_OK;
}

fmb_status fmb_query_end(fmb_query *q, fmb_status st, fmb_verdict verdict, fmb_result *res)
{
    fmb_solver *v = q->v;
    if (st == FMB_LIMIT && q->run.stop == FMB_STOP_DONE)
        q->run.stop = FMB_STOP_BYTES;
    for (int c = 0; q->lp && c < q->parts.count; c++)
        if (q->lp[c])
            fmb_lp_clear(q->lp[c]);
    fmb_parts_clear(&q->parts, &v->mem);
    fmb_vector_free(q->point, (size_t)fmb_system_dim(q->s), &v->mem);
    fmb_vector_free(q->x, (size_t)fmb_system_dim(q->s), &v->mem);
    fmb_run_end(&q->run, verdict);
    if (st != FMB_OK && st != FMB_LIMIT)
        return st;
    v->answered = true;
    if (res)
        *res = (fmb_result){.verdict = verdict,
                            .trust = verdict == FMB_UNKNOWN ? FMB_TRUST_NONE : FMB_TRUST_EXACT,
                            .stop = q->run.stop,
                            .stats = q->run.stats};
    return FMB_OK;
}

fmb_status fmb_query_oracle(fmb_query *q, int part, fmb_lp **out)
{
    const fmb_part *p = &q->parts.part[part];
    if (q->lp[part]) {
        *out = q->lp[part];
        return FMB_OK;
    }
    fmb_lp *lp = fmb_arena_get(&q->v->arena, 1, sizeof *lp);
    fmb_lp_row *rows = fmb_arena_get(&q->v->arena, p->m, sizeof *rows);
    if (!lp || !rows)
        return fmb_mem_status(&q->v->mem);
    for (size_t i = 0; i < p->m; i++)
        rows[i] = (fmb_lp_row){&p->row[i], p->rel[i]};
    q->lp[part] = lp;
    *out = lp;
    return fmb_lp_init(lp, &q->run, p->n, p->m, rows, fmb_query_is_wide(q));
}

fmb_status fmb_query_load(fmb_query *q, const fmb_part *p, bool feasible, fmb_elim *e)
{
    const fmb_solver *v = q->v;
    const fmb_rule *rule[FMB_MAX_RULES];
    int rules = 0;
    for (int k = 0; k < v->rules; k++)
        if (feasible || v->rule[k] != &fmb_rule_lp)
            rule[rules++] = v->rule[k];
    fmb_elim_options o = {.order = v->options.order,
                          .rebase = v->options.rebase,
                          .steps = v->steps,
                          .wide_only = fmb_query_is_wide(q),
                          .chooser = v->chooser,
                          .rule = rule,
                          .rules = rules};
    q->run.var_of = p->var;
    fmb_status st = fmb_elim_init(e, &q->run, &q->v->arena, p->n, &o);
    for (size_t i = 0; st == FMB_OK && i < p->m; i++)
        st = fmb_elim_add(e, &p->row[i], p->rel[i]);
    for (size_t i = 0; st == FMB_OK && !(v->steps & FMB_STEP_EQUALITIES) && i < p->m; i++)
        if (p->rel[i] == FMB_EQ)
            st = fmb_elim_split(e, (uint32_t)i);
    if (e->live.size > q->run.stats.rows_peak)
        q->run.stats.rows_peak = e->live.size;
    return st;
}

/* ---- small ----------------------------------------------------------------------------------- */

fmb_status fmb_vector_new(mpq_t **out, size_t n, fmb_mem *mem)
{
    mpq_t *x = fmb_mem_get(mem, n, sizeof *x);
    if (!x)
        return fmb_mem_status(mem);
    for (size_t j = 0; j < n; j++)
        mpq_init(x[j]);
    *out = x;
    return FMB_OK;
}

void fmb_vector_free(mpq_t *x, size_t n, fmb_mem *mem)
{
    if (!x)
        return;
    for (size_t j = 0; j < n; j++)
        mpq_clear(x[j]);
    fmb_mem_put(mem, x, n, sizeof *x);
}
