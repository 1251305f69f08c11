/* decide.c: is it feasible? Part by part, by elimination or by the oracle.
 *
 * Tiny parts are eliminated: on the stack where only the verdict is wanted, which takes 1 to 30 us
 * whether it answers or gives up. Where evidence is wanted, only parts of few rows are eliminated:
 * 8 rows take 10 to 100 us by either method, 16 rows ten times as much by elimination.
 */
#include "base/ways.h"
#include "elim/round/witness.h"
#include "elim/tiny/tiny.h"
#include "solve/query/solver.h"

/* Elimination is tried on parts up to this size, and given up beyond this many rows. */
#define TINY_VARIABLES 6
#define TINY_ROWS      8
#define TINY_BUDGET    256

/* ---- by elimination -------------------------------------------------------------------------- */

static fmb_status note_eliminated_point(fmb_query *q, const fmb_part *p, const fmb_elim *e)
{
    if (!q->point)
        return FMB_OK;
    FMB_TRY(fmb_elim_point(e, FMB_POINT_INSIDE, q->x));
    fmb_query_scatter(p, q->x, q->point);
    return FMB_OK;
}

/* budget > 0: *out stays UNKNOWN if the store exceeds it. */
static fmb_status decide_by_elimination(fmb_query *q, int part, size_t budget, fmb_verdict *out)
{
    const fmb_part *p = &q->parts.part[part];
    fmb_attempt told = fmb_query_attempt(q, part, "elimination", "verdict");
    fmb_elim e;
    bool *drop;
    FMB_TRY(FMB_ARENA_GET(&q->v->arena, drop, (size_t)p->n));
    for (int j = 0; j < p->n; j++)
        drop[j] = true;
    fmb_status st = fmb_query_load(q, p, false, &e);
    e.budget = budget;
    FMB_THEN(st, fmb_elim_eliminate(&e, drop));
    if (st == FMB_OK) {
        *out = e.clash != FMB_NO_ROW ? FMB_INFEASIBLE : FMB_FEASIBLE;
        st = *out == FMB_INFEASIBLE ? fmb_query_claim_clash(q, p, &e)
                                    : note_eliminated_point(q, p, &e);
    }
    bool gave_up = st == FMB_LIMIT && e.over_budget;
    fmb_elim_clear(&e);
    st = gave_up ? FMB_OK : st;
    told.budget = budget;
    told.unit = "rows";
    fmb_run_tell_attempt(&q->run, told, st, !gave_up);
    return st;
}

/* ---- by the oracle --------------------------------------------------------------------------- */

static fmb_status claim_oracle_conflict(fmb_query *q, const fmb_part *p, fmb_oracle *o)
{
    fmb_weights w = {0};
    if (!q->evidence)
        return FMB_OK;
    fmb_status st = fmb_oracle_conflict(o, &w);
    FMB_THEN(st, fmb_query_take_oracle_weights(q, p, &w));
    FMB_THEN(st, fmb_query_claim_infeasible(q, p, &w));
    fmb_weights_clear(&w, q->run.mem);
    return st;
}

static fmb_status note_oracle_point(fmb_query *q, const fmb_part *p, const fmb_oracle *o)
{
    if (!q->point)
        return FMB_OK;
    FMB_TRY(fmb_oracle_point(o, q->x));
    fmb_query_scatter(p, q->x, q->point);
    return FMB_OK;
}

static fmb_status decide_by_oracle(fmb_query *q, int part, fmb_verdict *out)
{
    const fmb_part *p = &q->parts.part[part];
    fmb_oracle *o;
    bool feasible;
    fmb_status st = fmb_query_oracle(q, part, &o);
    FMB_THEN(st, fmb_oracle_feasible(o, &feasible));
    fmb_run_tell_attempt(&q->run, fmb_query_attempt(q, part, "oracle", "verdict"), st, true);
    if (st != FMB_OK)
        return st;
    *out = feasible ? FMB_FEASIBLE : FMB_INFEASIBLE;
    return feasible ? note_oracle_point(q, p, o) : claim_oracle_conflict(q, p, o);
}

/* ---- all ------------------------------------------------------------------------------------- */

static fmb_status decide_one_part(fmb_query *q, int part, bool oracles, fmb_verdict *out)
{
    const fmb_part *p = &q->parts.part[part];
    fmb_method method = q->v->options.method;
    *out = FMB_UNKNOWN;
    if (!oracles && method == FMB_METHOD_FM)
        FMB_TRY(decide_by_elimination(q, part, 0, out));
    else if (!oracles && method == FMB_METHOD_AUTO && p->n <= TINY_VARIABLES && p->m <= TINY_ROWS)
        FMB_TRY(decide_by_elimination(q, part, TINY_BUDGET, out));
    return *out != FMB_UNKNOWN ? FMB_OK : decide_by_oracle(q, part, out);
}

fmb_status fmb_query_decide(fmb_query *q, bool oracles, fmb_verdict *out)
{
    if (q->parts.false_row != SIZE_MAX) {
        fmb_status claimed = fmb_query_claim_false_row(q, q->parts.false_row);
        *out = claimed == FMB_OK ? FMB_INFEASIBLE : *out;
        return claimed;
    }
    FMB_TRY(fmb_run_poll_now(&q->run));
    fmb_verdict verdict = FMB_FEASIBLE;
    oracles = oracles || q->session;
    for (int c = 0; verdict == FMB_FEASIBLE && c < q->parts.count; c++)
        FMB_TRY(decide_one_part(q, c, oracles, &verdict));
    if (verdict == FMB_FEASIBLE)
        FMB_TRY(fmb_query_claim_feasible(q));
    *out = verdict;
    return FMB_OK;
}

/* ---- on the stack ---------------------------------------------------------------------------- */

/* Does the query want only the verdict, with default options? With a limit on rows the general
 * method is used, which can stop at it; a limit on bytes is harmless, as none are allocated. */
static bool wants_verdict_only(const fmb_solver *v)
{
    const fmb_options *o = &v->options;
    return v->rules == v->usual_rules && o->evidence == FMB_EVIDENCE_NONE && !v->sink.put &&
           !v->chooser.choose && o->method <= FMB_METHOD_FM && o->arith <= FMB_ARITH_INT &&
           o->order == FMB_ORDER_PAIRS && o->rebase == FMB_REBASE_AUTO && o->max_rows == 0;
}

fmb_verdict fmb_query_decide_tiny(fmb_query *q)
{
    fmb_stats stats = q->run.stats;
    if (!wants_verdict_only(q->v) || !fmb_way(FMB_WAY_TINY))
        return FMB_UNKNOWN;
    fmb_verdict verdict = fmb_tiny_decide(q->s, &stats);
    fmb_way_answered(FMB_WAY_TINY, verdict == FMB_INFEASIBLE);
    if (verdict == FMB_INFEASIBLE)
        q->run.stats = stats;
    return verdict;
}

/* Decide without opening a query; true: res has the answer. */
static bool decide_on_stack(fmb_solver *v, const fmb_system *s, fmb_result *res)
{
    fmb_run run;
    fmb_run_begin(&run, &v->mem, &v->options, &v->cancel, v->sink, "solve");
    fmb_verdict verdict = fmb_tiny_decide(s, &run.stats);
    fmb_way_answered(FMB_WAY_TINY, verdict != FMB_UNKNOWN);
    if (verdict == FMB_UNKNOWN)
        return false;
    fmb_run_end(&run, verdict);
    if (v->options.max_seconds > 0 && run.stats.seconds >= v->options.max_seconds)
        return false;
    fmb_evidence_free(v->evidence);
    v->evidence = NULL;
    v->error[0] = '\0';
    v->answered = true;
    fmb_result_give(res, &(fmb_result){.size = sizeof(fmb_result),
                                       .verdict = verdict,
                                       .trust = FMB_TRUST_EXACT,
                                       .stats = run.stats});
    return true;
}

fmb_status fmb_solve(fmb_solver *v, const fmb_system *s, fmb_result *res)
{
    fmb_query q;
    fmb_verdict verdict = FMB_UNKNOWN;
    fmb_status st = fmb_solver_expect(v, s, true, res);
    if (st != FMB_OK ||
        (wants_verdict_only(v) && fmb_way(FMB_WAY_TINY) && decide_on_stack(v, s, res)))
        return st;
    st = fmb_query_resume(&q, v, s, "solve");
    FMB_THEN(st, fmb_query_decide(&q, false, &verdict));
    return fmb_query_end(&q, st, verdict, res);
}
