/* polygon.c: projections on one or two variables by linear programs; see polygon.h.
 *
 * On one variable the projection is an interval: two programs. On two it is a polygon, and the
 * oracle walks around it (hull/shadow/shadow_walk.c). The multipliers of each end or edge prove its
 * row.
 */
#include "solve/portfolio/polygon.h"

#include "hull/shadow/shadow.h"

typedef struct polygon {
    fmb_query *q;
    const fmb_part *p;
    fmb_lp *lp;
    const int *place;
    fmb_system *out;
    int column[2]; /* of the part */
    int axes;
    fmb_vec row; /* scratch: an edge */
} polygon;

/* den(bound) (normal.x - bound) <= 0 in integers, as a row of the part; z[n + 1] comes in 0. */
static fmb_status write_edge_row(polygon *g, const fmb_edge *e, mpz_t *z)
{
    size_t n = (size_t)g->p->n;
    for (int k = 0; k < g->axes; k++)
        mpz_mul(z[g->column[k]], e->normal[k], mpq_denref(e->bound));
    mpz_set(z[n], mpq_numref(e->bound));
    return fmb_vec_set_z(&g->row, n + 1, z, g->q->run.mem);
}

static fmb_status put_out_edge(polygon *g, fmb_edge *e, mpz_t *z)
{
    mpq_t factor; /* of the row, over what the weights prove */
    fmb_status st = write_edge_row(g, e, z);
    mpq_init(factor);
    mpq_set_z(factor, mpq_denref(e->bound));
    for (size_t i = 0; i < e->w.size; i++)
        mpq_mul(e->w.value[i], e->w.value[i], factor);
    mpq_set_ui(factor, 1, 1);
    if (st == FMB_OK && g->q->claims)
        st = fmb_query_claim_implied(g->q, g->p, &g->row, factor, FMB_LE, &e->w, NULL);
    mpq_clear(factor);
    return st == FMB_OK ? fmb_query_append_row(g->q, g->p, &g->row, FMB_LE, g->place, g->out) : st;
}

static fmb_status put_all_edges(polygon *g, const fmb_edges *list)
{
    size_t n = (size_t)g->p->n + 1;
    fmb_mem *mem = g->q->run.mem;
    mpz_t *z = fmb_mem_get(mem, n, sizeof *z);
    g->row.s = fmb_arena_get(&g->q->v->arena, n, sizeof *g->row.s);
    fmb_status st = z && g->row.s ? FMB_OK : fmb_mem_status(mem);
    for (size_t j = 0; z && j < n; j++)
        mpz_init(z[j]);
    for (size_t k = 0; st == FMB_OK && k < list->size; k++)
        st = put_out_edge(g, &list->edge[k], z);
    for (size_t j = 0; z && j < n; j++)
        mpz_clear(z[j]);
    fmb_mem_put(mem, z, n, sizeof *z);
    fmb_vec_clear(&g->row, n, mem);
    return st;
}

static fmb_status put_out_shadow(polygon *g, bool *done)
{
    fmb_edges list = {0};
    fmb_status st = g->axes == 1
                        ? fmb_shadow_interval(g->lp, g->column[0], &list, done)
                        : fmb_shadow_polygon(g->lp, g->column[0], g->column[1], &list, done);
    if (st == FMB_OK && *done)
        st = put_all_edges(g, &list);
    fmb_edges_clear(&list, g->q->run.mem);
    return st;
}

fmb_status fmb_query_polygon_part(fmb_query *q, int part, const int *place, fmb_system *out,
                                  bool *done)
{
    const fmb_part *p = &q->parts.part[part];
    polygon g = {.q = q, .p = p, .place = place, .out = out};
    *done = false;
    for (int j = 0; j < p->n; j++) {
        if (place[p->var[j]] < 0)
            continue;
        if (g.axes == 2)
            return FMB_OK;
        g.column[g.axes++] = j;
    }
    for (size_t i = 0; i < p->m; i++)
        if (p->rel[i] == FMB_LT)
            return FMB_OK;
    if (g.axes == 0)
        return FMB_OK;
    bool feasible;
    fmb_status st = fmb_query_dictionary(q, part, &g.lp, &feasible);
    return st == FMB_OK ? put_out_shadow(&g, done) : st;
}
