/* generate_hull.c: from vertices, rays and lines to rows (hull/image/image.h). */
#include "solve/generate/some_rays.h"
#include "solve/query/solver.h"
#include "system/generators_private.h"
#include "system/system_private.h"

static fmb_status append_all_facets(const fmb_image *m, fmb_system *out)
{
    for (size_t i = 0; i < m->facets; i++)
        FMB_TRY(fmb_system_append_dense(out, m->n - 1, NULL, NULL, &m->facet[i].v,
                                        m->facet[i].equality ? FMB_EQ : FMB_LE));
    return FMB_OK;
}

/* Find the facets that a few support queries prove. */
static fmb_status find_some_facets(fmb_image *m)
{
    fmb_mem *mem = m->run->mem;
    size_t rows = m->lines + m->rays;
    fmb_image dual = {0};
    for (; m->facets > 0; m->facets--)
        fmb_vec_clear(&m->facet[m->facets - 1].v, m->n, mem);
    fmb_cone_row *row;
    FMB_TRY(FMB_GET(mem, row, rows));
    for (size_t i = 0; i < rows; i++)
        row[i] = i < m->lines ? (fmb_cone_row){.v = &m->line[i], .equality = true}
                              : (fmb_cone_row){.v = &m->ray[i - m->lines]};
    fmb_status st = fmb_find_some_rays(m->run, row, rows, m->n, &dual);
    if (st == FMB_OK && dual.run)
        st = fmb_image_take_facets(m, &dual);
    fmb_image_clear(&dual);
    fmb_mem_put(mem, row, rows, sizeof *row);
    return st;
}

static fmb_status find_facets(fmb_image *m, fmb_system *out)
{
    fmb_run_reserve(m->run);
    fmb_status st = fmb_hull_find_facets(m);
    bool all = st == FMB_OK;
    if (st == FMB_LIMIT)
        st = find_some_facets(m);
    FMB_THEN(st, append_all_facets(m, out));
    return st == FMB_OK && !all ? FMB_LIMIT : st;
}

/* out has no rows yet. */
static fmb_status find_hull(fmb_query *q, const fmb_generators *g, fmb_system *out,
                            fmb_verdict *verdict)
{
    fmb_image m = {0};
    bool *line;
    FMB_TRY(FMB_ARENA_GET(&q->v->arena, line, g->size));
    for (size_t i = 0; i < g->size; i++)
        line[i] = g->kind[i] == FMB_LINE;
    fmb_status st = fmb_image_init_vectors(&m, &q->run, (size_t)g->dim + 1, g->size, g->vec, line,
                                           fmb_query_is_wide(q));
    if (st == FMB_OK)
        *verdict = m.has_point ? FMB_FEASIBLE : FMB_INFEASIBLE;
    if (st == FMB_OK && m.has_point)
        st = find_facets(&m, out);
    fmb_image_clear(&m);
    return st;
}

/* The query runs on a system without rows, of which it needs only the dimension. */
static fmb_status ask_for_hull(fmb_solver *v, const fmb_generators *g, fmb_system *hull,
                               fmb_verdict *verdict, fmb_result *res)
{
    fmb_query q;
    fmb_status st = fmb_query_begin(&q, v, hull, "hull");
    fmb_mem_enter(&hull->mem, &v->mem);
    FMB_THEN(st, find_hull(&q, g, hull, verdict));
    fmb_mem_leave(&hull->mem);
    bool some = st == FMB_OK || (st == FMB_LIMIT && fmb_system_rows(hull) > 0);
    st = fmb_query_end(&q, st, *verdict, res);
    v->answered = false;
    *verdict = some ? *verdict : FMB_UNKNOWN;
    return st;
}

fmb_status fmb_hull(fmb_solver *v, const fmb_generators *g, fmb_system **out, fmb_result *res)
{
    fmb_system *hull = NULL, *empty = NULL;
    fmb_verdict verdict = FMB_UNKNOWN;
    if (!v || !g || !out)
        return fmb_solver_refuse(v, FMB_ERR_ARG, "%s is NULL",
                                 !v   ? "the solver"
                                 : !g ? "g"
                                      : "out");
    FMB_TRY(fmb_solver_expect_result(v, res));
    FMB_TRY(fmb_system_new(g->dim, &v->mem.alloc, &hull));
    fmb_status st = ask_for_hull(v, g, hull, &verdict, res);
    if (st == FMB_OK && verdict == FMB_INFEASIBLE)
        st = fmb_empty_set(hull, NULL, g->dim, &empty);
    if (st == FMB_OK)
        *out = verdict == FMB_FEASIBLE ? hull : empty;
    if (st != FMB_OK || verdict != FMB_FEASIBLE)
        fmb_system_free(hull);
    return st;
}
