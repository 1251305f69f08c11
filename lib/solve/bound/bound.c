/* bound.c: the tightest interval of each variable.
 *
 * Each end is a linear program in the variable's own part, started from the previous optimal
 * vertex. With method fm the part's other variables are eliminated instead (halving.c). At a limit,
 * unknown ends become the best bounds that can be proved at little cost (outer.h).
 */
#include "solve/bound/ends.h"
#include "solve/limit/outer.h"

/* ---- by the oracle --------------------------------------------------------------------------- */

static fmb_status push_end_by_oracle(fmb_bound_job *j, int part)
{
    fmb_oracle *o;
    fmb_found_end f;
    fmb_mem *mem = j->q->run.mem;
    size_t n = (size_t)j->p->n;
    FMB_TRY(fmb_query_feasible_oracle(j->q, part, &o));
    fmb_status st = fmb_found_end_init(&f, n, j->q->claims != NULL, mem);
    FMB_THEN(st, fmb_find_end(o, j->column, j->sign, mem, &f));
    FMB_THEN(st, fmb_note_end(j, &f));
    fmb_found_end_clear(&f, n, mem);
    return st;
}

/* ---- all of them ----------------------------------------------------------------------------- */

static fmb_status find_end_by_oracle(fmb_query *q, int var, fmb_side side, fmb_exact_side *end)
{
    int part = q->parts.of_var[var];
    fmb_bound_job j = {
        .q = q, .var = var, .side = side, .sign = side == FMB_LOWER ? -1 : 1, .end = end};
    if (part < 0) {
        fmb_status st = fmb_bound_claim_unbounded(&j);
        j.end->kind = st == FMB_OK ? FMB_END_INFINITE : FMB_END_UNKNOWN;
        return st;
    }
    j.p = &q->parts.part[part];
    j.column = q->parts.place[var];
    return push_end_by_oracle(&j, part);
}

/* First the lower ends, then the upper ones: consecutive optima often share a vertex. */
static fmb_status find_ends_of_part(fmb_query *q, fmb_box *box, int i, const int *next)
{
    for (int k = FMB_LOWER; k <= FMB_UPPER; k++)
        for (int at = i; at >= 0; at = next[at])
            FMB_TRY(find_end_by_oracle(q, box->var[at], (fmb_side)k, &box->side[at][k]));
    return FMB_OK;
}

/* Part by part, as there may be many: an oracle is closed before the next one is opened. */
static fmb_status find_ends_by_oracles(fmb_query *q, fmb_box *box, const bool *done)
{
    fmb_status st = FMB_OK;
    int *first, *next;
    FMB_TRY(FMB_ARENA_GET(&q->v->arena, first, (size_t)q->parts.count + 1));
    FMB_TRY(FMB_ARENA_GET(&q->v->arena, next, (size_t)box->size));
    for (int c = -1; c < q->parts.count; c++)
        first[c + 1] = -1;
    for (int i = box->size - 1; i >= 0; i--) {
        int *head = &first[q->parts.of_var[box->var[i]] + 1];
        next[i] = *head;
        *head = i;
    }
    for (int c = -1; st == FMB_OK && c < q->parts.count; c++) {
        if (c >= 0 && done[c])
            continue;
        st = find_ends_of_part(q, box, first[c + 1], next);
        if (c < 0 || first[c + 1] < 0)
            continue;
        fmb_run_tell_attempt(&q->run, fmb_query_attempt(q, c, "oracle", "ends"), st, true);
        fmb_query_close_oracle(q, c);
    }
    return st;
}

/* Few ends are not worth a second thread. */
#define FEW_ENDS 32

/* Bound the queried variables of a part by several threads, if that may pay; *done if so. */
static fmb_status bound_part_together(fmb_query *q, int part, fmb_box *box, bool *done)
{
    int count = 0;
    *done = false;
    if (q->v->options.threads < 2 || q->session)
        return FMB_OK;
    int *place;
    FMB_TRY(FMB_ARENA_GET(&q->v->arena, place, (size_t)box->size));
    for (int i = 0; i < box->size; i++)
        if (q->parts.of_var[box->var[i]] == part)
            place[count++] = i;
    *done = 2 * count > FEW_ENDS;
    return *done ? fmb_find_ends_together(q, part, box, place, count) : FMB_OK;
}

static fmb_status bound_variables_asked(fmb_query *q, fmb_box *box)
{
    bool fm = fmb_query_eliminates(q);
    size_t parts = (size_t)q->parts.count;
    fmb_status st = FMB_OK;
    bool *done;
    FMB_TRY(FMB_ARENA_GET(&q->v->arena, done, parts));
    for (int c = 0; st == FMB_OK && c < q->parts.count; c++) {
        done[c] = fm;
        st = fm ? fmb_bound_by_elimination(q, c, box) : bound_part_together(q, c, box, &done[c]);
        fmb_attempt told = fmb_query_attempt(q, c, fm ? "elimination" : "oracles", "ends");
        if (done[c])
            fmb_run_tell_attempt(&q->run, told, st, true);
    }
    return st == FMB_OK ? find_ends_by_oracles(q, box, done) : st;
}

static fmb_status bound_or_outer_box(fmb_query *q, fmb_box *box, fmb_verdict *verdict)
{
    fmb_arena_place place = fmb_arena_tell(&q->v->arena);
    fmb_status st = fmb_query_decide(q, q->session && !fmb_query_eliminates(q), verdict);
    if (st == FMB_OK && *verdict == FMB_FEASIBLE)
        st = bound_variables_asked(q, box);
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
    FMB_TRY(fmb_solver_expect(v, s, out != NULL, res));
    FMB_TRY(fmb_solver_expect_variables(v, s, "vars", vars, n));
    fmb_status st = fmb_query_resume(&q, v, s, "bound");
    fmb_status made = fmb_box_new(vars, vars ? n : fmb_system_dim(s), &v->mem.alloc, &box);
    if (made == FMB_OK)
        fmb_mem_enter(&box->mem, &v->mem);
    if (st == FMB_OK)
        st = made == FMB_OK ? bound_or_outer_box(&q, box, &verdict) : made;
    else if (st == FMB_LIMIT && made != FMB_OK)
        st = made;
    if (box)
        fmb_mem_leave(&box->mem);
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
