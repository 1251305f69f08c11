/* mark.c: see mark.h.
 *
 * Rows made before the mark stay in the derivation; a round may have divided them by a common
 * divisor, which changes nothing. The array of rows may have moved: the mark's own array still
 * exists, and gets the rows back.
 */
#include "elim/round/mark.h"

#include <string.h>

#include "elim/history/filter.h"

bool fmb_mark_possible(const fmb_elim *e)
{
    for (int k = 0; k < e->workers; k++)
        if (e->worker[k].rule->state_bytes > 0 && e->worker[k].rule->clear)
            return false;
    return true;
}

/* Keep a copy of the bytes there, if there are any. */
static bool keep_copy(fmb_mark *m, fmb_elim *e, void *at, size_t bytes)
{
    if (!at || bytes == 0)
        return true;
    void *copy = fmb_arena_get(e->arena, bytes, 1);
    if (!copy)
        return false;
    m->kept[m->keeps++] = (fmb_kept_copy){at, memcpy(copy, at, bytes), bytes};
    return true;
}

static bool keep_live_histories(fmb_mark *m, fmb_elim *e)
{
    m->history = fmb_arena_get(e->arena, e->live.size, sizeof *m->history);
    for (size_t i = 0; m->history && i < e->live.size; i++)
        m->history[i] = e->row[e->live.row[i]].history;
    return m->history != NULL;
}

fmb_status fmb_mark_set(fmb_mark *m, fmb_elim *e)
{
    const fmb_filter *f = e->filter;
    size_t n = (size_t)e->n;
    m->keeps = 0;
    bool good = keep_copy(m, e, e->live.row, e->live.size * sizeof *e->live.row) &&
                keep_copy(m, e, e->gone, e->var_words * sizeof *e->gone) &&
                keep_copy(m, e, e->box.ended, e->var_words * sizeof *e->box.ended) &&
                keep_copy(m, e, f->silent, f->silents * sizeof *f->silent) &&
                keep_live_histories(m, e);
    for (int side = FMB_LOWER; good && side <= FMB_UPPER; side++)
        good = keep_copy(m, e, e->box.row[side], n * sizeof *e->box.row[side]) &&
               keep_copy(m, e, e->box.end[side], n * sizeof *e->box.end[side]);
    for (int k = 0; good && k < e->workers; k++)
        good = keep_copy(m, e, e->worker[k].state, e->worker[k].rule->state_bytes);
    if (!good)
        return fmb_mem_status(e->arena->mem);
    m->silent = f->silent;
    m->silents = f->silents;
    m->silent_capacity = f->silent_capacity;
    m->then = *e;
    m->place = fmb_arena_tell(e->arena);
    return FMB_OK;
}

/* Remove the rows made since, and copy the others, as they are now, to the mark's array. */
static void forget_newer_rows(const fmb_mark *m, fmb_elim *e)
{
    size_t rows = m->then.rows;
    for (size_t i = rows; i < e->rows; i++)
        fmb_vec_clear(&e->row[i].v, (size_t)e->n + 1, e->run->mem);
    if (e->row != m->then.row && rows > 0)
        memcpy(m->then.row, e->row, rows * sizeof *e->row);
}

void fmb_mark_return(const fmb_mark *m, fmb_elim *e)
{
    fmb_num num = e->num;
    bool over_budget = e->over_budget;
    forget_newer_rows(m, e);
    *e = m->then;
    e->num = num;
    e->over_budget = over_budget;
    for (int k = 0; k < m->keeps; k++)
        memcpy(m->kept[k].at, m->kept[k].copy, m->kept[k].bytes);
    for (size_t i = 0; i < e->live.size; i++)
        e->row[e->live.row[i]].history = m->history[i];
    fmb_filter_new_round(e->filter);
    e->filter->silent = m->silent;
    e->filter->silents = m->silents;
    e->filter->silent_capacity = m->silent_capacity;
    fmb_arena_rewind(e->arena, m->place);
}
