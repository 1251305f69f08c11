/* ladder.c: the projection of one part, and which way leads to it; see ladder.h. */
#include "solve/project/ladder.h"

#include "solve/limit/outer.h"
#include "solve/project/polygon.h"
#include "solve/project/rays.h"
#include "solve/project/support.h"
#include "solve/project/thin.h"
#include "solve/query/rule_lp.h"

/* One part on its way by elimination. */
typedef struct shadow {
    fmb_query *q;
    const fmb_part *p;
    const int *place; /* [dim] column in the projection, -1 for variables that go */
    fmb_system *out;
    fmb_elim e;
} shadow;

/* ---- by elimination -------------------------------------------------------------------------- */

/* Many rows for their variables are mostly redundant: then the rule looks before the first pairs,
 * whose number is the square of theirs. Else it waits until rows have doubled. */
static bool has_rows_in_plenty(const fmb_part *p)
{
    return p->m >= 64 && p->m / 8 >= (size_t)p->n;
}

/* budget > 0: *done false when the store outgrows it. */
static fmb_status eliminate_uncount_kept_columns(shadow *h, bool feasible, size_t budget,
                                                 bool *done)
{
    fmb_query *q = h->q;
    bool *drop = fmb_arena_get(&q->v->arena, (size_t)h->p->n, sizeof *drop);
    if (!drop)
        return fmb_mem_status(q->run.mem);
    for (int j = 0; j < h->p->n; j++)
        drop[j] = h->place[h->p->var[j]] < 0;
    fmb_status st = fmb_query_load(q, h->p, feasible, &h->e);
    h->e.budget = budget;
    if (st == FMB_OK && feasible && has_rows_in_plenty(h->p))
        st = fmb_elim_prune(&h->e);
    if (st == FMB_OK)
        st = fmb_elim_eliminate(&h->e, drop);
    *done = st == FMB_OK;
    return st == FMB_LIMIT && h->e.over_budget ? FMB_OK : st;
}

static fmb_status project_by_elimination(shadow *h, bool known, size_t budget, bool *feasible,
                                         bool *done)
{
    size_t rows = fmb_system_rows(h->out);
    fmb_status st = eliminate_uncount_kept_columns(h, known, budget, done);
    if (st == FMB_OK && *done)
        *feasible = h->e.clash == FMB_NO_ROW;
    if (st == FMB_OK && *done && *feasible)
        st = fmb_thin_out(h->q, h->p, h->place, &h->e, known || h->q->decided, h->out, feasible);
    fmb_status saved = FMB_OK;
    bool room = h->q->run.stop != FMB_STOP_DONE && h->e.n > 0; /* else memory ran out, or no row
                                                                   was loaded */
    if (st == FMB_LIMIT && room && fmb_system_rows(h->out) == rows)
        saved = fmb_outer_rows(h->q, h->p, &h->e, h->place, h->out);
    fmb_elim_clear(&h->e);
    return saved != FMB_OK ? saved : st;
}

/* ---- which way ------------------------------------------------------------------------------- */

/* A few rows are eliminated faster than anything else is done. */
#define TRIAL_BUDGET(m) (128 + 4 * (m))

static fmb_status is_part_feasible(fmb_query *q, int part, bool *feasible)
{
    fmb_lp *lp;
    return fmb_query_dictionary(q, part, &lp, feasible);
}

static bool uses_lp_rule(const fmb_solver *v)
{
    for (int k = 0; k < v->rules; k++)
        if (v->rule[k] == &fmb_rule_lp)
            return true;
    return false;
}

/* Cones with so few dimensions, or rows beyond them, never had very many rays; and what a second
 * try may make in three kept variables, which takes as long as support queries. */
#define FEW_FREEDOMS       10
#define RAYS_OF_SECOND_TRY 1000

/* The walk around a shadow is on a dictionary, which becomes dense; it is quick if it has no more
 * columns. */
#define WALKED_COLUMNS 24
/* A hull in so many dimensions mostly has few enough facets. */
#define FEW_KEPT 6
/* In more dimensions, so many pairs of facets of a hull take as long as a few queries. */
#define FIRST_PAIRS ((uint64_t)1 << 17)

static int count_kept_columns(const fmb_part *p, const int *place)
{
    int kept = 0;
    for (int j = 0; j < p->n; j++)
        kept += place[p->var[j]] >= 0;
    return kept;
}

static bool has_strict_rows(const fmb_part *p)
{
    for (size_t i = 0; i < p->m; i++)
        if (p->rel[i] == FMB_LT)
            return true;
    return false;
}

/* Rays that a second try may make, before the oracle is asked: none where a shadow is walked
 * around, nor where cones tend to have very many; more where the oracle has more to do, or cannot
 * help. */
static uint64_t rays_before_queries(const fmb_lift *lift, const fmb_part *p, const int *place)
{
    int kept = count_kept_columns(p, place);
    if (fmb_lift_freedom(lift) > FEW_FREEDOMS)
        return 0;
    if (has_strict_rows(p) || kept > 4)
        return 16 * RAYS_OF_SECOND_TRY;
    return kept == 4 ? 8 * RAYS_OF_SECOND_TRY : kept == 3 ? RAYS_OF_SECOND_TRY : 0;
}

/* A part, and what has been found out about it. */
typedef struct rungs {
    fmb_query *q;
    int part;
    const int *place;
    fmb_system *out;
    fmb_lift *lift;
    fmb_queries *queries;
    bool known, *feasible, done;
} rungs;

static fmb_status try_rays(rungs *r, uint64_t rays)
{
    return fmb_lift_run(r->lift, rays, r->out, r->feasible, &r->done);
}

static fmb_status try_elimination(rungs *r, bool known, size_t budget)
{
    shadow h = {.q = r->q,
                .p = &r->q->parts.part[r->part],
                .place = r->place,
                .out = r->out,
                .e.run = &r->q->run};
    return project_by_elimination(&h, known, budget, r->feasible, &r->done);
}

static bool is_open(fmb_status st, const rungs *r)
{
    return st == FMB_OK && !r->done && *r->feasible;
}

/* pairs: 0, any number. */
static fmb_status try_queries(rungs *r, uint64_t pairs)
{
    fmb_status st = FMB_OK;
    if (!r->queries)
        st = fmb_queries_open(r->q, r->part, r->place, &r->queries, r->feasible);
    r->known = true;
    return is_open(st, r) ? fmb_queries_run(r->queries, pairs, r->out, &r->done) : st;
}

static fmb_status try_walk(rungs *r)
{
    fmb_status st = FMB_OK;
    if (!r->known)
        st = is_part_feasible(r->q, r->part, r->feasible);
    r->known = true;
    return is_open(st, r) ? fmb_query_polygon_part(r->q, r->part, r->place, r->out, &r->done) : st;
}

/* In the plane around it; in a few dimensions, by asking how far it goes; in more, so far. */
static fmb_status try_oracle(rungs *r)
{
    const fmb_part *p = &r->q->parts.part[r->part];
    int kept = count_kept_columns(p, r->place);
    fmb_status st = kept <= 2 && p->n <= WALKED_COLUMNS ? try_walk(r) : FMB_OK;
    return is_open(st, r) ? try_queries(r, kept <= FEW_KEPT ? 0 : FIRST_PAIRS) : st;
}

/* A few rays, then a short elimination; if both grow, some more rays where there seem to be few;
 * then the oracle. What is left is eliminated, and pruned by the oracle, in turns with rays and
 * queries. */
static fmb_status climb_rungs(rungs *r)
{
    const fmb_part *p = &r->q->parts.part[r->part];
    size_t budget = TRIAL_BUDGET(p->m);
    uint64_t pairs = FIRST_PAIRS;
    fmb_status st = fmb_lift_open(r->q, r->part, r->place, &r->lift, r->feasible);
    if (is_open(st, r))
        st = try_rays(r, r->q->v->options.method == FMB_METHOD_DD ? 0 : budget);
    if (is_open(st, r))
        st = try_elimination(r, false, budget);
    uint64_t more = is_open(st, r) ? rays_before_queries(r->lift, p, r->place) : 0;
    if (more > 0)
        st = try_rays(r, more);
    if (is_open(st, r))
        st = try_oracle(r);
    while (is_open(st, r)) {
        pairs *= 4;
        budget *= 8;
        st = try_rays(r, budget);
        if (is_open(st, r))
            st = try_elimination(r, true, fmb_lift_has_given_up(r->lift) ? 0 : budget);
        if (is_open(st, r))
            st = try_queries(r, pairs);
    }
    fmb_lift_close(r->lift);
    fmb_queries_close(r->queries);
    return st;
}

fmb_status fmb_query_project_part(fmb_query *q, int part, const int *place, fmb_system *out,
                                  bool *feasible)
{
    rungs r = {.q = q,
               .part = part,
               .place = place,
               .out = out,
               .known = q->decided,
               .feasible = feasible};
    fmb_status st = FMB_OK;
    *feasible = true;
    if (q->v->options.method == FMB_METHOD_HULL)
        return fmb_query_support_part(q, part, place, out, feasible);
    if (!fmb_query_eliminates(q))
        return climb_rungs(&r);
    if (!r.known && uses_lp_rule(q->v)) {
        st = is_part_feasible(q, part, feasible);
        r.known = true;
    }
    return is_open(st, &r) ? try_elimination(&r, r.known, 0) : st;
}
