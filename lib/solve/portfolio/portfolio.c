/* portfolio.c: the projection of one part, by one of several engines; see portfolio.h. */
#include "solve/portfolio/portfolio.h"

#include <math.h>

#include "base/ways.h"
#include "elim/round/mark.h"
#include "solve/limit/outer.h"
#include "solve/portfolio/project_elimination.h"
#include "solve/portfolio/project_rays.h"
#include "solve/portfolio/project_support.h"
#include "solve/portfolio/race.h"
#include "solve/portfolio/selection.h"
#include "solve/portfolio/slices.h"
#include "solve/prepare/recession.h"
#include "solve/prepare/reduced_part.h"
#include "solve/query/rule_lp.h"

/* The most additional rows that one variable may make, as a share of all rows. */
#define MOST_GROWTH 0.25

/* ---- which way ------------------------------------------------------------------------------- */

static fmb_status is_part_feasible(fmb_query *q, int part, bool *feasible)
{
    fmb_oracle *o;
    fmb_status st = fmb_query_oracle(q, part, &o);
    *feasible = true;
    return st == FMB_OK && !fmb_oracle_has_solution(o) ? fmb_oracle_feasible(o, feasible) : st;
}

static bool uses_lp_rule(const fmb_solver *v)
{
    for (int k = 0; k < v->rules; k++)
        if (v->rule[k] == &fmb_rule_lp)
            return true;
    return false;
}

/* A part, and the state of its projection. */
typedef struct part_run {
    fmb_query *q;
    int part;
    const int *place;
    fmb_system *out;
    fmb_reduced_part reduced;
    fmb_features features; /* of the reduced part */
    fmb_ray_projection *rays;
    fmb_queries *queries;
    fmb_part_elimination e; /* the elimination that takes turns */
    fmb_slices slices;
    bool races;    /* queries may run in parallel with other engines */
    bool ready;    /* an engine knows the answer, which is not yet appended */
    size_t engine; /* the one that ran last */
    bool begun;    /* that engine could be opened */
    bool known, *feasible, done;
} part_run;

static bool is_answered(const part_run *r)
{
    return r->done || !*r->feasible;
}

/* budget [steps] 0: to the end. */
static void tell_attempt(part_run *r, const char *engine, uint64_t budget, fmb_status st)
{
    fmb_attempt a = fmb_query_attempt(r->q, r->part, engine, "projection");
    a.budget = budget;
    a.unit = budget > 0 ? "steps" : NULL;
    fmb_run_tell_attempt(&r->q->run, a, st, is_answered(r));
}

static fmb_part_elimination elimination_of_run(const part_run *r)
{
    return (fmb_part_elimination){.q = r->q,
                                  .p = &r->q->parts.part[r->part],
                                  .place = r->place,
                                  .out = r->out,
                                  .e.run = &r->q->run};
}

static fmb_status try_elimination(part_run *r, bool known)
{
    fmb_part_elimination h = elimination_of_run(r);
    fmb_status st = fmb_project_by_elimination(&h, known, r->feasible, &r->done);
    tell_attempt(r, "elimination", 0, st);
    return st;
}

/* A search for a recession direction may take this fraction, 1 / SHARE_FOR_RECESSION, of the work
 * expected of the best engine. */
#define SHARE_FOR_RECESSION 16

/* Try to drop all rows that name variables to eliminate, by a recession direction. */
static fmb_status try_recession(part_run *r, const fmb_choice *c)
{
    double best = INFINITY;
    for (size_t k = 0; k < FMB_ENGINES; k++)
        best = fmin(best, c->work[k]);
    fmb_part_elimination h = elimination_of_run(r);
    bool recedes;
    fmb_elim *e = &r->reduced.e;
    fmb_status st =
        fmb_recession_drop_rows(e, r->reduced.drop, best / SHARE_FOR_RECESSION, &recedes);
    if (st == FMB_OK && recedes)
        st = fmb_put_rows_of_elimination(&h, e, FMB_OK, false, r->feasible, &r->done);
    tell_attempt(r, "recession direction", 0, st);
    return st;
}

/* A trial elimination ended with st; if it left too many rows, it counts as over budget. */
static fmb_status expect_few_rows(fmb_elim *e, fmb_status st, int kept)
{
    if (st != FMB_OK || e->clash != FMB_NO_ROW || fmb_selection_keeps_rows(e, e->flat, kept))
        return st;
    e->over_budget = true;
    return FMB_LIMIT;
}

/* Continue the elimination of the reduced part; restore it if a variable makes too many rows, if
 * too many rows are left, or if the work exceeds budget (0: no bound). */
static fmb_status try_bounded_elimination(part_run *r, uint64_t budget)
{
    fmb_part_elimination h = elimination_of_run(r);
    fmb_elim *e = &r->reduced.e;
    fmb_run *run = &r->q->run;
    fmb_mark mark;
    if (!fmb_mark_possible(e))
        return FMB_OK;
    FMB_TRY(fmb_mark_set(&mark, e));
    e->order = h.q->v->options.order;
    e->chooser = h.q->v->chooser;
    e->cheap_only = false;
    e->growth = MOST_GROWTH;
    e->flat = e->live.size;
    e->pauses = true;
    run->slice_end = budget > 0 ? run->work + budget : 0;
    fmb_status st = fmb_elim_eliminate(e, r->reduced.drop);
    run->slice_end = 0;
    st = expect_few_rows(e, st, r->features.kept);
    st = fmb_put_rows_of_elimination(&h, e, st, false, r->feasible, &r->done);
    if (st == FMB_OK && !r->done)
        fmb_mark_return(&mark, e);
    e->over_budget = false;
    tell_attempt(r, "bounded elimination", budget, st);
    return st;
}

static bool is_open(fmb_status st, const part_run *r)
{
    return st == FMB_OK && !r->ready && !r->done && *r->feasible;
}

/* ---- engines --------------------------------------------------------------------------------- */

static fmb_status open_queries(part_run *r)
{
    r->known = true;
    return r->queries
               ? FMB_OK
               : fmb_queries_open(r->q, r->part, r->place, r->races, &r->queries, r->feasible);
}

static fmb_status open_rays(part_run *r)
{
    return r->rays ? FMB_OK : fmb_ray_projection_open(&r->reduced, &r->rays);
}

static fmb_status go_on_with_rays(part_run *r)
{
    return fmb_ray_projection_run(r->rays, r->feasible, &r->ready);
}

static fmb_status put_rays(part_run *r, fmb_status st)
{
    FMB_THEN(st, fmb_ray_projection_put(r->rays, r->out, r->feasible));
    r->done = st == FMB_OK;
    return st;
}

static fmb_status go_on_with_queries(part_run *r)
{
    return fmb_queries_run(r->queries, &r->ready);
}

static fmb_status put_queries(part_run *r, fmb_status st)
{
    st = fmb_queries_put(r->queries, r->out, st);
    r->done = st == FMB_OK;
    return st;
}

/* Open an elimination of the whole part, with the rule "lp". */
static fmb_status open_elimination(part_run *r)
{
    fmb_status st = r->known ? FMB_OK : open_queries(r);
    if (r->e.q || !is_open(st, r))
        return st;
    r->e = elimination_of_run(r);
    st = fmb_query_load(r->q, r->e.p, true, &r->e.e);
    r->e.e.pauses = true;
    return st == FMB_OK && fmb_has_rows_in_plenty(r->e.p) ? fmb_elim_prune(&r->e.e) : st;
}

static fmb_status go_on_with_elimination(part_run *r)
{
    fmb_status st = fmb_elim_eliminate(&r->e.e, r->reduced.drop);
    r->ready = st == FMB_OK;
    return st == FMB_LIMIT && r->e.e.paused ? FMB_OK : st;
}

static fmb_status put_elimination(part_run *r, fmb_status st)
{
    return fmb_put_rows_of_elimination(&r->e, &r->e.e, st, true, r->feasible, &r->done);
}

static const struct engine {
    const char *name;
    fmb_status (*open)(part_run *); /* unless it is open */
    fmb_status (*go_on)(part_run *);
    fmb_status (*put)(part_run *, fmb_status); /* append the rows; after LIMIT those proved */
    int way;                                   /* its switch; FMB_WAY_COUNT: none */
} ENGINE[] = {
    [FMB_ENGINE_RAYS] = {"double description", open_rays, go_on_with_rays, put_rays, FMB_WAY_RAYS},
    [FMB_ENGINE_ELIMINATION] = {"elimination", open_elimination, go_on_with_elimination,
                                put_elimination, FMB_WAY_PRUNED},
    [FMB_ENGINE_QUERIES] = {"support queries", open_queries, go_on_with_queries, put_queries,
                            FMB_WAY_COUNT},
};

_Static_assert(sizeof ENGINE / sizeof *ENGINE == FMB_ENGINES &&
                   (size_t)FMB_ENGINES <= (size_t)FMB_MOST_ENGINES,
               "all engines take turns");

static void tell_slice(part_run *r, size_t k, uint64_t slice, fmb_status st)
{
    const fmb_slice_engine *e = &r->slices.engine[k];
    fmb_attempt a = fmb_query_attempt(r->q, r->part, ENGINE[k].name, "projection");
    a.budget = slice;
    a.unit = "steps";
    a.ended = e->over ? "unsuitable" : "paused";
    a.spent = e->spent;
    a.left = e->expected > (double)e->spent ? (uint64_t)(e->expected - (double)e->spent) : 0;
    fmb_run_tell_attempt(&r->q->run, a, st, is_answered(r));
}

static fmb_run *run_of_engine(part_run *r, size_t k)
{
    fmb_share *share = k == FMB_ENGINE_QUERIES && r->queries ? fmb_queries_share(r->queries) : NULL;
    return share ? &share->run : &r->q->run;
}

/* Continue engine k for that slice of work, 0: to its end. */
static fmb_status run_engine(part_run *r, size_t k, uint64_t slice)
{
    uint64_t before = r->q->run.work;
    fmb_status st = ENGINE[k].open(r);
    fmb_run *run = run_of_engine(r, k);
    run->slice_end = slice > 0 ? run->work + slice : 0;
    r->engine = k;
    r->begun = is_open(st, r);
    if (r->begun)
        st = ENGINE[k].go_on(r);
    run->slice_end = 0;
    if (run == &r->q->run)
        r->slices.engine[k].spent += run->work - before;
    else
        r->slices.engine[k].spent = run->work;
    r->slices.engine[FMB_ENGINE_RAYS].over |= r->rays && fmb_ray_projection_has_given_up(r->rays);
    return st;
}

/* Append the rows of the engine that ran last, which is ready or has reached a limit. */
static fmb_status put_out(part_run *r, fmb_status st)
{
    fmb_run *run = run_of_engine(r, r->engine);
    if (r->q->run.stop == FMB_STOP_DONE)
        r->q->run.stop = run->stop;
    bool known = st == FMB_OK && r->ready && *r->feasible;
    return known || (st == FMB_LIMIT && r->begun) ? ENGINE[r->engine].put(r, st) : st;
}

static fmb_status take_slice(part_run *r, size_t k, uint64_t slice)
{
    fmb_status st = put_out(r, run_engine(r, k, slice));
    tell_slice(r, k, slice, st);
    return st;
}

/* ---- two at once ----------------------------------------------------------------------------- */

static fmb_status go_on_with_queries_alone(void *run, bool *ready)
{
    part_run *r = run;
    return fmb_queries_run(r->queries, ready);
}

/* Is there an engine other than queries? */
static bool has_others(const part_run *r)
{
    bool any = false;
    for (size_t k = 0; k < FMB_ENGINES; k++)
        any |= k != FMB_ENGINE_QUERIES && !r->slices.engine[k].over;
    return any;
}

/* Run the other engines in turns. */
static fmb_status go_on_with_others(void *run, bool *ready)
{
    part_run *r = run;
    fmb_status st = FMB_OK;
    while (is_open(st, r) && has_others(r) && !fmb_run_is_overtaken(&r->q->run)) {
        uint64_t slice;
        size_t k = fmb_slices_next(&r->slices, &slice);
        st = run_engine(r, k, slice);
        if (is_open(st, r))
            tell_slice(r, k, slice, st);
    }
    *ready = r->ready;
    return st;
}

/* Race queries, in another thread, against the other engines. */
static fmb_status race_queries(part_run *r)
{
    fmb_status opened = open_queries(r);
    if (!is_open(opened, r))
        return opened;
    fmb_run *run = &r->q->run;
    fmb_share *share = fmb_queries_share(r->queries);
    fmb_slice_engine *queries = &r->slices.engine[FMB_ENGINE_QUERIES];
    fmb_race race = {.lane = {{.run = run, .go_on = go_on_with_others},
                              {.run = &share->run, .go_on = go_on_with_queries_alone}},
                     .self = r};
    size_t winner, threads = run->threads;
    queries->over = true;
    run->threads--;
    fmb_status st = fmb_race_run(&race, run->mem, &share->mem, &winner);
    run->threads = threads;
    queries->spent = share->run.work;
    if (winner == 1) {
        r->engine = FMB_ENGINE_QUERIES;
        r->begun = true;
        r->ready = race.lane[1].ready;
        run->stop = share->run.stop; /* the limit of the losing engines does not count */
    } else {
        tell_slice(r, FMB_ENGINE_QUERIES, 0, FMB_OK);
    }
    st = put_out(r, st);
    tell_slice(r, r->engine, 0, st);
    return st;
}

/* ---- all of them ----------------------------------------------------------------------------- */

/* The oracle shows infeasibility sooner than any engine does, and most engines need its answer
 * anyway. */
static fmb_status find_whether_feasible(part_run *r)
{
    fmb_status st = is_part_feasible(r->q, r->part, r->feasible);
    r->known = st == FMB_OK;
    return st;
}

static fmb_status take_first_steps(part_run *r, const fmb_choice *c)
{
    fmb_status st = c->verdict && !r->known ? find_whether_feasible(r) : FMB_OK;
    if (is_open(st, r) && c->recession && fmb_way(FMB_WAY_RECESSION)) {
        st = try_recession(r, c);
        fmb_way_answered(FMB_WAY_RECESSION, st == FMB_OK && is_answered(r));
    }
    if (is_open(st, r) && c->bounded > 0 && fmb_way(FMB_WAY_BOUNDED_GROWTH)) {
        st = try_bounded_elimination(r, c->bounded);
        fmb_way_answered(FMB_WAY_BOUNDED_GROWTH, st == FMB_OK && is_answered(r));
    }
    return st;
}

/* Can a study switch this engine off? */
static bool has_switch(size_t engine)
{
    return ENGINE[engine].way != FMB_WAY_COUNT;
}

static void expect_work(part_run *r, const fmb_choice *c)
{
    r->slices.engines = FMB_ENGINES;
    for (size_t k = 0; k < FMB_ENGINES; k++) {
        r->slices.engine[k].expected = c->work[k];
        r->slices.engine[k].over =
            isinf(c->work[k]) || (has_switch(k) && !fmb_way((fmb_way_id)ENGINE[k].way));
    }
    r->races = r->q->run.threads > 1 && !r->q->session && has_others(r) &&
               !r->slices.engine[FMB_ENGINE_QUERIES].over;
}

/* Shall the race begin? While the first engine is expected to end soonest, it has all threads. */
static bool is_race_on(size_t last, size_t next)
{
    return last != FMB_ENGINES && (last == FMB_ENGINE_QUERIES) != (next == FMB_ENGINE_QUERIES);
}

static fmb_status take_turns(part_run *r, const fmb_choice *c)
{
    fmb_status st = FMB_OK;
    uint64_t slice;
    expect_work(r, c);
    for (size_t k, last = FMB_ENGINES; is_open(st, r); last = k) {
        k = fmb_slices_next(&r->slices, &slice);
        if (r->races && is_race_on(last, k))
            return race_queries(r);
        st = take_slice(r, k, slice);
        if (has_switch(k))
            fmb_way_answered((fmb_way_id)ENGINE[k].way, st == FMB_OK && is_answered(r));
    }
    return st;
}

/* At a limit of time while another engine runs: what an elimination has proved until its last slice
 * counts, too. */
static fmb_status put_rows_of_paused_elimination(part_run *r)
{
    const bool paused = r->e.q && r->e.e.n > 0 && r->engine != FMB_ENGINE_ELIMINATION;
    return paused && r->q->run.stop != FMB_STOP_DONE
               ? fmb_outer_rows(r->q, r->e.p, &r->e.e, r->place, r->out)
               : FMB_OK;
}

static fmb_status run_portfolio(part_run *r)
{
    bool by_rays = r->q->v->options.method == FMB_METHOD_DD;
    fmb_status st = fmb_query_write_rows(r->q, r->part);
    if (st == FMB_OK && !by_rays && !r->known && r->q->parts.part[r->part].wide)
        st = find_whether_feasible(r);
    r->reduced.e.run = &r->q->run; /* closed even after an error */
    if (is_open(st, r))
        st = fmb_reduced_part_open(&r->reduced, r->q, r->part, r->place, r->feasible);
    if (is_open(st, r))
        r->features = fmb_features_of(&r->reduced);
    r->known = r->known || r->features.has_origin;
    if (is_open(st, r) && by_rays)
        st = take_slice(r, FMB_ENGINE_RAYS, 0);
    if (is_open(st, r) && !by_rays && !r->reduced.rest) /* nothing is left to choose */
        st = try_bounded_elimination(r, 0);
    if (is_open(st, r)) {
        fmb_choice c = fmb_selection_of(&r->features);
        if (!by_rays)
            st = take_first_steps(r, &c);
        if (is_open(st, r))
            st = take_turns(r, &c);
    }
    fmb_status proved = st == FMB_LIMIT ? put_rows_of_paused_elimination(r) : FMB_OK;
    if (r->e.q)
        fmb_elim_clear(&r->e.e);
    fmb_ray_projection_close(r->rays);
    fmb_reduced_part_close(&r->reduced);
    fmb_status kept =
        st == FMB_LIMIT && r->queries ? fmb_queries_finish(r->queries, r->out) : FMB_OK;
    fmb_queries_close(r->queries);
    return proved != FMB_OK ? proved : kept != FMB_OK ? kept : st;
}

fmb_status fmb_query_project_part(fmb_query *q, int part, const int *place, fmb_system *out,
                                  bool *feasible)
{
    part_run r = {.q = q,
                  .part = part,
                  .place = place,
                  .out = out,
                  .known = q->decided,
                  .feasible = feasible};
    fmb_status st = FMB_OK;
    *feasible = true;
    if (q->v->options.method == FMB_METHOD_HULL) {
        st = fmb_query_support_part(q, part, place, out, feasible);
        r.done = st == FMB_OK;
        tell_attempt(&r, "support queries", 0, st);
        return st;
    }
    if (!fmb_query_eliminates(q))
        return run_portfolio(&r);
    if (!r.known && uses_lp_rule(q->v)) {
        st = is_part_feasible(q, part, feasible);
        r.known = true;
    }
    return is_open(st, &r) ? try_elimination(&r, r.known) : st;
}
