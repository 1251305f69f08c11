/* cones_ppl.c: the Parma Polyhedra Library: minimized generators of constraints, minimized
 * constraints of generators. Outside the clock: the system, and a fresh polyhedron of it for each
 * run. */
#include <stdlib.h>

#include "with_ppl.h"

typedef struct state {
    ppl_Constraint_System_t rows;
    ppl_Generator_System_t points;
    ppl_Polyhedron_t body;
    ppl_const_Constraint_System_t constraints; /* results, owned by body */
    ppl_const_Generator_System_t generators;
    int n;
    bool hull;
} state;

static void insert_point(state *s, const problem_row *r)
{
    ppl_Generator_t g;
    ppl_Coefficient_t d;
    bool vertex = mpz_sgn(r->a[s->n]) > 0;
    ppl_Linear_Expression_t e = ppl_expression(r, s->n, false, false);
    ppl_new_Coefficient(&d);
    ppl_assign_Coefficient_from_mpz_t(d, r->a[s->n]);
    ppl_new_Generator(&g, e,
                      r->rel == FMB_EQ ? PPL_GENERATOR_TYPE_LINE
                      : vertex         ? PPL_GENERATOR_TYPE_POINT
                                       : PPL_GENERATOR_TYPE_RAY,
                      d);
    ppl_Generator_System_insert_Generator(s->points, g);
    ppl_delete_Generator(g);
    ppl_delete_Coefficient(d);
    ppl_delete_Linear_Expression(e);
}

static void *open_ppl(const problem *p, const peer_setup *setup)
{
    if (p->strict)
        return NULL;
    state *s = need(calloc(1, sizeof *s));
    *s = (state){.n = p->n, .hull = setup->question == PEER_HULL};
    ppl_initialize();
    if (!s->hull) {
        s->rows = ppl_rows(p);
        return s;
    }
    ppl_new_Generator_System(&s->points);
    for (size_t i = 0; i < p->m; i++)
        insert_point(s, &p->rows[i]);
    return s;
}

static void forget(state *s)
{
    if (s->body)
        ppl_delete_Polyhedron(s->body);
    s->body = NULL;
}

static void ready_ppl(void *self)
{
    state *s = self;
    forget(s);
    ppl_new_C_Polyhedron_from_space_dimension(&s->body, (ppl_dimension_type)s->n, s->hull);
    if (s->hull)
        ppl_Polyhedron_add_generators(s->body, s->points);
    else
        ppl_Polyhedron_add_constraints(s->body, s->rows);
}

static bool vertices_ppl(void *self)
{
    state *s = self;
    return ppl_Polyhedron_get_minimized_generators(s->body, &s->generators) >= 0;
}

static bool hull_ppl(void *self)
{
    state *s = self;
    return ppl_Polyhedron_get_minimized_constraints(s->body, &s->constraints) >= 0;
}

/* ---- results --------------------------------------------------------------------------------- */

static void add_generator(fmb_system *out, ppl_const_Generator_t g, ppl_Coefficient_t v, mpz_t *a)
{
    int n = fmb_system_dim(out), type = ppl_Generator_type(g);
    ppl_dimension_type dim;
    ppl_Generator_space_dimension(g, &dim);
    for (int j = 0; j < n; j++) {
        mpz_set_ui(a[j], 0);
        if ((ppl_dimension_type)j >= dim)
            continue;
        ppl_Generator_coefficient(g, (ppl_dimension_type)j, v);
        ppl_Coefficient_to_mpz_t(v, a[j]);
    }
    mpz_set_ui(a[n], 0);
    if (type == PPL_GENERATOR_TYPE_POINT) {
        ppl_Generator_divisor(g, v);
        ppl_Coefficient_to_mpz_t(v, a[n]);
    }
    system_add_row(out, a, type == PPL_GENERATOR_TYPE_LINE ? FMB_EQ : FMB_LE);
}

static void add_all_generators(const state *s, fmb_system *out, ppl_Coefficient_t v, mpz_t *a)
{
    ppl_Generator_System_const_iterator_t at, end;
    ppl_new_Generator_System_const_iterator(&at);
    ppl_new_Generator_System_const_iterator(&end);
    ppl_Generator_System_begin(s->generators, at);
    ppl_Generator_System_end(s->generators, end);
    for (; !ppl_Generator_System_const_iterator_equal_test(at, end);
         ppl_Generator_System_const_iterator_increment(at)) {
        ppl_const_Generator_t g;
        ppl_Generator_System_const_iterator_dereference(at, &g);
        add_generator(out, g, v, a);
    }
    ppl_delete_Generator_System_const_iterator(at);
    ppl_delete_Generator_System_const_iterator(end);
}

static fmb_system *fetch_ppl(void *self)
{
    const state *s = self;
    if (s->hull)
        return ppl_system(s->constraints, s->n);
    fmb_system *out = system_of_dim(s->n);
    mpz_t *a = integers_new((size_t)s->n + 1);
    ppl_Coefficient_t v;
    ppl_new_Coefficient(&v);
    add_all_generators(s, out, v, a);
    ppl_delete_Coefficient(v);
    integers_free(a, (size_t)s->n + 1);
    return out;
}

static void close_ppl(void *self)
{
    state *s = self;
    forget(s);
    if (s->hull)
        ppl_delete_Generator_System(s->points);
    else
        ppl_delete_Constraint_System(s->rows);
    free(s);
}

const peer peer_ppl_cones = {
    .name = "ppl",
    .library = "ppl",
    .open = open_ppl,
    .ready = ready_ppl,
    .vertices = vertices_ppl,
    .hull = hull_ppl,
    .fetch = fetch_ppl,
    .close = close_ppl,
};
