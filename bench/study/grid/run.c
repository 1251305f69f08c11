/* run.c: see run.h. The counts come from the events of the query, so that they count the
 * elimination alone, whatever else the query does. */
#include "study/grid/run.h"

#include <string.h>

#include "study/clock/clock.h"
#include "study/fmplex/fmplex.h"

static uint64_t larger(uint64_t a, uint64_t b)
{
    return a > b ? a : b;
}

static uint64_t *dropped_by(study_engine *e, const char *name)
{
    study_names *names = e->names;
    for (size_t i = 0; i < names->size; i++)
        if (strcmp(names->name[i], name) == 0)
            return &e->run->dropped[i];
    if (names->size == STUDY_MOST_NAMES)
        return NULL;
    names->name[names->size] = name;
    return &e->run->dropped[names->size++];
}

static void put(void *self, const fmb_event *event)
{
    study_engine *e = self;
    uint64_t *dropped;
    switch (event->kind) {
    case FMB_EVENT_ROUND:
        e->run->pairs += event->pairs;
        e->run->made += event->made;
        e->run->lived += event->rows_out;
        if (e->run->rounds < STUDY_MOST_ROUNDS)
            e->run->alive[e->run->rounds] = event->rows_out;
        e->run->rounds++;
        e->run->peak = larger(e->run->peak, larger(event->rows_in, event->rows_out));
        break;
    case FMB_EVENT_RULE:
        dropped = dropped_by(e, event->name);
        if (dropped)
            *dropped += event->dropped;
        break;
    default:
        break;
    }
}

static fmb_status open_solver(const fmb_options *o, const study_way *way, fmb_solver **out)
{
    fmb_status st = fmb_solver_new(o, NULL, out);
    for (size_t i = 0; st == FMB_OK && way->added && way->added[i]; i++)
        st = fmb_solver_add_rule(*out, way->added[i]);
    if (st == FMB_OK)
        fmb_solver_set_chooser(*out, way->chooser);
    return st;
}

fmb_status study_engine_open(study_engine *e, const study_way *way, const study_limits *limits,
                             study_names *names)
{
    fmb_options o = {.size = sizeof o};
    *e = (study_engine){.names = names};
    o.method = FMB_METHOD_FM;
    if (way->method && fmb_options_set(&o, "method", way->method) != FMB_OK)
        return FMB_ERR_ARG;
    if (way->evidence && fmb_options_set(&o, "evidence", way->evidence) != FMB_OK)
        return FMB_ERR_ARG;
    e->by_fmplex = way->rules && strcmp(way->rules, "fmplex") == 0;
    o.rules = e->by_fmplex ? NULL : way->rules;
    o.order = way->order;
    o.presolve = limits->presolve;
    o.max_rows = limits->max_rows;
    o.max_seconds = limits->max_seconds;
    fmb_status st = open_solver(&o, way, &e->counting);
    if (st == FMB_OK)
        st = open_solver(&o, way, &e->timing);
    if (st != FMB_OK)
        study_engine_close(e);
    return st;
}

void study_engine_close(study_engine *e)
{
    fmb_solver_free(e->counting);
    fmb_solver_free(e->timing);
    e->counting = e->timing = NULL;
}

fmb_status study_engine_count(study_engine *e, const fmb_system *s, const int *keep, int n,
                              study_run *run, fmb_system **projection)
{
    fmb_result r = {.size = sizeof r};
    *projection = NULL;
    if (e->by_fmplex) {
        run->outcome = STUDY_REFUSED;
        return FMB_OK;
    }
    e->run = run;
    fmb_solver_set_sink(e->counting, (fmb_sink){put, e});
    fmb_status st =
        keep ? fmb_project(e->counting, s, keep, n, projection, &r) : fmb_solve(e->counting, s, &r);
    if (st == FMB_ERR_RULE) {
        run->outcome = STUDY_REFUSED;
        return FMB_OK;
    }
    if (st != FMB_OK)
        return st;
    run->outcome = r.stop == FMB_STOP_DONE ? STUDY_DECIDED : STUDY_STOPPED;
    run->stop = r.stop;
    run->verdict = r.verdict;
    run->kept = r.stats.rows_kept;
    run->held = r.stats.rows_peak;
    return FMB_OK;
}

fmb_status study_engine_time(study_engine *e, const fmb_system *s, const int *keep, int n,
                             fmb_verdict truth, study_run *run)
{
    fmb_result r = {.size = sizeof r};
    fmb_system *projection = NULL;
    double begin = study_thread_seconds();
    fmb_status st = e->by_fmplex ? study_fmplex_solve(e->timing, s, &r)
                    : keep       ? fmb_project(e->timing, s, keep, n, &projection, &r)
                                 : fmb_solve(e->timing, s, &r);
    run->seconds = study_thread_seconds() - begin;
    fmb_system_free(projection);
    if (st == FMB_ERR_RULE) {
        run->solved = STUDY_REFUSED;
        return FMB_OK;
    }
    if (st != FMB_OK)
        return st;
    bool wrong = truth != FMB_UNKNOWN && r.verdict != truth;
    run->solved = r.stop != FMB_STOP_DONE ? STUDY_STOPPED : wrong ? STUDY_WRONG : STUDY_DECIDED;
    return FMB_OK;
}
