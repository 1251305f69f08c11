/* peer_fmb.c: fmb itself. The solver is made outside the clock; no evidence is kept. */
#include <stdlib.h>

#include "peers.h"

typedef struct state {
    fmb_solver *solver;
    const fmb_system *system;
    int *keep, kept;
    fmb_system *result;
} state;

static void *open_fmb(const problem *p, const peer_setup *setup)
{
    state *s = need(calloc(1, sizeof *s));
    s->system = p->system;
    s->kept = p->keep;
    s->keep = need(calloc((size_t)p->keep + 1, sizeof *s->keep));
    for (int j = 0; j < p->keep; j++)
        s->keep[j] = j;
    if (fmb_solver_new(setup->options, NULL, &s->solver) != FMB_OK)
        need(NULL);
    return s;
}

static void ready_fmb(void *self)
{
    state *s = self;
    fmb_system_free(s->result);
    s->result = NULL;
}

static bool project_fmb(void *self)
{
    state *s = self;
    fmb_result r = {0};
    return fmb_project(s->solver, s->system, s->keep, s->kept, &s->result, &r) == FMB_OK &&
           r.stop == FMB_STOP_DONE;
}

static fmb_system *fetch_fmb(void *self)
{
    state *s = self;
    fmb_system *copy = NULL;
    if (fmb_system_copy(s->result, &copy) != FMB_OK)
        need(NULL);
    return copy;
}

static fmb_verdict decide_fmb(void *self)
{
    state *s = self;
    fmb_result r = {0};
    return fmb_solve(s->solver, s->system, &r) == FMB_OK ? r.verdict : FMB_UNKNOWN;
}

static void close_fmb(void *self)
{
    state *s = self;
    ready_fmb(s);
    fmb_solver_free(s->solver);
    free(s->keep);
    free(s);
}

const peer peer_fmb = {
    .name = "fmb",
    .library = "fmb",
    .ours = true,
    .open = open_fmb,
    .ready = ready_fmb,
    .project = project_fmb,
    .fetch = fetch_fmb,
    .decide = decide_fmb,
    .close = close_fmb,
};
