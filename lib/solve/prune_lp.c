/* prune_lp.c: redundancy by linear programs while eliminating; see prune_lp.h.
 *
 * Each row is tested against those still there, so what goes is implied by what stays. Not a rule
 * of histories: the engine re-bases after it.
 */
#include "solve/prune_lp.h"

#include <assert.h>

#include "solve/irredundant.h"

/* What the oracle needs of the live rows. */
typedef struct rows {
    fmb_lp_row *row;
    fmb_rel *rel;
    fmb_fate *fate;
    size_t size;
} rows;

static void close_rows(rows *a, fmb_mem *mem)
{
    fmb_mem_put(mem, a->row, a->size, sizeof *a->row);
    fmb_mem_put(mem, a->rel, a->size, sizeof *a->rel);
    fmb_mem_put(mem, a->fate, a->size, sizeof *a->fate);
}

static fmb_status open_rows(rows *a, const fmb_view *w, fmb_mem *mem)
{
    *a = (rows){.size = w->rows};
    a->row = fmb_mem_get(mem, w->rows, sizeof *a->row);
    a->rel = fmb_mem_get(mem, w->rows, sizeof *a->rel);
    a->fate = fmb_mem_zero(mem, w->rows, sizeof *a->fate);
    if (!a->row || !a->rel || !a->fate) {
        fmb_status st = fmb_mem_status(mem);
        close_rows(a, mem);
        return st;
    }
    for (size_t i = 0; i < w->rows; i++) {
        const fmb_live *r = &w->row[i];
        a->rel[i] = r->equality ? FMB_EQ : r->strict ? FMB_LT : FMB_LE;
        a->row[i] = (fmb_lp_row){r->v, a->rel[i]};
    }
    return FMB_OK;
}

static fmb_status ask(const fmb_prune_lp *p, int n, rows *a)
{
    fmb_lp lp;
    bool feasible = false;
    fmb_status st = fmb_lp_init(&lp, p->run, n, a->size, a->row, p->wide_only);
    if (st == FMB_OK)
        st = fmb_lp_feasible(&lp, &feasible);
    if (st == FMB_OK) {
        assert(feasible); /* a projection is of something: that was decided first */
        st = fmb_redundant(&lp, a->rel, a->fate);
    }
    fmb_lp_clear(&lp);
    return st;
}

static fmb_status end_round(void *state, const fmb_view *w, fmb_mem *mem, bool *drop,
                            size_t *marked)
{
    fmb_prune_lp *p = state;
    rows a;
    if (w->rows < p->next)
        return FMB_OK;
    fmb_status st = open_rows(&a, w, mem);
    if (st != FMB_OK)
        return st;
    st = ask(p, w->n, &a);
    for (size_t i = 0; i < w->rows; i++) {
        drop[i] = a.fate[i] == FMB_FATE_REDUNDANT;
        *marked += drop[i];
    }
    close_rows(&a, mem);
    p->next = 2 * (w->rows - *marked) + 16;
    return st;
}

fmb_rule fmb_prune_lp_rule(fmb_prune_lp *state)
{
    return (fmb_rule){.name = "lp",
                      .source = "Schrijver1986",
                      .flags = FMB_RULE_BREAKS_HISTORY,
                      .end_round = end_round,
                      .state = state};
}
