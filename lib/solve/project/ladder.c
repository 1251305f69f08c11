/* ladder.c: the projection of one part, and which way leads to it; see ladder.h. */
#include "solve/project/ladder.h"

#include "elim/round/mark.h"
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

/* A few rows are eliminated faster than anything else is done. */
#define TRIAL_BUDGET(m) (128 + 4 * (m))
/* What one variable may make, as a share of the rows: before anything else is tried, and after. */
#define GENTLE 0.25
#define STEEP  1.5
/* So few variables are eliminated however steep that is, where other ways are long. */
#define STEEP_STEPS 2

/* ---- by elimination -------------------------------------------------------------------------- */

/* Many rows for their variables are mostly redundant: then the rule looks before the first pairs,
 * whose number is the square of theirs. Else it waits until rows have doubled. */
static bool has_rows_in_plenty(const fmb_part *p)
{
    return p->m >= 64 && p->m / 8 >= (size_t)p->n;
}

/* budget > 0: the store may not outgrow it. */
static fmb_status eliminate_columns_that_go(shadow *h, bool feasible, size_t budget)
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
    return st == FMB_OK ? fmb_elim_eliminate(&h->e, drop) : st;
}

/* The elimination ended, with a status: put out what is irredundant of its rows; or, at a limit,
 * what names kept variables only. */
static fmb_status put_rows_of_elimination(shadow *h, fmb_elim *e, fmb_status st, bool known,
                                          bool *feasible, bool *done)
{
    size_t rows = fmb_system_rows(h->out);
    *done = st == FMB_OK;
    if (st == FMB_LIMIT && e->over_budget)
        return FMB_OK;
    if (st == FMB_OK)
        *feasible = e->clash == FMB_NO_ROW;
    if (st == FMB_OK && *feasible)
        st = fmb_thin_out(h->q, h->p, h->place, e, known || h->q->decided, h->out, feasible);
    fmb_status saved = FMB_OK;
    bool room = h->q->run.stop != FMB_STOP_DONE && e->n > 0; /* else memory ran out, or no row was
                                                                loaded */
    if (st == FMB_LIMIT && room && fmb_system_rows(h->out) == rows)
        saved = fmb_outer_rows(h->q, h->p, e, h->place, h->out);
    return saved != FMB_OK ? saved : st;
}

static fmb_status project_by_elimination(shadow *h, bool known, size_t budget, bool *feasible,
                                         bool *done)
{
    fmb_status st = eliminate_columns_that_go(h, known, budget);
    st = put_rows_of_elimination(h, &h->e, st, known, feasible, done);
    fmb_elim_clear(&h->e);
    return st;
}

static int count_variables_to_go(const fmb_elim *e, const bool *drop)
{
    int n = 0;
    for (int j = 0; j < e->n; j++) {
        bool named = false;
        for (size_t i = 0; drop[j] && !named && i < e->live.size; i++)
            named = fmb_vec_sgn(&e->row[e->live.row[i]].v, (size_t)j) != 0;
        n += named;
    }
    return n;
}

/* Go on where the cheap variables are gone, and come back if a variable is too steep (0: none is),
 * or if there are too many rows. */
static fmb_status eliminate_rest_of_lift(shadow *h, fmb_lift *lift, double steep, bool *feasible,
                                         bool *done)
{
    const bool *drop;
    fmb_elim *e = fmb_lift_elimination(lift, &drop);
    fmb_mark mark;
    fmb_status st = fmb_mark_set(&mark, e);
    if (st != FMB_OK)
        return st;
    e->order = h->q->v->options.order;
    e->chooser = h->q->v->chooser;
    e->cheap_only = false;
    e->steep = steep;
    e->flat = e->live.size;
    e->budget = e->rows + TRIAL_BUDGET(e->live.size);
    st = put_rows_of_elimination(h, e, fmb_elim_eliminate(e, drop), false, feasible, done);
    if (st == FMB_OK && !*done)
        fmb_mark_return(&mark, e);
    e->over_budget = false;
    return st;
}

/* ---- which way ------------------------------------------------------------------------------- */

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
/* A cone with so few of them has hardly more rays than rows; so few have few even of long numbers,
 * in the plane and above; and one with so many is not tried. */
#define LEAST_FREEDOMS      2
#define LONG_FREEDOMS(kept) ((kept) > 2 ? 8 : 6)
#define MANY_FREEDOMS       32
/* Cones of more have very many rays, but for such with bounds on many variables, as disjunctions.
 */
#define CROWDED_FREEDOMS 12

/* An elimination of rows that name so few variables, and few of all, goes on as one of such, if it
 * is pruned; cones over rows that name no more than so many have more rays than others. */
#define SPARSE                2.5
#define SPARSE_BETWEEN_BOUNDS 3.25
#define DENSE                 4
#define SMALL_CONE            6
/* So many coefficients, most of them there: that there is no solution a linear program finds sooner
 * than rays do. */
#define MANY_ENTRIES 100
/* So many rows mean many rays, but not many queries where few variables are kept. */
#define MANY_ROWS(p) (4 * (size_t)(p)->n)

/* The walk around a shadow is on a dictionary, which becomes dense; it is quick if it has no more
 * columns, and worth it where rows are many for those, as edges are then. */
#define WALKED_COLUMNS 24
/* A hull in so many dimensions mostly has few enough facets. */
#define FEW_KEPT 6
/* In so many, queries are few, and rays soon turned into facets. */
#define SHORT_QUERIES 4
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

static bool is_shadow_walked(const fmb_part *p, int kept)
{
    return kept <= 2 && p->n <= WALKED_COLUMNS && p->m > 2 * (size_t)p->n && !has_strict_rows(p);
}

/* Two questions to the oracle are all there is to do. */
static bool is_only_interval(const fmb_lift *lift, const fmb_part *p, int kept)
{
    return kept <= 1 && !has_strict_rows(p) && fmb_lift_freedom(lift) > LEAST_FREEDOMS;
}

static double named_by_row(const fmb_lift *lift)
{
    return (double)fmb_lift_entries(lift) / (double)fmb_lift_rows(lift);
}

/* Is that share of the rows bounds on one variable? */
static bool has_bounds(const fmb_lift *lift, double share)
{
    return (double)fmb_lift_bounds(lift) >= share * (double)fmb_lift_rows(lift);
}

/* Rays of a first try: half as many where a few queries take as long. */
static uint64_t rays_at_first(const fmb_lift *lift, const fmb_part *p, int kept)
{
    if (fmb_lift_freedom(lift) > MANY_FREEDOMS)
        return 0;
    uint64_t rays = kept <= 2 ? TRIAL_BUDGET(p->m) / 2 : TRIAL_BUDGET(p->m);
    if (fmb_lift_freedom(lift) > CROWDED_FREEDOMS && !(kept > 2 && has_bounds(lift, 0.25)))
        return 0;
    return kept > 2 && kept <= SHORT_QUERIES && p->m > MANY_ROWS(p) ? rays / 4 : rays;
}

static bool is_sparse(const fmb_lift *lift)
{
    double named = named_by_row(lift);
    return named <= (has_bounds(lift, 0.6) ? SPARSE_BETWEEN_BOUNDS : SPARSE) &&
           3 * named <= (double)fmb_lift_columns(lift);
}

static bool is_cone_dense(const fmb_lift *lift)
{
    return named_by_row(lift) >= DENSE || fmb_lift_columns(lift) <= SMALL_CONE;
}

static bool is_contradiction_seen_sooner(const fmb_lift *lift)
{
    size_t entries = fmb_lift_entries(lift);
    return entries >= MANY_ENTRIES && 2 * entries >= fmb_lift_rows(lift) * fmb_lift_columns(lift);
}

/* Rays that a second try may make, before the oracle is asked: none where cones tend to have very
 * many, or rows are many for three kept variables; more where the oracle has more to do, or numbers
 * are too long for its guesses. */
static uint64_t rays_before_queries(const fmb_lift *lift, const fmb_part *p, int kept)
{
    if (fmb_lift_freedom(lift) > FEW_FREEDOMS)
        return 0;
    if (has_strict_rows(p) || kept > SHORT_QUERIES)
        return 16 * RAYS_OF_SECOND_TRY;
    if (kept > 1 && fmb_lift_is_long(lift) && fmb_lift_freedom(lift) <= LONG_FREEDOMS(kept))
        return 8 * RAYS_OF_SECOND_TRY;
    if (p->m > MANY_ROWS(p))
        return 0;
    if (kept == 3 && is_cone_dense(lift))
        return RAYS_OF_SECOND_TRY;
    return kept == 4 ? 8 * RAYS_OF_SECOND_TRY : 0;
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

static shadow shadow_of_rungs(const rungs *r)
{
    return (shadow){.q = r->q,
                    .p = &r->q->parts.part[r->part],
                    .place = r->place,
                    .out = r->out,
                    .e.run = &r->q->run};
}

static fmb_status try_elimination(rungs *r, bool known, size_t budget)
{
    shadow h = shadow_of_rungs(r);
    return project_by_elimination(&h, known, budget, r->feasible, &r->done);
}

static fmb_status try_gentle_elimination(rungs *r)
{
    shadow h = shadow_of_rungs(r);
    const bool *drop;
    return fmb_mark_possible(fmb_lift_elimination(r->lift, &drop))
               ? eliminate_rest_of_lift(&h, r->lift, GENTLE, r->feasible, &r->done)
               : FMB_OK;
}

static fmb_status try_steeper_elimination(rungs *r, int kept)
{
    shadow h = shadow_of_rungs(r);
    const bool *drop;
    fmb_elim *e = fmb_lift_elimination(r->lift, &drop);
    if (!fmb_mark_possible(e))
        return project_by_elimination(&h, false, TRIAL_BUDGET(h.p->m), r->feasible, &r->done);
    bool any = kept > SHORT_QUERIES && count_variables_to_go(e, drop) <= STEEP_STEPS;
    return eliminate_rest_of_lift(&h, r->lift, any ? 0 : STEEP, r->feasible, &r->done);
}

static bool is_open(fmb_status st, const rungs *r)
{
    return st == FMB_OK && !r->done && *r->feasible;
}

static fmb_status open_queries(rungs *r)
{
    r->known = true;
    return r->queries ? FMB_OK
                      : fmb_queries_open(r->q, r->part, r->place, &r->queries, r->feasible);
}

/* By whom the oracle is asked later on, if it is. */
static fmb_status learn_if_feasible(rungs *r)
{
    const fmb_part *p = &r->q->parts.part[r->part];
    if (r->known)
        return FMB_OK;
    if (!is_shadow_walked(p, count_kept_columns(p, r->place)))
        return open_queries(r);
    r->known = true;
    return is_part_feasible(r->q, r->part, r->feasible);
}

/* With the rule that asks the oracle, from the part again. */
static fmb_status try_pruned_elimination(rungs *r)
{
    fmb_status st = learn_if_feasible(r);
    return is_open(st, r) ? try_elimination(r, true, 4 * TRIAL_BUDGET(r->q->parts.part[r->part].m))
                          : st;
}

/* pairs: 0, any number. */
static fmb_status try_queries(rungs *r, uint64_t pairs)
{
    fmb_status st = open_queries(r);
    return is_open(st, r) ? fmb_queries_run(r->queries, pairs, r->out, &r->done) : st;
}

static fmb_status try_walk(rungs *r)
{
    fmb_status st = learn_if_feasible(r);
    return is_open(st, r) ? fmb_query_polygon_part(r->q, r->part, r->place, r->out, &r->done) : st;
}

/* In the plane around it; in a few dimensions, by asking how far it goes; in more, so far. */
static fmb_status try_oracle(rungs *r)
{
    const fmb_part *p = &r->q->parts.part[r->part];
    int kept = count_kept_columns(p, r->place);
    fmb_status st = is_shadow_walked(p, kept) ? try_walk(r) : FMB_OK;
    return is_open(st, r) ? try_queries(r, kept <= FEW_KEPT ? 0 : FIRST_PAIRS) : st;
}

/* A few rays, then what is steeper to eliminate; if both grow, some more rays where there seem to
 * be few. */
static fmb_status try_rays_and_steeper_elimination(rungs *r, int kept)
{
    const fmb_part *p = &r->q->parts.part[r->part];
    uint64_t rays = rays_at_first(r->lift, p, kept);
    fmb_status st = is_contradiction_seen_sooner(r->lift) ? learn_if_feasible(r) : FMB_OK;
    if (is_open(st, r) && rays > 0)
        st = try_rays(r, rays);
    if (is_open(st, r) && kept <= SHORT_QUERIES && fmb_lift_is_nearly_done(r->lift))
        st = try_rays(r, rays);
    if (is_open(st, r) && !fmb_lift_is_long(r->lift))
        st = try_steeper_elimination(r, kept);
    rays = is_open(st, r) ? rays_before_queries(r->lift, p, kept) : 0;
    return rays > 0 ? try_rays(r, rays) : st;
}

/* What is nearly cheap is eliminated; then what rows and numbers are like tells the way; then the
 * oracle is asked. */
static fmb_status try_each_shortly(rungs *r)
{
    const fmb_part *p = &r->q->parts.part[r->part];
    int kept = count_kept_columns(p, r->place);
    fmb_status st = FMB_OK;
    if (!is_only_interval(r->lift, p, kept)) {
        st = try_gentle_elimination(r);
        bool sparse = is_open(st, r) && is_sparse(r->lift);
        if (sparse)
            st = try_pruned_elimination(r);
        if (is_open(st, r))
            st = try_rays_and_steeper_elimination(r, kept);
    }
    return is_open(st, r) ? try_oracle(r) : st;
}

/* What is left is eliminated, and pruned by the oracle, in turns with rays and queries. */
static fmb_status take_turns(rungs *r)
{
    size_t budget = TRIAL_BUDGET(r->q->parts.part[r->part].m);
    uint64_t pairs = FIRST_PAIRS;
    fmb_status st = FMB_OK;
    while (is_open(st, r)) {
        pairs *= 4;
        budget *= 8;
        st = try_rays(r, budget);
        if (is_open(st, r))
            st = try_elimination(r, true, fmb_lift_has_given_up(r->lift) ? 0 : budget);
        if (is_open(st, r))
            st = try_queries(r, pairs);
    }
    return st;
}

static fmb_status climb_rungs(rungs *r)
{
    bool by_rays = r->q->v->options.method == FMB_METHOD_DD;
    size_t rows = fmb_system_rows(r->out);
    fmb_status st = fmb_lift_open(r->q, r->part, r->place, &r->lift, r->feasible);
    if (is_open(st, r))
        st = by_rays ? try_rays(r, 0) : try_each_shortly(r);
    if (is_open(st, r))
        st = by_rays ? try_oracle(r) : FMB_OK;
    if (is_open(st, r))
        st = take_turns(r);
    fmb_status kept = FMB_OK;
    if (st == FMB_LIMIT && r->queries && fmb_system_rows(r->out) == rows)
        kept = fmb_queries_keep(r->queries, r->out);
    fmb_lift_close(r->lift);
    fmb_queries_close(r->queries);
    return kept != FMB_OK ? kept : st;
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
