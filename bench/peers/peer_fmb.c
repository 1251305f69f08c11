/* peer_fmb.c: fmb itself. The solver is made outside the clock. `fmb` keeps no evidence, unless the
 * setup says so; `fmb-proof` keeps all, and fmb_check checks its answers. `fmb-fm`, `fmb-dd` and
 * `fmb-hull` project by one method each. */
#include <math.h>
#include <stdlib.h>

#include "peers.h"

typedef struct state {
    fmb_solver *solver;
    const fmb_system *system;
    const problem *problem;
    int *keep, kept;
    fmb_system *result;
    fmb_box *box;
    fmb_optimum *optimum;
    peer_numbers numbers;
} state;

static void *open_with(const problem *p, const fmb_options *options)
{
    state *s = need(calloc(1, sizeof *s));
    s->system = p->system;
    s->problem = p;
    s->kept = p->keep;
    s->keep = need(calloc((size_t)p->keep + 1, sizeof *s->keep));
    s->numbers.value = need(calloc(2 * (size_t)p->n + 1, sizeof(double)));
    for (int j = 0; j < p->keep; j++)
        s->keep[j] = j;
    if (fmb_solver_new(options, NULL, &s->solver) != FMB_OK)
        need(NULL);
    return s;
}

static void *open_fmb(const problem *p, const peer_setup *setup)
{
    return open_with(p, setup->options);
}

static void *open_proof(const problem *p, const peer_setup *setup)
{
    fmb_options o = *setup->options;
    o.evidence = FMB_EVIDENCE_ALL;
    return open_with(p, &o);
}

static void *open_by(const problem *p, const peer_setup *setup, fmb_method method)
{
    fmb_options o = *setup->options;
    o.method = method;
    return open_with(p, &o);
}

static void *open_fm(const problem *p, const peer_setup *setup)
{
    return open_by(p, setup, FMB_METHOD_FM);
}

static void *open_dd(const problem *p, const peer_setup *setup)
{
    return open_by(p, setup, FMB_METHOD_DD);
}

static void *open_hull(const problem *p, const peer_setup *setup)
{
    return open_by(p, setup, FMB_METHOD_HULL);
}

static void ready_fmb(void *self)
{
    state *s = self;
    fmb_system_free(s->result);
    fmb_box_free(s->box);
    fmb_optimum_free(s->optimum);
    s->result = NULL;
    s->box = NULL;
    s->optimum = NULL;
    s->numbers.n = 0;
}

static bool project_fmb(void *self)
{
    state *s = self;
    fmb_result r = {.size = sizeof r};
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

/* The verdict of a complete answer; UNKNOWN if a limit interrupted it. */
static fmb_verdict whole(fmb_status st, const fmb_result *r)
{
    return st == FMB_OK && r->stop == FMB_STOP_DONE ? r->verdict : FMB_UNKNOWN;
}

static fmb_verdict decide_fmb(void *self)
{
    state *s = self;
    fmb_result r = {.size = sizeof r};
    return whole(fmb_solve(s->solver, s->system, &r), &r);
}

static fmb_verdict box_fmb(void *self)
{
    state *s = self;
    fmb_result r = {.size = sizeof r};
    return whole(fmb_bound(s->solver, s->system, NULL, 0, &s->box, &r), &r);
}

static fmb_verdict reduce_fmb(void *self)
{
    state *s = self;
    fmb_result r = {.size = sizeof r};
    return whole(fmb_reduce(s->solver, s->system, NULL, &s->result, &r), &r);
}

static fmb_verdict optimize_fmb(void *self)
{
    state *s = self;
    fmb_result r = {.size = sizeof r};
    return whole(fmb_optimize(s->solver, s->system, NULL, &s->optimum, &r), &r);
}

static const peer_numbers *numbers_fmb(void *self)
{
    state *s = self;
    s->numbers.n = 0;
    for (int i = 0; s->box && i < fmb_box_size(s->box); i++)
        for (int side = 0; side < 2; side++)
            s->numbers.value[s->numbers.n++] = fmb_box_end(s->box, i, (fmb_side)side).value;
    if (s->result)
        s->numbers.value[s->numbers.n++] = (double)fmb_system_rows(s->result);
    if (s->optimum)
        s->numbers.value[s->numbers.n++] = fmb_optimum_end(s->optimum).value;
    return &s->numbers;
}

/* What the evidence of an answer must hold. */
static fmb_demand demand_of(peer_question question, fmb_verdict verdict)
{
    if (verdict == FMB_INFEASIBLE)
        return FMB_DEMAND_INFEASIBLE;
    return question == PEER_DECIDE   ? FMB_DEMAND_FEASIBLE
           : question == PEER_BOX    ? FMB_DEMAND_BOUNDS
           : question == PEER_REDUCE ? FMB_DEMAND_REDUCED
                                     : FMB_DEMAND_OPTIMUM;
}

static bool prove_fmb(void *self, peer_question question)
{
    state *s = self;
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    bool meets = false;
    if (fmb_solver_evidence(s->solver, &e) != FMB_OK || fmb_check(s->system, e, &j) != FMB_OK ||
        fmb_evidence_meets(e, s->system, demand_of(question, j.verdict), NULL, &meets, NULL, 0) !=
            FMB_OK)
        meets = false;
    fmb_evidence_free(e);
    return j.accepted && meets;
}

static void close_fmb(void *self)
{
    state *s = self;
    ready_fmb(s);
    fmb_solver_free(s->solver);
    free(s->numbers.value);
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
    .box = box_fmb,
    .reduce = reduce_fmb,
    .optimize = optimize_fmb,
    .numbers = numbers_fmb,
    .close = close_fmb,
};

const peer peer_fmb_proof = {
    .name = "fmb-proof",
    .library = "fmb",
    .ours = true,
    .open = open_proof,
    .ready = ready_fmb,
    .decide = decide_fmb,
    .box = box_fmb,
    .reduce = reduce_fmb,
    .optimize = optimize_fmb,
    .numbers = numbers_fmb,
    .prove = prove_fmb,
    .close = close_fmb,
};

const peer peer_fmb_fm = {
    .name = "fmb-fm",
    .library = "fmb",
    .ours = true,
    .single = true,
    .open = open_fm,
    .ready = ready_fmb,
    .project = project_fmb,
    .fetch = fetch_fmb,
    .close = close_fmb,
};

const peer peer_fmb_dd = {
    .name = "fmb-dd",
    .library = "fmb",
    .ours = true,
    .single = true,
    .open = open_dd,
    .ready = ready_fmb,
    .project = project_fmb,
    .fetch = fetch_fmb,
    .close = close_fmb,
};

const peer peer_fmb_hull = {
    .name = "fmb-hull",
    .library = "fmb",
    .ours = true,
    .single = true,
    .open = open_hull,
    .ready = ready_fmb,
    .project = project_fmb,
    .fetch = fetch_fmb,
    .close = close_fmb,
};
