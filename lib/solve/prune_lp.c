/* prune_lp.c: redundancy by linear programs while eliminating; see prune_lp.h.
 *
 * Each row is tested against those still there, so what goes is implied by what stays. Not a rule
 * of histories: the engine re-bases after it. Source: Schrijver 1986.
 */
#include "solve/prune_lp.h"

#include "elim/view.h"
#include "solve/irredundant.h"

typedef struct patience {
    size_t next; /* rows from which on it looks again; 0: it has not looked */
} patience;

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

static fmb_status open_rows(rows *a, const fmb_elim *e)
{
    fmb_mem *mem = e->run->mem;
    *a = (rows){.size = e->live.size};
    a->row = fmb_mem_get(mem, a->size, sizeof *a->row);
    a->rel = fmb_mem_get(mem, a->size, sizeof *a->rel);
    a->fate = fmb_mem_zero(mem, a->size, sizeof *a->fate);
    if (!a->row || !a->rel || !a->fate) {
        fmb_status st = fmb_mem_status(mem);
        close_rows(a, mem);
        return st;
    }
    for (size_t i = 0; i < a->size; i++) {
        const fmb_derived *r = &e->row[e->live.row[i]];
        a->rel[i] = r->equality ? FMB_EQ : r->strict ? FMB_LT : FMB_LE;
        a->row[i] = (fmb_lp_row){&r->v, a->rel[i]};
    }
    return FMB_OK;
}

static fmb_status ask(const fmb_elim *e, rows *a)
{
    fmb_lp lp;
    bool feasible = false;
    fmb_status st = fmb_lp_init(&lp, e->run, e->n, a->size, a->row, e->num.wide_only);
    if (st == FMB_OK)
        st = fmb_lp_feasible(&lp, &feasible);
    if (st == FMB_OK && feasible) /* if not, a rule lied when that was decided */
        st = fmb_redundant(&lp, a->rel, a->fate);
    fmb_lp_clear(&lp);
    return st;
}

static fmb_status end_round(void *state, const fmb_view *w, bool *drop)
{
    patience *p = state;
    rows a;
    size_t marked = 0, size = fmb_view_rows(w);
    if (p->next == 0)
        p->next = 2 * fmb_view_bases(w) + 16;
    if (fmb_view_column(w) >= 0 && size < p->next)
        return FMB_OK;
    fmb_status st = open_rows(&a, w->e);
    if (st != FMB_OK)
        return st;
    st = ask(w->e, &a);
    for (size_t i = 0; i < size; i++) {
        drop[i] = a.fate[i] == FMB_FATE_REDUNDANT;
        marked += drop[i];
    }
    close_rows(&a, w->e->run->mem);
    p->next = 2 * (size - marked) + 16;
    return st;
}

const fmb_rule fmb_rule_lp = {.name = "lp",
                              .source = "Schrijver1986",
                              .flags = FMB_RULE_BREAKS_HISTORY,
                              .state_bytes = sizeof(patience),
                              .end_round = end_round};
