/* optimize.c: the best value of a linear form.
 *
 * Rows of different parts share no variable, so the maximum of the form is the sum of its maxima
 * over the parts. It is attained if all of them are; the optimal point is composed of theirs. If
 * the form is unbounded over one part, or along a variable that no row names, it is unbounded. At a
 * limit, ends of variables (limit/outer_ends.h) may still bound the remaining parts; and the best
 * solution so far is composed of the best ones over each part.
 */
#include "num/rationals.h"
#include "solve/limit/outer.h"
#include "solve/optimize/component_optimum.h"
#include "solve/optimize/optimum.h"
#include "system/system_private.h"

/* The state of a query that proceeds from part to part. */
typedef struct ascent {
    fmb_query *q;
    const fmb_goal *g;
    fmb_optimum *o;
    fmb_component_optimum optimum_of_part; /* of the current part */
    fmb_claim *claim; /* with the multipliers of the parts done so far; NULL: none */
    mpq_t *best;      /* [dim] the best solution so far: where a limit ends the climb, the answer */
    bool improved;    /* it is another one than the decision has found */
    mpq_t sum;        /* of their values: of the goal, without the constant */
    bool attained, exact;
    bool lost; /* numbers of the claim, for want of memory: without them no end is told */
} ascent;

/* ---- claims ---------------------------------------------------------------------------------- */

static fmb_status open_optimum_claim(ascent *a)
{
    fmb_status st = FMB_OK;
    if (a->q->claims && !a->claim)
        st = fmb_evidence_claim(a->q->claims, FMB_CLAIM_BOUND, &a->claim);
    return st;
}

static void drop_optimum_claim(ascent *a)
{
    if (a->claim)
        fmb_evidence_drop_last(a->q->claims);
    a->claim = NULL;
}

/* Put the terms of the form into the claim, as the caller gave it or (as_goal) as maximized. */
static fmb_status put_terms_of_form(ascent *a, fmb_claim *claim, bool as_goal)
{
    fmb_status st = FMB_OK;
    mpq_t q;
    mpq_init(q);
    for (size_t j = 0; st == FMB_OK && j < a->g->dim; j++) {
        mpq_set(q, a->g->coef[j]);
        if (a->g->sense == FMB_SENSE_MIN && !as_goal)
            mpq_neg(q, q);
        st = fmb_evidence_push(a->q->claims, &claim->terms, j, q);
    }
    mpq_clear(q);
    return st;
}

/* Claim BOUND, with the point where the bound is attained; for an outer end, claim IMPLIED:
 * goal <= sum. After an error the claim is incomplete. */
static fmb_status close_optimum_claim(ascent *a)
{
    fmb_claim *claim = a->claim;
    if (!claim)
        return FMB_OK;
    claim->kind = a->exact ? FMB_CLAIM_BOUND : FMB_CLAIM_IMPLIED;
    claim->side = a->exact ? fmb_goal_side(a->g) : FMB_LOWER;
    claim->rel = a->attained || !a->exact ? FMB_LE : FMB_LT;
    mpq_set(claim->value, a->sum);
    if (a->exact && a->g->sense == FMB_SENSE_MIN)
        mpq_neg(claim->value, a->sum);
    fmb_sparse_sort(&claim->multipliers);
    fmb_status st = put_terms_of_form(a, claim, !a->exact);
    if (st == FMB_OK && a->exact)
        st = fmb_evidence_push_all(a->q->claims, &claim->point, a->g->dim, NULL, a->o->point);
    a->lost = a->lost || st != FMB_OK;
    return st;
}

static fmb_status claim_endless(ascent *a)
{
    fmb_claim *claim;
    if (!a->q->claims)
        return FMB_OK;
    FMB_TRY(fmb_evidence_claim(a->q->claims, FMB_CLAIM_UNBOUNDED, &claim));
    claim->side = fmb_goal_side(a->g);
    fmb_status st = put_terms_of_form(a, claim, false);
    FMB_THEN(st, fmb_evidence_push_all(a->q->claims, &claim->ray, a->g->dim, NULL, a->o->ray));
    return fmb_query_finish_claim(a->q, st);
}

/* ---- answers --------------------------------------------------------------------------------- */

/* Restore the solution that the feasibility decision found. */
static void return_to_solution(ascent *a)
{
    for (size_t j = 0; j < a->g->dim; j++)
        mpq_set(a->o->point[j], a->q->point[j]);
}

/* Answer that the form is unbounded; the ray is in the optimum already. */
static fmb_status answer_endless(ascent *a)
{
    drop_optimum_claim(a);
    return_to_solution(a);
    fmb_status st = claim_endless(a);
    if (st == FMB_OK)
        a->o->best.kind = FMB_END_INFINITE;
    return st;
}

/* Answer with the sum: the optima of all parts are known. */
static fmb_status answer_sum(ascent *a)
{
    fmb_exact_side *best = &a->o->best;
    FMB_TRY(close_optimum_claim(a));
    best->kind = a->exact ? FMB_END_FINITE : FMB_END_OUTER;
    best->attained = a->exact && a->attained;
    mpq_set(best->value, a->sum);
    if (a->g->sense == FMB_SENSE_MIN)
        mpq_neg(best->value, best->value);
    mpq_add(best->value, best->value, a->g->constant);
    if (!a->exact)
        return_to_solution(a);
    return FMB_OK;
}

/* ---- the best solution so far ---------------------------------------------------------------- */

/* Does x, over the columns of a part, make the goal larger than the best solution does? */
static bool is_better_over_part(const ascent *a, const fmb_part *p, mpq_t *x)
{
    mpq_t gain, t;
    mpq_inits(gain, t, NULL);
    for (int j = 0; j < p->n; j++) {
        mpq_sub(t, x[j], a->best[p->var[j]]);
        mpq_mul(t, t, a->g->coef[p->var[j]]);
        mpq_add(gain, gain, t);
    }
    bool better = mpq_sgn(gain) > 0;
    mpq_clears(gain, t, NULL);
    return better;
}

/* Note x, the part's coordinates of some solution. */
static void note_solution_of_part(ascent *a, const fmb_part *p, mpq_t *x)
{
    if (!is_better_over_part(a, p, x))
        return;
    fmb_query_scatter(p, x, a->best);
    a->improved = true;
}

static fmb_status claim_best_solution(ascent *a)
{
    fmb_claim *claim;
    if (!a->q->claims)
        return FMB_OK;
    FMB_TRY(fmb_evidence_claim(a->q->claims, FMB_CLAIM_FEASIBLE, &claim));
    fmb_status st = fmb_evidence_push_all(a->q->claims, &claim->point, a->g->dim, NULL, a->best);
    return fmb_query_finish_claim(a->q, st);
}

/* Replace the solution of the decision by the best solution, with a claim of its own; without
 * memory for the claim, keep the former. */
static void answer_best_solution(ascent *a)
{
    return_to_solution(a);
    if (!a->improved || claim_best_solution(a) != FMB_OK)
        return;
    for (size_t j = 0; j < a->g->dim; j++)
        mpq_set(a->o->point[j], a->best[j]);
}

/* ---- part by part ---------------------------------------------------------------------------- */

/* A variable that the form names and no row does, or -1. */
static int find_endless_variable(const ascent *a)
{
    int j = fmb_system_dim(a->q->s) - 1;
    while (j >= 0 && (a->q->parts.of_var[j] >= 0 || mpq_sgn(a->g->coef[j]) == 0))
        j--;
    return j;
}

static fmb_status answer_endless_variable(ascent *a, int j)
{
    mpq_set_si(a->o->ray[j], mpq_sgn(a->g->coef[j]), 1);
    return answer_endless(a);
}

/* Add a part's optimum to the sum; it is finite, or an outer end. */
static fmb_status add_component(ascent *a, const fmb_part *p)
{
    const fmb_component_optimum *k = &a->optimum_of_part;
    bool exact = k->kind == FMB_END_FINITE;
    fmb_status st = open_optimum_claim(a);
    if (st == FMB_OK && a->claim)
        st = fmb_query_push(a->q, p, &k->w, SIZE_MAX, 1, &a->claim->multipliers);
    a->lost = a->lost || st != FMB_OK;
    if (st != FMB_OK)
        return st;
    mpq_add(a->sum, a->sum, k->value);
    a->attained = a->attained && k->attained;
    a->exact = a->exact && exact;
    if (exact)
        fmb_query_scatter(p, k->x, a->o->point);
    if (exact && k->attained)
        note_solution_of_part(a, p, k->x);
    return FMB_OK;
}

static bool is_part_asked(const ascent *a, int c)
{
    const fmb_part *p = &a->q->parts.part[c];
    return fmb_goal_names(a->g, p->var, p->n);
}

/* Announce the objective to all oracles, so that the decision finds good solutions already. */
static fmb_status lean_all_parts(ascent *a)
{
    for (int c = 0; !fmb_query_eliminates(a->q) && c < a->q->parts.count; c++)
        if (is_part_asked(a, c))
            FMB_TRY(fmb_component_optimum_lean(a->q, a->g, c));
    return FMB_OK;
}

/* Optimize over the parts from *c on; at a limit *c is the unfinished one. *ends: the form is
 * bounded. */
static fmb_status climb_all_parts(ascent *a, int *c, bool *ends)
{
    bool eliminates = fmb_query_eliminates(a->q);
    fmb_component_optimum_method *climb =
        eliminates ? fmb_component_optimum_by_elimination : fmb_component_optimum_by_oracle;
    const char *engine = eliminates ? "elimination" : "oracle";
    fmb_status st = FMB_OK;
    for (*ends = true; st == FMB_OK && *c < a->q->parts.count; *c += st == FMB_OK) {
        if (!is_part_asked(a, *c))
            continue;
        const fmb_part *p = &a->q->parts.part[*c];
        st = climb(a->q, a->g, *c, &a->optimum_of_part);
        fmb_run_tell_attempt(&a->q->run, fmb_query_attempt(a->q, *c, engine, "optimum"), st, true);
        if (st == FMB_OK && a->optimum_of_part.kind == FMB_END_INFINITE) {
            fmb_query_scatter(p, a->optimum_of_part.x, a->o->ray);
            *ends = false;
            return answer_endless(a);
        }
        if (a->optimum_of_part.reached)
            note_solution_of_part(a, p, a->optimum_of_part.x);
        if (st == FMB_OK || (st == FMB_LIMIT && a->optimum_of_part.kind == FMB_END_OUTER)) {
            fmb_status added = add_component(a, p);
            *c += st == FMB_LIMIT && added == FMB_OK;
            st = added == FMB_OK ? st : added;
        }
    }
    return st;
}

/* Decide feasibility, then optimize over the parts; *c as above. */
static fmb_status climb_from_solution(ascent *a, int *c, fmb_verdict *verdict)
{
    bool ends = true;
    fmb_status st = lean_all_parts(a);
    FMB_THEN(st, fmb_query_decide(a->q, a->q->session && !fmb_query_eliminates(a->q), verdict));
    if (st != FMB_OK || *verdict != FMB_FEASIBLE)
        return st;
    return_to_solution(a);
    for (size_t k = 0; k < a->g->dim; k++)
        mpq_set(a->best[k], a->q->point[k]);
    int j = find_endless_variable(a);
    if (j >= 0)
        return answer_endless_variable(a, j);
    st = open_optimum_claim(a);
    FMB_THEN(st, climb_all_parts(a, c, &ends));
    return st == FMB_OK && ends ? answer_sum(a) : st;
}

/* ---- at a limit ------------------------------------------------------------------------------ */

/* Bound the remaining parts, from c on, by ends of variables; *bounded: all have a bound. */
static fmb_status bound_remaining_parts(ascent *a, int c, bool *bounded, fmb_verdict *verdict)
{
    fmb_status st = FMB_OK;
    *bounded = find_endless_variable(a) < 0;
    for (; st == FMB_OK && *bounded && c < a->q->parts.count; c++) {
        if (!is_part_asked(a, c))
            continue;
        st = fmb_component_optimum_at_limit(a->q, a->g, c, &a->optimum_of_part);
        if (st == FMB_OK && a->optimum_of_part.clash) {
            *verdict = FMB_INFEASIBLE;
            a->q->run.stop = FMB_STOP_DONE;
            a->claim = NULL; /* it was discarded with all others */
            return FMB_OK;
        }
        *bounded = a->optimum_of_part.kind == FMB_END_OUTER;
        if (st == FMB_OK && *bounded)
            st = add_component(a, &a->q->parts.part[c]);
    }
    return st;
}

/* Answer with an outer end, if one is found; there may be a limit on memory, too. */
static fmb_status settle_for_outer_end(ascent *a, int c, fmb_verdict *verdict)
{
    bool bounded = false;
    a->exact = false;
    fmb_status st = a->lost ? FMB_OK : open_optimum_claim(a);
    if (st == FMB_OK && !a->lost)
        st = bound_remaining_parts(a, c, &bounded, verdict);
    if (*verdict == FMB_INFEASIBLE)
        return st;
    if (st == FMB_OK && bounded)
        st = answer_sum(a);
    if (st != FMB_OK || !bounded)
        drop_optimum_claim(a);
    if (*verdict == FMB_FEASIBLE)
        answer_best_solution(a);
    return st == FMB_OK ? FMB_LIMIT : st;
}

static fmb_status climb_or_settle(ascent *a, fmb_verdict *verdict)
{
    int c = 0;
    fmb_arena_place place = fmb_arena_tell(&a->q->v->arena);
    fmb_status st = climb_from_solution(a, &c, verdict);
    if (st == FMB_LIMIT && a->o->best.kind == FMB_END_UNKNOWN) {
        fmb_outer_release(a->q, place);
        return settle_for_outer_end(a, c, verdict);
    }
    return st;
}

/* ---- the verb -------------------------------------------------------------------------------- */

static fmb_status climb_within_query(fmb_query *q, const fmb_system *s, fmb_wish wish,
                                     fmb_optimum *o, fmb_verdict *verdict)
{
    fmb_goal g;
    ascent a = {.q = q, .g = &g, .o = o, .attained = true, .exact = true};
    fmb_mem *mem = q->run.mem;
    fmb_status st = fmb_goal_init(&g, s, wish, mem);
    if (st == FMB_OK) {
        mpq_init(a.sum);
        st = fmb_component_optimum_init(&a.optimum_of_part, q);
        FMB_THEN(st, fmb_rationals_new(&a.best, g.dim, mem));
        FMB_THEN(st, fmb_query_want_point(q));
        FMB_THEN(st, climb_or_settle(&a, verdict));
        fmb_component_optimum_clear(&a.optimum_of_part, q);
        fmb_rationals_free(a.best, g.dim, mem);
        mpq_clear(a.sum);
    }
    fmb_goal_clear(&g, mem);
    return st;
}

static fmb_status optimize_wish(fmb_solver *v, const fmb_system *s, fmb_wish wish,
                                fmb_optimum **out, fmb_result *res)
{
    fmb_query q;
    fmb_optimum *o = NULL;
    fmb_verdict verdict = FMB_UNKNOWN;
    FMB_TRY(fmb_solver_expect(v, s, out != NULL, res));
    FMB_TRY(fmb_goal_expect(v, s, wish));
    fmb_status st = fmb_query_resume(&q, v, s, "optimize");
    fmb_status made =
        fmb_optimum_new(fmb_wish_sense(s, wish), (size_t)fmb_system_dim(s), &v->mem.alloc, &o);
    if (made == FMB_OK)
        fmb_mem_enter(&o->mem, &v->mem);
    if (st == FMB_OK)
        st = made == FMB_OK ? climb_within_query(&q, s, wish, o, &verdict) : made;
    else if (st == FMB_LIMIT && made != FMB_OK)
        st = made;
    if (o)
        fmb_mem_leave(&o->mem);
    st = fmb_query_end(&q, st, verdict, res);
    if (st == FMB_OK && verdict != FMB_INFEASIBLE) {
        *out = o;
        return FMB_OK;
    }
    fmb_optimum_free(o);
    if (st == FMB_OK)
        *out = NULL;
    return st;
}

fmb_status fmb_optimize(fmb_solver *v, const fmb_system *s, const fmb_objective *objective,
                        fmb_optimum **out, fmb_result *res)
{
    return optimize_wish(v, s, (fmb_wish){.doubles = objective}, out, res);
}

fmb_status fmb_optimize_q(fmb_solver *v, const fmb_system *s, const fmb_objective_q *objective,
                          fmb_optimum **out, fmb_result *res)
{
    return optimize_wish(v, s, (fmb_wish){.rationals = objective}, out, res);
}
