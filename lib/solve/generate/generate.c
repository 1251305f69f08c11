/* generate.c: from rows to vertices, rays and lines (generate_rays.c). */
#include "solve/generate/some_rays.h"
#include "system/generators_private.h"
#include "system/system_private.h"

/* Is there a point in the closure, and for every strict row one where the row is strict? */
static bool has_solution(fmb_lifted *h)
{
    bool solution = h->image.has_point;
    for (size_t i = 0; solution && i < h->rows.size; i++) {
        bool positive = !h->rows.row[i].wanted;
        for (size_t k = 0; !positive && k < h->image.rays; k++)
            positive = fmb_image_value_sign(&h->image, &h->rows.v[i], &h->image.ray[k]) > 0;
        solution = positive;
    }
    return solution;
}

/* Vertices, then rays, then lines. */
static fmb_status copy_generators(const fmb_lifted *h, fmb_generators *to)
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

/* From the rays in h->image: decide whether there is a solution, and copy the generators. */
static fmb_status take_generators(fmb_lifted *h, fmb_generators *to, fmb_verdict *verdict)
{
    bool solution = has_solution(h);
    *verdict = solution ? FMB_FEASIBLE : FMB_INFEASIBLE;
    return solution ? copy_generators(h, to) : FMB_OK;
}

/* Find some generators after a limit. If they show no solution, the verdict stays UNKNOWN. */
static fmb_status generate_some(fmb_lifted *h, fmb_generators *to, fmb_verdict *verdict)
{
    fmb_run *run = &h->q->run;
    fmb_verdict seen = FMB_UNKNOWN;
    fmb_image_clear(&h->image);
    fmb_cone_clear(&h->cone);
    fmb_status st = fmb_find_some_rays(run, h->rows.row, h->rows.size, h->d, &h->image);
    if (st == FMB_OK && h->image.run)
        st = take_generators(h, to, &seen);
    if (seen == FMB_FEASIBLE)
        *verdict = seen;
    return st == FMB_OK ? FMB_LIMIT : st;
}

static fmb_status generate_system(fmb_query *q, fmb_generators *to, fmb_verdict *verdict)
{
    fmb_lifted h;
    fmb_status st = q->evidence ? fmb_query_decide(q, true, verdict) : FMB_OK;
    if (st != FMB_OK || *verdict == FMB_INFEASIBLE)
        return st;
    fmb_run_reserve(&q->run);
    st = fmb_lifted_open(&h, q, q->s);
    bool open = st == FMB_OK;
    FMB_THEN(st, fmb_lifted_find_rays(&h));
    if (st == FMB_OK)
        st = take_generators(&h, to, verdict);
    else if (open && st == FMB_LIMIT)
        st = generate_some(&h, to, verdict);
    fmb_lifted_close(&h);
    return st;
}

fmb_status fmb_generate(fmb_solver *v, const fmb_system *s, fmb_generators **out, fmb_result *res)
{
    fmb_query q;
    fmb_generators *g = NULL;
    fmb_verdict verdict = FMB_UNKNOWN;
    FMB_TRY(fmb_solver_expect(v, s, out != NULL, res));
    fmb_status st = fmb_query_begin(&q, v, s, "vertices");
    fmb_status opened = fmb_generators_new(fmb_system_dim(s), &v->mem.alloc, &g);
    if (opened == FMB_OK)
        fmb_mem_enter(&g->mem, &v->mem);
    else if (st == FMB_OK || st == FMB_LIMIT)
        st = opened;
    FMB_THEN(st, generate_system(&q, g, &verdict));
    bool some = (st == FMB_OK || st == FMB_LIMIT) && g && g->size > 0;
    if (g)
        fmb_mem_leave(&g->mem);
    st = fmb_query_end(&q, st, verdict, res);
    if (!some || st != FMB_OK) {
        fmb_generators_free(g);
        g = NULL;
    }
    if (st == FMB_OK)
        *out = g;
    return st;
}
