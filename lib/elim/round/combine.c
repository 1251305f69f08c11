/* combine.c: a combination of two rows becomes live, ends the elimination, or is dropped. */
#include "elim/history/filter.h"
#include "elim/history/history.h"
#include "elim/round/round.h"
#include "elim/rules/box_rule.h"
#include "elim/rules/prune.h"

/* Emit an event for the row at the end of the store. */
static fmb_status emit_row_event(fmb_elim *e, const char *dropped_by)
{
    const fmb_derived *r = &e->row[e->rows];
    fmb_row_event row = {.row = e->rows,
                         .parent = {r->p, r->q},
                         .variable = e->run->var_of,
                         .base = e->base,
                         .dropped_by = dropped_by,
                         .history_words = e->words,
                         .column_words = e->var_words,
                         .minimal = -1};
    uint64_t *implicit = NULL;
    if (r->history) {
        bool minimal;
        FMB_TRY(fmb_elim_minimal(e, r, &minimal));
        FMB_TRY(FMB_GET(e->run->mem, implicit, e->var_words));
        fmb_history_implicit(e, r, implicit);
        row.history = r->history;
        row.effective = r->history + e->words;
        row.implicit = implicit;
        row.minimal = minimal;
    }
    fmb_run_emit(
        e->run,
        (fmb_event){.kind = FMB_EVENT_ROW, .round = e->rounds + 1, .var = r->var, .row = &row});
    fmb_mem_put(e->run->mem, implicit, e->var_words, sizeof *implicit);
    return FMB_OK;
}

/* Drop a trivial row; its history is kept if it can cover others. */
static fmb_status drop_constant_row(fmb_elim *e)
{
    bool kept;
    fmb_status st = fmb_filter_keep_silent(e, &kept);
    e->constants++;
    fmb_elim_forget_row(e, kept);
    return st;
}

/* Make the row at the end of the store live. */
static fmb_status keep_row(fmb_elim *e)
{
    fmb_status st = fmb_list_push(e, &e->next, (uint32_t)e->rows);
    if (st != FMB_OK) {
        fmb_elim_forget_row(e, false);
        return st;
    }
    uint32_t r = (uint32_t)e->rows++;
    if (fmb_elim_keeps(e, FMB_STEP_REFUTE) && e->based && fmb_box_refutes(e, &e->row[r]))
        return fmb_box_refute(e, r);
    return fmb_run_rows(e->run, e->next.size);
}

static fmb_status check_new_row(fmb_elim *e)
{
    const fmb_derived *r = &e->row[e->rows];
    const fmb_rule *by = NULL;
    bool constant = fmb_elim_is_constant(e, r), clash = constant && fmb_elim_is_false(e, r);
    fmb_status st = constant ? FMB_OK : fmb_rules_drop_row(e, &by);
    if (st == FMB_OK && e->run->tells_rows)
        st = emit_row_event(e, by ? by->name : constant && !clash ? "constant" : NULL);
    if (st != FMB_OK || by) {
        fmb_elim_forget_row(e, false);
        return st;
    }
    if (clash) {
        e->clash = (uint32_t)e->rows++;
        return FMB_OK;
    }
    return constant ? drop_constant_row(e) : keep_row(e);
}

fmb_status fmb_elim_combine(fmb_elim *e, uint32_t p, uint32_t q, int var)
{
    FMB_TRY(fmb_elim_form_row(e, p, q, var));
    bool wide = fmb_vec_is_wide(&e->row[e->rows].v);
    fmb_status st = fmb_history_join(e, &e->row[e->rows], &e->row[p], &e->row[q]);
    if (st != FMB_OK)
        fmb_elim_forget_row(e, false);
    else
        st = check_new_row(e);
    return st != FMB_OK ? st : fmb_run_poll_step(e->run, wide);
}
