/* prune_lp.c: redundancy by linear programs while eliminating; see prune_lp.h.
 *
 * Each row is tested against those still there, so what goes is implied by what stays. Not a rule
 * of histories: the engine re-bases after it.
 */
#include "solve/prune_lp.h"

#include "lp/lp.h"

static fmb_status test_rows(fmb_lp *lp, const fmb_view *w, bool *drop, size_t *marked)
{
    fmb_status st = FMB_OK;
    for (size_t i = w->rows; st == FMB_OK && i-- > 0;) {
        fmb_lp_end end;
        if (w->row[i].equality)
            continue;
        st = fmb_lp_test(lp, i, &end);
        drop[i] = st == FMB_OK && end == FMB_LP_OPTIMUM;
        *marked += drop[i];
        if (st == FMB_OK && !drop[i])
            st = fmb_lp_restore(lp);
    }
    return st;
}

static fmb_status ask(const fmb_prune_lp *p, const fmb_view *w, const fmb_lp_row *rows, bool *drop,
                      size_t *marked)
{
    fmb_lp lp;
    bool feasible = false;
    fmb_status st = fmb_lp_init(&lp, p->run, w->n, w->rows, rows, p->wide_only);
    if (st == FMB_OK)
        st = fmb_lp_feasible(&lp, &feasible);
    if (st == FMB_OK && feasible) /* else the elimination will find the clash itself */
        st = test_rows(&lp, w, drop, marked);
    fmb_lp_clear(&lp);
    return st;
}

static fmb_status end_round(void *state, const fmb_view *w, fmb_mem *mem, bool *drop,
                            size_t *marked)
{
    fmb_prune_lp *p = state;
    if (w->rows < p->next)
        return FMB_OK;
    fmb_lp_row *rows = fmb_mem_get(mem, w->rows, sizeof *rows);
    if (!rows)
        return fmb_mem_status(mem);
    for (size_t i = 0; i < w->rows; i++)
        rows[i] = (fmb_lp_row){w->row[i].v, w->row[i].equality ? FMB_EQ
                                            : w->row[i].strict ? FMB_LT
                                                               : FMB_LE};
    fmb_status st = ask(p, w, rows, drop, marked);
    fmb_mem_put(mem, rows, w->rows, sizeof *rows);
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
