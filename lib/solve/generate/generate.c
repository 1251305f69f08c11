/* generate.c: from rows to vertices, rays and lines, by double description (dd/cone.h). */
#include <string.h>

#include "dd/image.h"
#include "solve/query/solver.h"
#include "system/generators.h"
#include "system/system.h"

/* The cone over the solutions of a system: row 0 is t >= 0, row 1 + i is row i. */
typedef struct lifted_system {
    fmb_query *q;
    size_t d, rows;
    fmb_cone_row *row; /* [rows] */
    fmb_vec *v;        /* [rows] */
    size_t *keep;      /* [d] all coordinates */
    fmb_cone cone;
    fmb_image image;
} lifted_system;

/* a.x <= b as b t - a.x >= 0; z[d]. */
static fmb_status lift_system_row(lifted_system *h, size_t i, mpz_t *z)
{
    const fmb_sysrow *r = i > 0 ? fmb_system_row(h->q->s, i - 1) : NULL;
    fmb_vec *v = &h->v[i];
    v->s = fmb_arena_get(&h->q->v->arena, h->d, sizeof *v->s);
    if (!v->s)
        return fmb_mem_status(h->q->run.mem);
    for (size_t k = 0; k < h->d; k++)
        mpz_set_ui(z[k], r ? 0 : k + 1 == h->d);
    for (size_t k = 0; r && k < r->nnz; k++) {
        fmb_vec_get(&r->val, k, z[r->var[k]]);
        mpz_neg(z[r->var[k]], z[r->var[k]]);
    }
    if (r)
        fmb_vec_get(&r->val, r->nnz, z[h->d - 1]);
    h->row[i] =
        (fmb_cone_row){.v = v, .equality = r && r->rel == FMB_EQ, .wanted = r && r->rel == FMB_LT};
    fmb_status st = fmb_vec_set_z(v, h->d, z, h->q->run.mem);
    return st == FMB_OK ? fmb_run_poll(&h->q->run) : st;
}

static fmb_status lift_system_rows(lifted_system *h)
{
    fmb_arena *arena = &h->q->v->arena;
    fmb_mem *mem = h->q->run.mem;
    size_t rows = fmb_system_rows(h->q->s) + 1;
    h->d = (size_t)fmb_system_dim(h->q->s) + 1;
    h->row = fmb_arena_get(arena, rows, sizeof *h->row);
    h->v = fmb_arena_get(arena, rows, sizeof *h->v);
    h->keep = fmb_arena_get(arena, h->d, sizeof *h->keep);
    mpz_t *z = h->row && h->v && h->keep ? fmb_vec_block(h->d, mem) : NULL;
    if (!z)
        return fmb_mem_status(mem);
    for (size_t i = 0; i < rows; i++)
        h->v[i] = (fmb_vec){0};
    h->rows = rows;
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < rows; i++)
        st = lift_system_row(h, i, z);
    for (size_t k = 0; k < h->d; k++) {
        h->keep[k] = k;
        mpz_clear(z[k]);
    }
    fmb_mem_put(mem, z, h->d, sizeof *z);
    return st;
}

/* Is some point in the closure, and every strict row positive somewhere? */
static bool has_solution(const lifted_system *h)
{
    const fmb_cone *c = &h->cone;
    bool solution = h->image.has_point;
    for (size_t b = 0; solution && b < c->bits; b++) {
        bool positive = !h->row[c->row_of_bit[b]].wanted;
        for (size_t i = 0; !positive && i < c->ray.size; i++)
            positive = fmb_cone_is_positive(c, i, b);
        solution = positive;
    }
    return solution;
}

static fmb_status find_generators(lifted_system *h)
{
    bool done, wide = fmb_query_is_wide(h->q);
    fmb_status st = lift_system_rows(h);
    fmb_cone_problem of = {
        .d = h->d, .m = h->rows, .row = h->row, .keeps = h->d, .keep = h->keep, .wide_only = wide};
    if (st == FMB_OK)
        st = fmb_cone_init(&h->cone, &h->q->run, &of);
    if (st == FMB_OK)
        st = fmb_cone_run(&h->cone, 0, &done);
    return st == FMB_OK ? fmb_image_init(&h->image, &h->q->run, &h->cone, wide) : st;
}

static void close_lifted_system(lifted_system *h)
{
    for (size_t i = 0; i < h->rows; i++)
        fmb_vec_clear(&h->v[i], h->d, h->q->run.mem);
    fmb_image_clear(&h->image);
    fmb_cone_clear(&h->cone);
}

/* Vertices, then rays, then lines. */
static fmb_status copy_generators(const lifted_system *h, fmb_generators *to)
{
    const fmb_image *m = &h->image;
    fmb_status st = FMB_OK;
    for (int kind = FMB_VERTEX; kind <= FMB_RAY; kind++)
        for (size_t i = 0; st == FMB_OK && i < m->rays; i++) {
            bool vertex = fmb_vec_sgn(&m->ray[i], h->d - 1) > 0;
            if (vertex == (kind == FMB_VERTEX))
                st = fmb_generators_append(to, (fmb_generator_kind)kind, &m->ray[i]);
        }
    for (size_t i = 0; st == FMB_OK && i < m->lines; i++)
        st = fmb_generators_append(to, FMB_LINE, &m->line[i]);
    return st;
}

static fmb_status generate_system(fmb_query *q, fmb_generators *to, fmb_verdict *verdict)
{
    lifted_system h = {.q = q};
    fmb_status st = q->evidence ? fmb_query_decide(q, true, verdict) : FMB_OK;
    if (st != FMB_OK || *verdict == FMB_INFEASIBLE)
        return st;
    st = find_generators(&h);
    if (st == FMB_OK)
        *verdict = has_solution(&h) ? FMB_FEASIBLE : FMB_INFEASIBLE;
    if (st == FMB_OK && *verdict == FMB_FEASIBLE)
        st = copy_generators(&h, to);
    close_lifted_system(&h);
    return st;
}

fmb_status fmb_generate(fmb_solver *v, const fmb_system *s, fmb_generators **out, fmb_result *res)
{
    fmb_query q;
    fmb_generators *g = NULL;
    fmb_verdict verdict = FMB_UNKNOWN;
    fmb_status st = fmb_solver_expect(v, s, out != NULL);
    if (st != FMB_OK)
        return st;
    st = fmb_query_begin(&q, v, s, "vertices");
    fmb_status opened = fmb_generators_new(fmb_system_dim(s), &v->mem.alloc, &g);
    if (opened == FMB_OK)
        fmb_mem_enter(&g->mem, &v->mem);
    else if (st == FMB_OK || st == FMB_LIMIT)
        st = opened;
    if (st == FMB_OK)
        st = generate_system(&q, g, &verdict);
    bool done = st == FMB_OK && verdict == FMB_FEASIBLE;
    if (g)
        fmb_mem_leave(&g->mem);
    st = fmb_query_end(&q, st, verdict, res);
    if (!done || st != FMB_OK) {
        fmb_generators_free(g);
        g = NULL;
    }
    if (st == FMB_OK)
        *out = g;
    return st;
}
