/* polygon.c: projections on one or two variables by linear programs; see polygon.h.
 *
 * On one variable the projection is an interval: two programs. On two it is a polygon, and the
 * oracle walks around it (lp/walk.h). The multipliers of each end or edge prove its row.
 */
#include "solve/polygon.h"

#include "lp/walk.h"
#include "system/system.h"

typedef struct polygon {
    fmb_query *q;
    const fmb_part *p;
    fmb_lp *lp;
    const int *place;
    fmb_system *out;
    int column[2]; /* of the part */
    int axes;
} polygon;

/* The row den(bound) (normal.x - bound) <= 0 in integers: z[axes] is the right side. */
static void scale(const polygon *g, const fmb_edge *e, mpz_t *z)
{
    for (int k = 0; k < g->axes; k++)
        mpz_mul(z[k], e->normal[k], mpq_denref(e->bound));
    mpz_set(z[g->axes], mpq_numref(e->bound));
    mpz_set_ui(z[g->axes + 1], 1);
}

static fmb_status fill_claim(const polygon *g, const fmb_edge *e, mpz_t *z, fmb_claim *claim)
{
    fmb_status st = FMB_OK;
    mpq_t a;
    mpq_init(a);
    claim->rel = FMB_LE;
    mpq_set_z(claim->value, z[g->axes]);
    for (int k = 0; st == FMB_OK && k < g->axes; k++) {
        mpq_set_z(a, z[k]);
        if (mpq_sgn(a) != 0)
            st = fmb_evidence_push(g->q->evidence, &claim->terms, (size_t)g->p->var[g->column[k]],
                                   a);
    }
    for (size_t i = 0; i < e->w.size; i++) {
        mpq_set_z(a, mpq_denref(e->bound));
        mpq_mul(e->w.value[i], e->w.value[i], a);
    }
    mpq_clear(a);
    return st == FMB_OK ? fmb_query_push(g->q, g->p, &e->w, SIZE_MAX, 1, &claim->multipliers) : st;
}

static fmb_status claim_edge(const polygon *g, const fmb_edge *e, mpz_t *z)
{
    fmb_claim *claim;
    if (!g->q->evidence)
        return FMB_OK;
    fmb_status st = fmb_evidence_claim(g->q->evidence, FMB_CLAIM_IMPLIED, &claim);
    if (st != FMB_OK)
        return st;
    st = fill_claim(g, e, z, claim);
    if (st != FMB_OK)
        fmb_evidence_drop_last(g->q->evidence);
    return st;
}

static fmb_status put_edge(const polygon *g, const fmb_edge *e)
{
    mpz_t z[4];
    int var[2];
    size_t terms = 0;
    mpz_inits(z[0], z[1], z[2], z[3], NULL);
    scale(g, e, z);
    fmb_status st = claim_edge(g, e, z);
    for (int k = 0; k < g->axes; k++) {
        if (mpz_sgn(z[k]) == 0)
            continue;
        var[terms] = g->place[g->p->var[g->column[k]]];
        mpz_swap(z[terms++], z[k]);
    }
    mpz_swap(z[terms], z[g->axes]);
    mpz_set_ui(z[terms + 1], 1);
    if (st == FMB_OK)
        st = fmb_system_append(g->out, terms, var, z, FMB_LE);
    mpz_clears(z[0], z[1], z[2], z[3], NULL);
    return st;
}

/* One more edge in the list: sign x <= sign value, from the optimum at hand. */
static fmb_status add_end(const polygon *g, fmb_edges *list, int sign)
{
    fmb_mem *mem = g->q->run.mem;
    int step;
    fmb_status st = fmb_mem_reserve(mem, (void **)&list->edge, &list->capacity, list->size + 1,
                                    sizeof *list->edge);
    if (st != FMB_OK)
        return st;
    fmb_edge *e = &list->edge[list->size++];
    *e = (fmb_edge){0};
    mpz_init_set_si(e->normal[0], sign);
    mpz_init(e->normal[1]);
    mpq_init(e->bound);
    fmb_lp_value(g->lp, e->bound, &step);
    if (sign < 0)
        mpq_neg(e->bound, e->bound);
    return fmb_lp_optimum(g->lp, sign, &e->w);
}

/* Both ends of the interval; *done false if they are one. */
static fmb_status find_ends(const polygon *g, fmb_edges *list, bool *done)
{
    fmb_status st = FMB_OK;
    for (int sign = 1; st == FMB_OK && sign >= -1; sign -= 2) {
        fmb_lp_end end;
        st = fmb_lp_extreme(g->lp, g->column[0], sign, &end);
        if (st == FMB_OK && end == FMB_LP_OPTIMUM)
            st = add_end(g, list, sign);
    }
    *done = st == FMB_OK;
    if (*done && list->size == 2) {
        mpq_neg(list->edge[1].bound, list->edge[1].bound);
        *done = !mpq_equal(list->edge[0].bound, list->edge[1].bound);
        mpq_neg(list->edge[1].bound, list->edge[1].bound);
    }
    return st;
}

static fmb_status describe(const polygon *g, bool *done)
{
    fmb_edges list = {0};
    fmb_status st = g->axes == 1 ? find_ends(g, &list, done)
                                 : fmb_lp_walk(g->lp, g->column[0], g->column[1], &list, done);
    for (size_t k = 0; st == FMB_OK && *done && k < list.size; k++)
        st = put_edge(g, &list.edge[k]);
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
    fmb_status st = fmb_query_oracle(q, part, &g.lp);
    return st == FMB_OK ? describe(&g, done) : st;
}
