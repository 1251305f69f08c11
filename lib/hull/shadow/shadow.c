/* shadow.c: the shadow on a line, and lists of edges; see shadow.h. */
#include "hull/shadow/shadow.h"

#include "lp/dictionary/dictionary_read.h"
#include "lp/dictionary/exact_simplex.h"

fmb_status fmb_edges_add(fmb_edges *list, fmb_mem *mem, fmb_edge **out)
{
    fmb_status st = fmb_mem_reserve(mem, (void **)&list->edge, &list->capacity, list->size + 1,
                                    sizeof *list->edge);
    if (st != FMB_OK)
        return st;
    fmb_edge *e = &list->edge[list->size++];
    *e = (fmb_edge){0};
    mpz_inits(e->normal[0], e->normal[1], NULL);
    mpq_init(e->bound);
    *out = e;
    return FMB_OK;
}

void fmb_edges_clear(fmb_edges *list, fmb_mem *mem)
{
    for (size_t k = 0; k < list->size; k++) {
        mpz_clears(list->edge[k].normal[0], list->edge[k].normal[1], NULL);
        mpq_clear(list->edge[k].bound);
        fmb_weights_clear(&list->edge[k].w, mem);
    }
    fmb_mem_put(mem, list->edge, list->capacity, sizeof *list->edge);
    *list = (fmb_edges){0};
}

/* One more edge in the list: sign x <= sign value, from the optimum at hand. */
static fmb_status add_interval_end(fmb_lp *lp, fmb_edges *list, int sign)
{
    int step;
    fmb_edge *e;
    fmb_status st = fmb_edges_add(list, lp->run->mem, &e);
    if (st != FMB_OK)
        return st;
    mpz_set_si(e->normal[0], sign);
    fmb_lp_value(lp, e->bound, &step);
    if (sign < 0)
        mpq_neg(e->bound, e->bound);
    return fmb_lp_optimum(lp, sign, &e->w);
}

fmb_status fmb_shadow_interval(fmb_lp *lp, int i, fmb_edges *out, bool *done)
{
    fmb_status st = FMB_OK;
    *done = false;
    if (lp->any_strict)
        return FMB_OK;
    for (int sign = 1; st == FMB_OK && sign >= -1; sign -= 2) {
        fmb_lp_end end;
        st = fmb_lp_extreme(lp, i, sign, &end);
        if (st == FMB_OK && end == FMB_LP_OPTIMUM)
            st = add_interval_end(lp, out, sign);
    }
    *done = st == FMB_OK;
    if (*done && out->size == 2) {
        mpq_neg(out->edge[1].bound, out->edge[1].bound);
        *done = !mpq_equal(out->edge[0].bound, out->edge[1].bound);
        mpq_neg(out->edge[1].bound, out->edge[1].bound);
    }
    return st;
}
