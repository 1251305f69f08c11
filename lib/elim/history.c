/* history.c: where a base begins, and what histories say beyond themselves.
 *
 * The history of a row is the set of base rows with a positive multiplier in it, followed in memory
 * by the set of columns effectively eliminated on the way. Both of a combination are the unions of
 * its parents', and the column just cancelled.
 */
#include <string.h>

#include "elim/elim.h"
#include "elim/filter.h"
#include "elim/view.h"

uint64_t *fmb_history_get(fmb_elim *e)
{
    uint64_t *h = e->spare_history;
    e->spare_history = NULL;
    return h ? h : fmb_arena_get(e->arena, e->words + e->columns, sizeof *h);
}

fmb_status fmb_history_join(fmb_elim *e, fmb_derived *r, const fmb_derived *p, const fmb_derived *q)
{
    if (!e->histories || !e->based)
        return FMB_OK;
    r->history = fmb_history_get(e);
    if (!r->history)
        return fmb_mem_status(e->arena->mem);
    size_t size = e->words + e->columns;
    for (size_t i = 0; i < size; i++)
        r->history[i] = p->history[i] | q->history[i];
    r->history[e->words + (size_t)r->col / 64] |= (uint64_t)1 << (r->col % 64);
    return FMB_OK;
}

static void add_columns(const fmb_elim *e, const fmb_derived *r, uint64_t *set)
{
    for (int j = 0; j < e->n; j++)
        if (fmb_vec_sgn(&r->v, (size_t)j) != 0)
            set[j / 64] |= (uint64_t)1 << (j % 64);
}

/* Imbert's I is computed afresh from the base rows: unions of the parents' I are wrong, since a
 * column that vanished by chance can come back. */
void fmb_history_implicit(const fmb_elim *e, const fmb_derived *r, uint64_t *out)
{
    memset(out, 0, e->columns * sizeof *out);
    for (size_t w = 0; w < e->words; w++)
        for (uint64_t left = r->history[w]; left != 0; left &= left - 1)
            add_columns(e, &e->row[e->base[w * 64 + (size_t)__builtin_ctzll(left)]], out);
    for (int j = 0; j < e->n; j++)
        if (fmb_vec_sgn(&r->v, (size_t)j) != 0)
            out[j / 64] &= ~((uint64_t)1 << (j % 64));
    for (size_t w = 0; w < e->columns; w++)
        out[w] &= ~r->history[e->words + w];
}

/* Rules that read no histories may drop base rows before they are base rows. */
static fmb_status drop_rows(fmb_elim *e)
{
    fmb_window w;
    fmb_status st = FMB_OK;
    for (int k = 0; st == FMB_OK && k < e->workers; k++) {
        const fmb_rule *rule = e->worker[k].rule;
        size_t left = 0;
        if (!rule->drop_row || (rule->flags & FMB_RULE_NEEDS_HISTORY))
            continue;
        fmb_window_open(&w, e, -1);
        for (size_t i = 0; i < e->live.size; i++) {
            uint32_t r = e->live.row[i];
            if (e->row[r].equality || !rule->drop_row(e->worker[k].state, &w.view, r))
                e->live.row[left++] = r;
        }
        e->worker[k].dropped += e->live.size - left;
        e->run->stats.rows_dropped += e->live.size - left;
        e->live.size = left;
        st = fmb_window_close(&w);
    }
    return st;
}

static fmb_status number_rows(fmb_elim *e)
{
    e->words = fmb_set_words(e->bases);
    e->spare_history = NULL; /* its size is no longer right */
    for (size_t i = 0; i < e->bases; i++) {
        uint64_t *h = fmb_history_get(e);
        if (!h)
            return fmb_mem_status(e->arena->mem);
        memset(h, 0, (e->words + e->columns) * sizeof *h);
        h[i / 64] = (uint64_t)1 << (i % 64);
        e->row[e->base[i]].history = h;
        fmb_status st = fmb_run_poll(e->run);
        if (st != FMB_OK)
            return st;
    }
    return fmb_box_mark(e);
}

/* Is there a row that the box refutes among the base rows? Then the elimination is over. */
static fmb_status refute_rows(fmb_elim *e)
{
    if (!fmb_elim_keeps(e, FMB_STEP_REFUTE))
        return FMB_OK;
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < e->live.size; i++) {
        if (fmb_box_refutes(e, &e->row[e->live.row[i]]))
            return fmb_elim_refute(e, e->live.row[i]);
        st = fmb_run_poll(e->run);
    }
    return st;
}

fmb_status fmb_elim_start_histories(fmb_elim *e)
{
    fmb_status st = fmb_box_make(e);
    if (st == FMB_OK)
        st = refute_rows(e);
    if (st == FMB_OK && e->clash == FMB_NO_ROW)
        st = drop_rows(e);
    if (st != FMB_OK || e->clash != FMB_NO_ROW)
        return st;
    e->bases = e->live.size;
    e->base = fmb_arena_get(e->arena, e->bases, sizeof *e->base);
    if (!e->base)
        return fmb_mem_status(e->arena->mem);
    memcpy(e->base, e->live.row, e->bases * sizeof *e->base);
    memset(e->gone, 0, e->columns * sizeof *e->gone);
    e->based = true;
    e->since = 0;
    fmb_filter_forget(e->filter);
    if (e->rounds > 0)
        fmb_run_emit(e->run, (fmb_event){.kind = FMB_EVENT_REBASE,
                                         .round = e->rounds,
                                         .var = -1,
                                         .rows_in = e->bases,
                                         .rows_out = e->bases});
    return e->histories ? number_rows(e) : FMB_OK;
}
