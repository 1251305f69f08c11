/* query.c: creating and freeing solvers, beginning and ending queries; see solver.h. */
#include "solve/query/solver.h"

#include "num/kernels/kernels.h"
#include "num/rationals.h"
#include "solve/query/rule_lp.h"
#include <string.h>

fmb_status fmb_solver_new(const fmb_options *o, const fmb_alloc *hook, fmb_solver **out)
{
    if (!out)
        return FMB_ERR_ARG;
    fmb_mem mem;
    fmb_mem_init(&mem, hook, 0);
    fmb_solver *v;
    FMB_TRY(FMB_GET_ZERO(&mem, v, 1));
    v->mem = mem;
    atomic_init(&v->cancel, 0);
    fmb_arena_init(&v->arena, &v->mem);
    fmb_status st = fmb_options_read(v, o);
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
    fmb_session_free(v->session);
    fmb_permutations_free(v->symmetries);
    fmb_arena_clear(&v->arena);
    fmb_mem mem = v->mem;
    fmb_mem_put(&mem, v, 1, sizeof *v);
}

/* ---- life ------------------------------------------------------------------------------------ */

void fmb_solver_cancel(fmb_solver *v)
{
    if (v)
        atomic_store_explicit(&v->cancel, 1, memory_order_relaxed);
}

void fmb_solver_set_chooser(fmb_solver *v, fmb_chooser chooser)
{
    if (v)
        v->chooser = chooser;
}

void fmb_solver_set_sink(fmb_solver *v, fmb_sink sink)
{
    if (v)
        v->sink = sink;
}

fmb_status fmb_solver_evidence(const fmb_solver *v, fmb_evidence **out)
{
    if (!v || !out)
        return FMB_ERR_ARG;
    if (!v->answered || !v->evidence)
        return FMB_ERR_STATE;
    *out = fmb_evidence_share(v->evidence);
    return FMB_OK;
}

/* ---- queries --------------------------------------------------------------------------------- */

fmb_status fmb_query_want_point(fmb_query *q)
{
    size_t dim = (size_t)fmb_system_dim(q->s);
    FMB_TRY(q->point ? FMB_OK : fmb_rationals_new(&q->point, dim, &q->v->mem));
    return !q->x ? fmb_rationals_new(&q->x, dim, &q->v->mem) : FMB_OK;
}

static fmb_status open_query_evidence(fmb_query *q)
{
    fmb_solver *v = q->v;
    if (v->options.evidence == FMB_EVIDENCE_NONE)
        return FMB_OK;
    size_t dim = (size_t)fmb_system_dim(q->s);
    FMB_TRY(fmb_evidence_new((int)dim, fmb_system_rows(q->s), &v->mem.alloc, &v->evidence));
    q->evidence = v->evidence;
    q->claims = v->options.evidence != FMB_EVIDENCE_VERDICT ? q->evidence : NULL;
    fmb_mem_enter(&q->evidence->mem, &v->mem);
    return fmb_query_want_point(q);
}

static fmb_status begin_query(fmb_query *q, fmb_solver *v, const fmb_system *s, const char *name,
                              fmb_session *session)
{
    *q = (fmb_query){.v = v, .s = s, .session = session};
    v->answered = false;
    fmb_evidence_free(v->evidence);
    v->evidence = NULL;
    if (v->options.max_bytes > 0)
        fmb_arena_clear(&v->arena); /* memory of older queries must not count for this one */
    fmb_arena_reset(&v->arena);
    if (!v->within)
        atomic_store_explicit(&v->cancel, 0, memory_order_relaxed);
    fmb_run_begin(&q->run, &v->mem, &v->options, &v->cancel, v->sink, name);
    if (v->within) {
        q->run.cancel = v->within->cancel;
        q->run.deadline = v->within->deadline;
    }
    FMB_TRY(fmb_rules_agree(v, name));
    FMB_TRY(open_query_evidence(q));
    FMB_TRY(fmb_parts_split(&q->parts, s, &q->run, &v->arena,
                            session                            ? FMB_SPLIT_ALL
                            : (v->steps & FMB_STEP_COMPONENTS) ? FMB_SPLIT_COMPONENTS
                                                               : FMB_SPLIT_NAMED));
    size_t parts = (size_t)q->parts.count;
    FMB_TRY(FMB_ARENA_GET(&v->arena, q->program, parts));
    FMB_TRY(FMB_ARENA_GET(&v->arena, q->oracle, parts));
    for (size_t i = 0; i < parts; i++)
        q->oracle[i] = NULL;
    return FMB_OK;
}

fmb_attempt fmb_query_attempt(const fmb_query *q, int part, const char *engine, const char *task)
{
    const fmb_part *p = &q->parts.part[part];
    return (fmb_attempt){
        .engine = engine, .task = task, .part = part, .columns = (size_t)p->n, .rows = p->m};
}

fmb_status fmb_query_begin(fmb_query *q, fmb_solver *v, const fmb_system *s, const char *name)
{
    return begin_query(q, v, s, name, NULL);
}

fmb_status fmb_query_resume(fmb_query *q, fmb_solver *v, const fmb_system *s, const char *name)
{
    bool warm =
        v->session && s == fmb_session_system(v->session) && v->options.method != FMB_METHOD_FM;
    return begin_query(q, v, s, name, warm ? v->session : NULL);
}

fmb_status fmb_query_end(fmb_query *q, fmb_status st, fmb_verdict verdict, fmb_result *res)
{
    fmb_solver *v = q->v;
    fmb_query_leave_session(q, st != FMB_OK);
    if (st == FMB_LIMIT && q->run.stop == FMB_STOP_DONE)
        q->run.stop = FMB_STOP_BYTES;
    fmb_query_close_oracles(q);
    fmb_met_points_clear(&q->met);
    fmb_parts_clear(&q->parts, &v->mem);
    fmb_rationals_free(q->point, (size_t)fmb_system_dim(q->s), &v->mem);
    fmb_rationals_free(q->x, (size_t)fmb_system_dim(q->s), &v->mem);
    if (q->evidence)
        fmb_mem_leave(&q->evidence->mem);
    fmb_run_end(&q->run, verdict);
    if (st == FMB_ERR_ARG)
        return fmb_solver_refuse(v, st,
                                 "the chooser named a variable that was not on offer, or a rule "
                                 "returned FMB_ERR_ARG");
    if (st != FMB_OK && st != FMB_LIMIT)
        return st;
    v->answered = true;
    fmb_result_give(
        res, &(fmb_result){.size = sizeof(fmb_result),
                           .verdict = verdict,
                           .trust = verdict == FMB_UNKNOWN ? FMB_TRUST_NONE : FMB_TRUST_EXACT,
                           .stop = q->run.stop,
                           .stats = q->run.stats});
    return FMB_OK;
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
    *e = (fmb_elim){.run = &q->run}; /* so it can be cleared after any error */
    FMB_TRY(p->row ? FMB_OK : fmb_query_write_rows(q, (int)(p - q->parts.part)));
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

/* ---- the options of a caller: those of a solver, or refused with a reason -------------------- */

fmb_status fmb_options_read(fmb_solver *v, const fmb_options *o)
{
    if (!fmb_sized_take(&v->options, sizeof v->options, o, "options", v->error, sizeof v->error))
        return FMB_ERR_ARG;
    fmb_status st = fmb_options_expect(v, &v->options);
    if (st == FMB_OK && !fmb_kernels_choose(v->options.simd))
        st = fmb_solver_refuse(v, FMB_ERR_ARG, "simd: the processor lacks these instructions");
    FMB_THEN(st, fmb_rules_read(v, &v->options));
    v->usual_rules = v->options.rules || v->options.presolve ? -1 : v->rules;
    v->options.rules = v->options.presolve = NULL; /* they were borrowed */
    return st;
}

size_t fmb_options_trouble(const fmb_options *o, char *text, size_t size)
{
    fmb_solver v = {.rules = 0};
    if (o)
        (void)fmb_options_read(&v, o);
    return fmb_text_give(v.error, text, size);
}
