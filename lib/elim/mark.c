/* mark.c: see mark.h.
 *
 * Rows before the mark stay where they are in the derivation; a round may have divided them by a
 * common divisor, which changes nothing. The array of rows may have moved: the mark's own array is
 * still there, and takes back what it held.
 */
#include "elim/mark.h"

#include <string.h>

#include "elim/filter.h"

bool fmb_mark_possible(const fmb_elim *e)
{
    for (int k = 0; k < e->workers; k++)
        if (e->worker[k].rule->state_bytes > 0 && e->worker[k].rule->clear)
            return false;
    return true;
}

/* A copy in the arena, or NULL. */
static void *copy(fmb_elim *e, const void *from, size_t count, size_t size)
{
    void *to = fmb_arena_get(e->arena, count, size);
    if (to && count > 0)
        memcpy(to, from, count * size);
    return to;
}

static bool copy_rules(fmb_mark *m, fmb_elim *e)
{
    for (int k = 0; k < e->workers; k++) {
        const fmb_worker *w = &e->worker[k];
        m->state[k] = NULL;
        if (w->state && !(m->state[k] = copy(e, w->state, w->rule->state_bytes, 1)))
            return false;
    }
    return true;
}

static bool copy_box(fmb_mark *m, fmb_elim *e)
{
    size_t n = (size_t)e->n;
    for (int side = FMB_LOWER; side <= FMB_UPPER; side++) {
        m->box_row[side] = NULL;
        m->box_end[side] = NULL;
        if (!e->box.end[FMB_UPPER]) /* it was never made */
            continue;
        m->box_row[side] = copy(e, e->box.row[side], n, sizeof *m->box_row[side]);
        m->box_end[side] = copy(e, e->box.end[side], n, sizeof *m->box_end[side]);
        if (!m->box_row[side] || !m->box_end[side])
            return false;
    }
    return true;
}

static bool copy_histories(fmb_mark *m, fmb_elim *e)
{
    m->history = fmb_arena_get(e->arena, e->live.size, sizeof *m->history);
    for (size_t i = 0; m->history && i < e->live.size; i++)
        m->history[i] = e->row[e->live.row[i]].history;
    return m->history != NULL;
}

fmb_status fmb_mark_set(fmb_mark *m, fmb_elim *e)
{
    const fmb_filter *f = e->filter;
    m->live = copy(e, e->live.row, e->live.size, sizeof *m->live);
    m->gone = copy(e, e->gone, e->columns, sizeof *m->gone);
    m->silent = copy(e, f->silent, f->silents, sizeof *m->silent);
    if (!m->live || !m->gone || !m->silent || !copy_histories(m, e) || !copy_box(m, e) ||
        !copy_rules(m, e))
        return fmb_mem_status(e->arena->mem);
    m->silent_place = f->silent;
    m->silents = f->silents;
    m->silent_capacity = f->silent_capacity;
    m->then = *e;
    m->place = fmb_arena_tell(e->arena);
    return FMB_OK;
}

static void put_back(void *to, const void *from, size_t count, size_t size)
{
    if (from && count > 0)
        memcpy(to, from, count * size);
}

/* The rows made since go; the others, as they are now, back into the mark's array. */
static void forget_rows(const fmb_mark *m, fmb_elim *e)
{
    size_t rows = m->then.rows;
    for (size_t i = rows; i < e->rows; i++)
        fmb_vec_clear(&e->row[i].v, (size_t)e->n + 1, e->run->mem);
    if (e->row != m->then.row)
        put_back(m->then.row, e->row, rows, sizeof *e->row);
}

static void return_contents(const fmb_mark *m, fmb_elim *e)
{
    size_t n = (size_t)e->n;
    fmb_filter *f = e->filter;
    put_back(e->live.row, m->live, e->live.size, sizeof *m->live);
    for (size_t i = 0; i < e->live.size; i++)
        e->row[e->live.row[i]].history = m->history[i];
    put_back(e->gone, m->gone, e->columns, sizeof *m->gone);
    for (int side = FMB_LOWER; side <= FMB_UPPER; side++) {
        put_back(e->box.row[side], m->box_row[side], n, sizeof *m->box_row[side]);
        put_back(e->box.end[side], m->box_end[side], n, sizeof *m->box_end[side]);
    }
    for (int k = 0; k < e->workers; k++)
        put_back(e->worker[k].state, m->state[k], e->worker[k].rule->state_bytes, 1);
    fmb_filter_new_round(f);
    f->silent = m->silent_place;
    f->silents = m->silents;
    f->silent_capacity = m->silent_capacity;
    put_back(f->silent, m->silent, m->silents, sizeof *m->silent);
}

void fmb_mark_return(const fmb_mark *m, fmb_elim *e)
{
    fmb_num num = e->num;
    bool over_budget = e->over_budget;
    forget_rows(m, e);
    *e = m->then;
    e->num = num;
    e->over_budget = over_budget;
    return_contents(m, e);
    fmb_arena_rewind(e->arena, m->place);
}
