/* peer_ppl.c: the Parma Polyhedra Library, by its C interface.
 *
 * Outside the clock: the constraint system, and for each run a fresh polyhedron of it
 * (C_Polyhedron, NNC_Polyhedron if a row is strict). Inside: remove_higher_space_dimensions, then
 * get_minimized_constraints. Decide: MIP_Problem::is_satisfiable, an exact simplex, or is_empty if
 * a row is strict.
 */
#include <ppl_c.h>
#include <stdlib.h>

#include "peers.h"

typedef struct state {
    ppl_Constraint_System_t rows;
    ppl_Polyhedron_t body;
    ppl_MIP_Problem_t program;
    ppl_const_Constraint_System_t result; /* owned by body */
    int n, keep;
    bool strict;
} state;

/* b - a.x >= 0, > 0 or = 0 */
static ppl_Constraint_t constraint(const problem_row *r, int n)
{
    static const enum ppl_enum_Constraint_Type type[] = {
        [FMB_LE] = PPL_CONSTRAINT_TYPE_GREATER_OR_EQUAL,
        [FMB_LT] = PPL_CONSTRAINT_TYPE_GREATER_THAN,
        [FMB_EQ] = PPL_CONSTRAINT_TYPE_EQUAL,
    };
    ppl_Linear_Expression_t e;
    ppl_Constraint_t c;
    ppl_Coefficient_t v;
    mpz_t z;
    mpz_init(z);
    ppl_new_Coefficient(&v);
    ppl_new_Linear_Expression_with_dimension(&e, (ppl_dimension_type)n);
    for (int j = 0; j < n; j++) {
        mpz_neg(z, r->a[j]);
        ppl_assign_Coefficient_from_mpz_t(v, z);
        ppl_Linear_Expression_add_to_coefficient(e, (ppl_dimension_type)j, v);
    }
    ppl_assign_Coefficient_from_mpz_t(v, r->a[n]);
    ppl_Linear_Expression_add_to_inhomogeneous(e, v);
    ppl_new_Constraint(&c, e, type[r->rel]);
    ppl_delete_Linear_Expression(e);
    ppl_delete_Coefficient(v);
    mpz_clear(z);
    return c;
}

static void *open_ppl(const problem *p, const peer_setup *setup)
{
    (void)setup;
    state *s = need(calloc(1, sizeof *s));
    *s = (state){.n = p->n, .keep = p->keep, .strict = p->strict};
    ppl_initialize();
    ppl_new_Constraint_System(&s->rows);
    for (size_t i = 0; i < p->m; i++) {
        ppl_Constraint_t c = constraint(&p->rows[i], p->n);
        ppl_Constraint_System_insert_Constraint(s->rows, c);
        ppl_delete_Constraint(c);
    }
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

static void add_constraint(fmb_system *out, ppl_const_Constraint_t c, mpz_t *a)
{
    int n = fmb_system_dim(out), type = ppl_Constraint_type(c);
    ppl_Coefficient_t v;
    ppl_new_Coefficient(&v);
    for (int j = 0; j < n; j++) {
        mpz_set_ui(a[j], 0);
        ppl_dimension_type dim;
        ppl_Constraint_space_dimension(c, &dim);
        if ((ppl_dimension_type)j >= dim)
            continue;
        ppl_Constraint_coefficient(c, (ppl_dimension_type)j, v);
        ppl_Coefficient_to_mpz_t(v, a[j]);
        mpz_neg(a[j], a[j]);
    }
    ppl_Constraint_inhomogeneous_term(c, v);
    ppl_Coefficient_to_mpz_t(v, a[n]);
    ppl_delete_Coefficient(v);
    system_add_row(out, a,
                   type == PPL_CONSTRAINT_TYPE_EQUAL          ? FMB_EQ
                   : type == PPL_CONSTRAINT_TYPE_GREATER_THAN ? FMB_LT
                                                              : FMB_LE);
}

static fmb_system *fetch_ppl(void *self)
{
    state *s = self;
    fmb_system *out = system_of_dim(s->keep);
    mpz_t *a = integers_new((size_t)s->keep + 1);
    ppl_Constraint_System_const_iterator_t at, end;
    ppl_new_Constraint_System_const_iterator(&at);
    ppl_new_Constraint_System_const_iterator(&end);
    ppl_Constraint_System_begin(s->result, at);
    ppl_Constraint_System_end(s->result, end);
    for (; !ppl_Constraint_System_const_iterator_equal_test(at, end);
         ppl_Constraint_System_const_iterator_increment(at)) {
        ppl_const_Constraint_t c;
        ppl_Constraint_System_const_iterator_dereference(at, &c);
        add_constraint(out, c, a);
    }
    ppl_delete_Constraint_System_const_iterator(at);
    ppl_delete_Constraint_System_const_iterator(end);
    integers_free(a, (size_t)s->keep + 1);
    return out;
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
