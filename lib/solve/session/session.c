/* session.c: the system and its journal; see session_private.h and session_state.h. */
#include "solve/session/session_state.h"

#include <string.h>

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_session_row new_session_row(fmb_session *c)
{
    return (fmb_session_row){.handle = ++*c->handles, .slot = FMB_NO_SLOT};
}

fmb_status fmb_session_new(fmb_mem *mem, const fmb_system *s, fmb_row *handles, fmb_session **out)
{
    fmb_session *c;
    FMB_TRY(FMB_GET_ZERO(mem, c, 1));
    size_t rows = fmb_system_rows(s);
    c->mem = mem;
    c->handles = handles;
    fmb_status st = fmb_system_copy_to(s, &mem->alloc, &c->s);
    FMB_THEN(st, FMB_RESERVE(mem, &c->row, &c->row_room, rows));
    if (st != FMB_OK) {
        fmb_session_free(c);
        return st;
    }
    for (size_t i = 0; i < rows; i++)
        c->row[i] = new_session_row(c);
    *out = c;
    return FMB_OK;
}

void fmb_session_free(fmb_session *c)
{
    if (!c)
        return;
    fmb_session_forget(c);
    for (size_t k = 0; k < c->changes; k++)
        fmb_system_free_row(c->s, &c->journal[k].old);
    fmb_mem_put(c->mem, c->row, c->row_room, sizeof *c->row);
    fmb_mem_put(c->mem, c->journal, c->change_room, sizeof *c->journal);
    fmb_mem_put(c->mem, c->level, c->level_room, sizeof *c->level);
    fmb_system_free(c->s);
    fmb_mem_put(c->mem, c, 1, sizeof *c);
}

const fmb_system *fmb_session_system(const fmb_session *c)
{
    return c->s;
}

/* ---- changes --------------------------------------------------------------------------------- */

fmb_status fmb_session_reserve(fmb_session *c)
{
    FMB_TRY(FMB_RESERVE(c->mem, &c->row, &c->row_room, fmb_system_rows(c->s) + 1));
    if (c->levels > 0)
        FMB_TRY(FMB_RESERVE(c->mem, &c->journal, &c->change_room, c->changes + 1));
    return FMB_OK;
}

/* Append a change to the journal; if no level is open, free what it replaced. */
static void note_change(fmb_session *c, fmb_change change)
{
    if (c->levels > 0)
        c->journal[c->changes++] = change;
    else
        fmb_system_free_row(c->s, &change.old);
}

void fmb_session_note_added(fmb_session *c)
{
    size_t last = fmb_system_rows(c->s) - 1;
    c->row[last] = new_session_row(c);
    note_change(c, (fmb_change){.kind = FMB_CHANGE_ADDED, .row = last});
}

void fmb_session_remove(fmb_session *c, size_t i)
{
    fmb_change change = {.kind = FMB_CHANGE_REMOVED, .row = i, .place = c->row[i]};
    fmb_system_take_row(c->s, i, &change.old);
    memmove(&c->row[i], &c->row[i + 1], (fmb_system_rows(c->s) - i) * sizeof *c->row);
    note_change(c, change);
}

fmb_status fmb_session_set_right(fmb_session *c, size_t i, const mpq_t b)
{
    fmb_change change = {.kind = FMB_CHANGE_RIGHT, .row = i};
    FMB_TRY(fmb_system_change_right(c->s, i, b, &change.old));
    c->row[i].shifted = true;
    note_change(c, change);
    return FMB_OK;
}

fmb_status fmb_session_set_label(fmb_session *c, size_t i, const char *label)
{
    fmb_change change = {.kind = FMB_CHANGE_LABEL, .row = i};
    change.old.label = c->s->row[i].label;
    c->s->row[i].label = NULL;
    fmb_status st = fmb_system_set_label(c->s, i, label);
    if (st == FMB_OK)
        note_change(c, change);
    else
        c->s->row[i].label = change.old.label;
    return st;
}

void fmb_session_note_variable(fmb_session *c)
{
    note_change(c, (fmb_change){.kind = FMB_CHANGE_VARIABLE});
}

/* Finds the row by bisection. */
size_t fmb_session_find(const fmb_session *c, fmb_row handle)
{
    size_t low = 0, high = fmb_system_rows(c->s);
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (c->row[middle].handle < handle)
            low = middle + 1;
        else
            high = middle;
    }
    return low < fmb_system_rows(c->s) && c->row[low].handle == handle ? low : SIZE_MAX;
}

/* ---- levels ---------------------------------------------------------------------------------- */

fmb_status fmb_session_push(fmb_session *c)
{
    FMB_TRY(FMB_RESERVE(c->mem, &c->level, &c->level_room, c->levels + 1));
    c->level[c->levels++] = c->changes;
    return FMB_OK;
}

static void restore_removed_row(fmb_session *c, const fmb_change *change)
{
    size_t i = change->row;
    memmove(&c->row[i + 1], &c->row[i], (fmb_system_rows(c->s) - i) * sizeof *c->row);
    fmb_system_put_row(c->s, i, &change->old);
    c->row[i] = change->place;
}

static void restore_right_side(fmb_session *c, fmb_change *change)
{
    fmb_sysrow *row = &c->s->row[change->row], now = *row;
    *row = change->old;
    row->label = now.label;
    now.label = NULL;
    fmb_system_free_row(c->s, &now);
    c->row[change->row].shifted = true;
}

static void restore_label(fmb_session *c, const fmb_change *change)
{
    fmb_sysrow now = {.label = c->s->row[change->row].label};
    c->s->row[change->row].label = change->old.label;
    fmb_system_free_row(c->s, &now);
}

static void undo_change(fmb_session *c, fmb_change *change)
{
    switch (change->kind) {
    case FMB_CHANGE_ADDED:
        fmb_system_remove(c->s, change->row);
        break;
    case FMB_CHANGE_REMOVED:
        restore_removed_row(c, change);
        break;
    case FMB_CHANGE_RIGHT:
        restore_right_side(c, change);
        break;
    case FMB_CHANGE_LABEL:
        restore_label(c, change);
        break;
    case FMB_CHANGE_VARIABLE:
        fmb_system_drop_last_variable(c->s);
        break;
    }
}

void fmb_session_pop(fmb_session *c)
{
    size_t first = c->level[--c->levels];
    while (c->changes > first)
        undo_change(c, &c->journal[--c->changes]);
}
