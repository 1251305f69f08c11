/* row.c: rows enter the store: base rows, and combinations that survive what is known of them. */
#include "elim/filter.h"
#include "elim/rank.h"
#include "elim/view.h"

/* An empty row at the end of the store, not counted yet. */
static fmb_status open_row(fmb_elim *e, fmb_derived **out)
{
    fmb_status st = fmb_arena_reserve(e->arena, (void **)&e->row, &e->row_capacity, e->rows + 1,
                                      sizeof *e->row);
    if (st != FMB_OK)
        return st;
    if (e->rows >= FMB_NO_ROW)
        return FMB_ERR_MEMORY;
    fmb_derived *r = &e->row[e->rows];
    *r = (fmb_derived){.p = FMB_NO_ROW, .q = FMB_NO_ROW, .col = -1};
    r->v.s = e->spare ? e->spare : fmb_arena_get(e->arena, (size_t)e->n + 1, sizeof *r->v.s);
    if (!r->v.s)
        return fmb_mem_status(e->arena->mem);
    e->spare = NULL;
    *out = r;
    return FMB_OK;
}

/* Forget the row at the end of the store; its memory serves the next one. */
static void give_up(fmb_elim *e, bool keep_history)
{
    fmb_derived *r = &e->row[e->rows];
    fmb_vec_clear(&r->v, (size_t)e->n + 1, e->run->mem);
    e->spare = r->v.s;
    if (!keep_history && r->history)
        e->spare_history = r->history;
}

/* Does the row name no variable? */
static bool is_constant(const fmb_elim *e, const fmb_derived *r)
{
    for (int j = 0; j < e->n; j++)
        if (fmb_vec_sgn(&r->v, (size_t)j) != 0)
            return false;
    return true;
}

/* Is the constant row 0 REL b false? */
static bool is_false(const fmb_elim *e, const fmb_derived *r)
{
    int b = fmb_vec_sgn(&r->v, (size_t)e->n);
    return r->equality ? b != 0 : r->strict ? b <= 0 : b < 0;
}

fmb_status fmb_list_push(fmb_elim *e, fmb_list *list, uint32_t row)
{
    fmb_status st = fmb_arena_reserve(e->arena, (void **)&list->row, &list->capacity,
                                      list->size + 1, sizeof *list->row);
    if (st == FMB_OK)
        list->row[list->size++] = row;
    return st;
}

fmb_status fmb_elim_add(fmb_elim *e, const fmb_vec *v, fmb_rel rel)
{
    fmb_derived *r = NULL;
    size_t n = (size_t)e->n + 1;
    fmb_status st = open_row(e, &r);
    if (st != FMB_OK)
        return st;
    st = fmb_vec_copy(&r->v, v, n, e->run->mem);
    if (st == FMB_OK && e->num.wide_only)
        st = fmb_vec_widen(&r->v, n, e->run->mem);
    r->strict = rel == FMB_LT;
    r->equality = rel == FMB_EQ;
    if (st == FMB_OK && !is_constant(e, r))
        st = fmb_list_push(e, &e->live, (uint32_t)e->rows);
    else if (st == FMB_OK && is_false(e, r))
        e->clash = (uint32_t)e->rows;
    if (st == FMB_OK)
        e->rows++;
    else
        give_up(e, false);
    return st;
}

fmb_status fmb_elim_split(fmb_elim *e, uint32_t i)
{
    fmb_derived *r = NULL;
    size_t n = (size_t)e->n + 1;
    fmb_status st = open_row(e, &r);
    if (st != FMB_OK)
        return st;
    e->row[i].equality = false;
    r->p = i;
    st = fmb_vec_copy(&r->v, &e->row[i].v, n, e->run->mem);
    for (size_t j = 0; st == FMB_OK && j < n; j++) {
        if (r->v.z)
            mpz_neg(r->v.z[j], r->v.z[j]);
        else
            r->v.s[j] = -r->v.s[j];
    }
    if (st == FMB_OK)
        st = fmb_list_push(e, &e->live, (uint32_t)e->rows);
    if (st == FMB_OK)
        e->rows++;
    else
        give_up(e, false);
    return st;
}

/* ---- combinations ---------------------------------------------------------------------------- */

/* The combination of p and q that cancels col, at the end of the store, not counted yet. */
static fmb_status form(fmb_elim *e, uint32_t p, uint32_t q, int col)
{
    fmb_derived *r = NULL;
    fmb_status st = open_row(e, &r);
    if (st != FMB_OK)
        return st;
    const fmb_derived *a = &e->row[p], *b = &e->row[q];
    r->p = p;
    r->q = q;
    r->col = col;
    r->strict = a->strict || b->strict;
    r->equality = a->equality && b->equality;
    st = fmb_vec_cancel(&r->v, &a->v, &b->v, (size_t)e->n + 1, (size_t)col, &e->num);
    if (st == FMB_OK && e->budget > 0 && e->rows >= e->budget) {
        e->over_budget = true;
        st = FMB_LIMIT;
    }
    if (st != FMB_OK)
        give_up(e, false);
    else
        e->run->stats.rows_made++;
    return st;
}

/* The rule that drops the row at the end of the store, or NULL. Rows made by substitution are the
 * base to come: rules wait until it is complete. */
static fmb_status ask_rules(fmb_elim *e, const fmb_rule **by)
{
    *by = NULL;
    if (!e->based || e->row[e->rows].equality)
        return FMB_OK;
    for (int k = 0; k < e->workers; k++) {
        const fmb_rule *rule = e->worker[k].rule;
        if (!rule->drop_row)
            continue;
        fmb_window w;
        fmb_window_open(&w, e, e->row[e->rows].col);
        bool drop = rule->drop_row(e->worker[k].state, &w.view, e->rows);
        fmb_status st = fmb_window_close(&w);
        if (st != FMB_OK)
            return st;
        if (drop) {
            *by = rule;
            fmb_elim_note_drop(e, k, 1);
            return FMB_OK;
        }
    }
    return FMB_OK;
}

/* Tell the watcher of the row at the end of the store. */
static fmb_status tell(fmb_elim *e, const char *dropped_by)
{
    const fmb_derived *r = &e->row[e->rows];
    fmb_row_event row = {.row = e->rows,
                         .parent = {r->p, r->q},
                         .variable = e->run->var_of,
                         .base = e->base,
                         .dropped_by = dropped_by,
                         .history_words = e->words,
                         .column_words = e->columns,
                         .minimal = -1};
    uint64_t *implicit = NULL;
    if (r->history) {
        bool minimal;
        fmb_status st = fmb_elim_minimal(e, r, &minimal);
        implicit = fmb_mem_get(e->run->mem, e->columns, sizeof *implicit);
        if (st != FMB_OK || !implicit)
            return st != FMB_OK ? st : fmb_mem_status(e->run->mem);
        fmb_history_implicit(e, r, implicit);
        row.history = r->history;
        row.effective = r->history + e->words;
        row.implicit = implicit;
        row.minimal = minimal;
    }
    fmb_run_emit(
        e->run,
        (fmb_event){.kind = FMB_EVENT_ROW, .round = e->rounds + 1, .var = r->col, .row = &row});
    fmb_mem_put(e->run->mem, implicit, e->columns, sizeof *implicit);
    return FMB_OK;
}

/* A row that says nothing goes; its history stays where it can cover others. */
static fmb_status silence(fmb_elim *e)
{
    fmb_filter *f = e->filter;
    const uint64_t *history = e->row[e->rows].history;
    fmb_status st = FMB_OK;
    bool stays = f->wants_silent && history;
    e->constants++;
    if (stays)
        st = fmb_arena_reserve(e->arena, (void **)&f->silent, &f->silent_capacity, f->silents + 1,
                               sizeof *f->silent);
    if (stays && st == FMB_OK)
        f->silent[f->silents++] = history;
    give_up(e, stays);
    return st;
}

/* The row at the end of the store becomes alive, ends the elimination, or goes. */
static fmb_status settle(fmb_elim *e)
{
    fmb_derived *r = &e->row[e->rows];
    const fmb_rule *by = NULL;
    bool constant = is_constant(e, r), clash = constant && is_false(e, r);
    fmb_status st = constant ? FMB_OK : ask_rules(e, &by);
    if (st == FMB_OK && e->run->tells_rows)
        st = tell(e, by ? by->name : constant && !clash ? "constant" : NULL);
    if (st != FMB_OK || by) {
        give_up(e, false);
        return st;
    }
    if (clash) {
        e->clash = (uint32_t)e->rows++;
        return FMB_OK;
    }
    if (constant)
        return silence(e);
    st = fmb_list_push(e, &e->next, (uint32_t)e->rows);
    if (st != FMB_OK) {
        give_up(e, false);
        return st;
    }
    e->rows++;
    if (fmb_elim_keeps(e, FMB_STEP_REFUTE) && e->based && fmb_box_refutes(e, r))
        return fmb_elim_refute(e, (uint32_t)e->rows - 1);
    return fmb_run_rows(e->run, e->next.size);
}

fmb_status fmb_elim_combine(fmb_elim *e, uint32_t p, uint32_t q, int col)
{
    fmb_status st = form(e, p, q, col);
    if (st != FMB_OK)
        return st;
    st = fmb_history_join(e, &e->row[e->rows], &e->row[p], &e->row[q]);
    if (st != FMB_OK)
        give_up(e, false);
    else
        st = settle(e);
    return st != FMB_OK ? st : fmb_run_poll(e->run);
}

fmb_status fmb_elim_derive_row(fmb_elim *e, uint32_t p, uint32_t q, int col, uint32_t *out)
{
    fmb_status st = form(e, p, q, col);
    if (st != FMB_OK)
        return st;
    *out = (uint32_t)e->rows++;
    if (is_constant(e, &e->row[*out]) && is_false(e, &e->row[*out]))
        e->clash = *out;
    return FMB_OK;
}
