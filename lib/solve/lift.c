/* lift.c: images, Minkowski sums and hulls of unions: each is the projection of a lifted system
 * (lift/lift_private.h). */
#include <fmb/lift.h>

#include "lift/lift_private.h"
#include "solve/query/solver.h"
#include "system/system_private.h"

/* The outputs of a verb. */
typedef struct lift_answer {
    fmb_system **lift; /* or NULL */
    fmb_system **out;
    fmb_result *res;
    const fmb_system *like, *graph; /* name the variables; graph may be NULL */
} lift_answer;

/* Fail with the error text that the lift holds. */
static fmb_status give_up_lift(fmb_solver *v, fmb_system *lift, fmb_status st)
{
    if (st == FMB_ERR_ARG)
        st = fmb_solver_refuse(v, st, "%s", fmb_system_trouble(lift));
    else
        v->answered = false; /* the evidence at hand is that of an older query */
    fmb_system_free(lift);
    return st;
}

/* Project the lift on its first variables. Its memory counts as that of the query. */
static fmb_status project_lift(fmb_solver *v, fmb_system *lift, fmb_system **out, fmb_result *res)
{
    int n = fmb_lift_dim(lift);
    int *keep = fmb_mem_get(&v->mem, (size_t)n, sizeof *keep);
    if (!keep) {
        v->answered = false;
        return FMB_ERR_MEMORY;
    }
    for (int j = 0; j < n; j++)
        keep[j] = j;
    fmb_mem_enter(&lift->mem, &v->mem);
    fmb_status st = fmb_project(v, lift, keep, n, out, res);
    fmb_mem_leave(&lift->mem);
    fmb_mem_put(&v->mem, keep, (size_t)n, sizeof *keep);
    return st;
}

/* Give the whole space, all that is known at a limit. */
static fmb_status give_whole_space(fmb_solver *v, const fmb_result *r, const lift_answer *a)
{
    fmb_system *space = NULL;
    v->answered = false; /* the evidence at hand is that of an older query */
    fmb_status st = fmb_system_new(0, &v->mem.alloc, &space);
    FMB_THEN(st, a->graph ? fmb_lift_add_answer_of_graph(space, a->like, a->graph)
                          : fmb_lift_add_answer(space, a->like));
    if (st != FMB_OK) {
        fmb_system_free(space);
        return st;
    }
    space->asks_projection = false;
    for (int j = 0; j < fmb_system_dim(space); j++)
        space->mark[j].kept = false;
    if (a->lift)
        *a->lift = NULL;
    *a->out = space;
    fmb_result_give(a->res, r);
    return FMB_OK;
}

/* Count the lift, which is still empty, against the memory limit of a query. */
static void limit_lift(fmb_solver *v, fmb_system *lift)
{
    if (v->options.max_bytes > 0)
        fmb_arena_clear(&v->arena); /* memory of older queries must not count for this one */
    v->mem.limit = v->options.max_bytes;
    fmb_mem_enter(&lift->mem, &v->mem);
}

/* Project lift and hand out the answers; filling it, with a limit, ended with st. Takes lift. */
static fmb_status finish_lift(fmb_solver *v, fmb_system *lift, fmb_status st, const lift_answer *a)
{
    const fmb_result at_limit = {.size = sizeof at_limit, .stop = FMB_STOP_BYTES};
    fmb_mem_leave(&lift->mem);
    v->mem.limit = 0;
    if (st == FMB_LIMIT) {
        fmb_system_free(lift);
        return give_whole_space(v, &at_limit, a);
    }
    if (st != FMB_OK)
        return give_up_lift(v, lift, st);
    st = project_lift(v, lift, a->out, a->res);
    if (st == FMB_OK && a->lift)
        *a->lift = lift;
    else
        fmb_system_free(lift);
    return st;
}

/* [give] An empty system for a verb with these arguments. */
static fmb_status open_lift(fmb_solver *v, const char *missing, const fmb_result *res,
                            fmb_system **lift)
{
    if (!v || missing)
        return fmb_solver_refuse(v, FMB_ERR_ARG, "%s is NULL", v ? missing : "the solver");
    FMB_TRY(fmb_solver_expect_result(v, res));
    fmb_status st = fmb_system_new(0, &v->mem.alloc, lift);
    if (st != FMB_OK)
        v->answered = false;
    return st;
}

fmb_status fmb_image(fmb_solver *v, const fmb_system *s, const fmb_system *graph, fmb_system **lift,
                     fmb_system **out, fmb_result *res)
{
    fmb_system *t = NULL;
    FMB_TRY(open_lift(v, !s ? "s" : !graph ? "graph" : out ? NULL : "out", res, &t));
    limit_lift(v, t);
    fmb_status st = fmb_lift_image(t, s, graph);
    return finish_lift(v, t, st, &(lift_answer){lift, out, res, s, graph});
}

fmb_status fmb_sum(fmb_solver *v, const fmb_system *const *s, size_t n, fmb_system **lift,
                   fmb_system **out, fmb_result *res)
{
    fmb_system *t = NULL;
    FMB_TRY(open_lift(v, out ? NULL : "out", res, &t));
    fmb_status st = fmb_lift_match(t, s, n);
    if (st != FMB_OK)
        return give_up_lift(v, t, st);
    limit_lift(v, t);
    st = fmb_lift_sum(t, s, n);
    return finish_lift(v, t, st, &(lift_answer){lift, out, res, s[0], NULL});
}

/* ---- hulls of several ------------------------------------------------------------------------ */

/* Choose the nonempty ones of s, in order. At a limit *verdict is UNKNOWN, and r->stop says which.
 * Proofs of these verdicts are not kept, as no answer shows them. */
static fmb_status choose_nonempty(fmb_solver *v, const fmb_system *const *s, size_t n,
                                  const fmb_system **chosen, size_t *size, fmb_result *r)
{
    fmb_evidence_kept kept = v->options.evidence;
    fmb_status st = FMB_OK;
    r->verdict = FMB_FEASIBLE;
    v->options.evidence = FMB_EVIDENCE_NONE;
    for (size_t k = 0; st == FMB_OK && k < n && r->verdict != FMB_UNKNOWN; k++) {
        st = fmb_solve(v, s[k], r);
        if (st == FMB_OK && r->verdict == FMB_FEASIBLE)
            chosen[(*size)++] = s[k];
    }
    v->options.evidence = kept;
    v->answered = false;
    return st;
}

/* chosen[n] is scratch. All queries share one deadline and one cancel. */
static fmb_status find_hull_of_nonempty(fmb_solver *v, const fmb_system *const *s, size_t n,
                                        const fmb_system **chosen, fmb_system *t,
                                        const lift_answer *a)
{
    fmb_result r = {.size = sizeof r};
    fmb_run all;
    size_t size = 0;
    const fmb_run *within = v->within;
    atomic_store_explicit(&v->cancel, 0, memory_order_relaxed);
    fmb_run_begin(&all, &v->mem, &v->options, &v->cancel, (fmb_sink){NULL, NULL}, "hull");
    v->mem.limit = 0;
    v->within = within ? within : &all;
    fmb_status st = choose_nonempty(v, s, n, chosen, &size, &r);
    if (st == FMB_OK && r.verdict != FMB_UNKNOWN) {
        limit_lift(v, t);
        st = finish_lift(v, t, fmb_lift_hull(t, s[0], chosen, size), a);
    } else {
        fmb_system_free(t);
        st = st == FMB_OK ? give_whole_space(v, &r, a) : st;
    }
    v->within = within;
    return st;
}

fmb_status fmb_hull_union(fmb_solver *v, const fmb_system *const *s, size_t n, fmb_system **lift,
                          fmb_system **out, fmb_result *res)
{
    fmb_system *t = NULL;
    FMB_TRY(open_lift(v, out ? NULL : "out", res, &t));
    fmb_status st = fmb_lift_match(t, s, n);
    if (st != FMB_OK)
        return give_up_lift(v, t, st);
    const fmb_system **chosen = fmb_mem_get(&v->mem, n, sizeof *chosen);
    if (!chosen)
        return give_up_lift(v, t, FMB_ERR_MEMORY);
    st = find_hull_of_nonempty(v, s, n, chosen, t, &(lift_answer){lift, out, res, s[0], NULL});
    fmb_mem_put(&v->mem, chosen, n, sizeof *chosen);
    return st;
}
