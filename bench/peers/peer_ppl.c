/* peer_ppl.c: the Parma Polyhedra Library, by its C interface.
 *
 * Outside the clock: the constraint system, and for each run a fresh polyhedron of it
 * (C_Polyhedron, NNC_Polyhedron if a row is strict). Inside: remove_higher_space_dimensions, then
 * get_minimized_constraints. Decide: MIP_Problem::is_satisfiable, an exact simplex, or is_empty if
 * a row is strict.
 */
#include <stdlib.h>

#include "with_ppl.h"

typedef struct state {
    ppl_Constraint_System_t rows;
    ppl_Polyhedron_t body;
    ppl_MIP_Problem_t program;
    ppl_const_Constraint_System_t result; /* owned by body */
    int n, keep;
    bool strict;
} state;

static void *open_ppl(const problem *p, const peer_setup *setup)
{
    (void)setup;
    state *s = need(calloc(1, sizeof *s));
    *s = (state){.n = p->n, .keep = p->keep, .strict = p->strict};
    ppl_initialize();
    s->rows = ppl_rows(p);
    return s;
}

static void forget(state *s)
{
    if (s->body)
        ppl_delete_Polyhedron(s->body);
    if (s->program)
        ppl_delete_MIP_Problem(s->program);
    s->body = NULL;
    s->program = NULL;
    s->result = NULL;
}

static void ready_ppl(void *self)
{
    state *s = self;
    ppl_dimension_type n = (ppl_dimension_type)s->n;
    forget(s);
    if (s->strict)
        ppl_new_NNC_Polyhedron_from_space_dimension(&s->body, n, 0);
    else
        ppl_new_C_Polyhedron_from_space_dimension(&s->body, n, 0);
    ppl_Polyhedron_add_constraints(s->body, s->rows);
    if (s->strict)
        return;
    ppl_new_MIP_Problem_from_space_dimension(&s->program, n);
    ppl_MIP_Problem_add_constraints(s->program, s->rows);
}

static bool project_ppl(void *self)
{
    state *s = self;
    return ppl_Polyhedron_remove_higher_space_dimensions(s->body, (ppl_dimension_type)s->keep) >=
               0 &&
           ppl_Polyhedron_get_minimized_constraints(s->body, &s->result) >= 0;
}

static fmb_system *fetch_ppl(void *self)
{
    const state *s = self;
    return ppl_system(s->result, s->keep);
}

static fmb_verdict decide_ppl(void *self)
{
    state *s = self;
    bool yes = s->strict ? !ppl_Polyhedron_is_empty(s->body)
                         : ppl_MIP_Problem_is_satisfiable(s->program) > 0;
    return yes ? FMB_FEASIBLE : FMB_INFEASIBLE;
}

static void close_ppl(void *self)
{
    state *s = self;
    forget(s);
    ppl_delete_Constraint_System(s->rows);
    free(s);
}

const peer peer_ppl = {
    .name = "ppl",
    .library = "ppl",
    .open = open_ppl,
    .ready = ready_ppl,
    .project = project_ppl,
    .fetch = fetch_ppl,
    .decide = decide_ppl,
    .close = close_ppl,
};
