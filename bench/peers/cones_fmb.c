/* cones_fmb.c: fmb_generate and fmb_hull. The solver is made outside the clock; no evidence. */
#include <stdlib.h>

#include "peers.h"

typedef struct state {
    fmb_solver *solver;
    const problem *problem;
    fmb_generators *generators;
    fmb_system *hull;
} state;

static void *open_fmb(const problem *p, const peer_setup *setup)
{
    state *s = need(calloc(1, sizeof *s));
    s->problem = p;
    if (p->strict) {
        free(s);
        return NULL;
    }
    if (fmb_solver_new(setup->options, NULL, &s->solver) != FMB_OK)
        need(NULL);
    return s;
}

static void ready_fmb(void *self)
{
    state *s = self;
    fmb_generators_free(s->generators);
    fmb_system_free(s->hull);
    s->generators = NULL;
    s->hull = NULL;
}

static bool vertices_fmb(void *self)
{
    state *s = self;
    fmb_result r = {.size = sizeof r};
    return fmb_generate(s->solver, s->problem->system, &s->generators, &r) == FMB_OK &&
           r.stop == FMB_STOP_DONE;
}

static bool hull_fmb(void *self)
{
    state *s = self;
    fmb_result r = {.size = sizeof r};
    return fmb_hull(s->solver, s->problem->generators, &s->hull, &r) == FMB_OK &&
           r.stop == FMB_STOP_DONE;
}

static fmb_system *fetch_fmb(void *self)
{
    state *s = self;
    fmb_system *out = NULL;
    if (s->hull) {
        if (fmb_system_copy(s->hull, &out) != FMB_OK)
            need(NULL);
        return out;
    }
    return s->generators ? system_of_generators(s->generators) : system_of_dim(s->problem->n);
}

static void close_fmb(void *self)
{
    state *s = self;
    ready_fmb(s);
    fmb_solver_free(s->solver);
    free(s);
}

const peer peer_fmb_cones = {
    .name = "fmb",
    .library = "fmb",
    .ours = true,
    .open = open_fmb,
    .ready = ready_fmb,
    .vertices = vertices_fmb,
    .hull = hull_fmb,
    .fetch = fetch_fmb,
    .close = close_fmb,
};
