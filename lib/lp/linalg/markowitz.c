/* markowitz.c: see markowitz.h. */
#include "lp/linalg/markowitz.h"

#include <math.h>
#include <string.h>

/* ---- lists ----------------------------------------------------------------------------------- */

static fmb_status open_strips(fmb_strips *l, fmb_arena *arena, size_t size, size_t entries,
                              bool values)
{
    *l = (fmb_strips){0};
    FMB_TRY(FMB_ARENA_GET(arena, l->start, size));
    FMB_TRY(FMB_ARENA_GET(arena, l->size, size));
    FMB_TRY(FMB_ARENA_GET(arena, l->room, size));
    memset(l->size, 0, size * sizeof *l->size);
    FMB_TRY(FMB_ARENA_RESERVE(arena, &l->entry, &l->entry_room, 2 * entries));
    return values ? FMB_ARENA_RESERVE(arena, &l->value, &l->value_room, 2 * entries) : FMB_OK;
}

/* Make room for `more` entries in list i: a list without room moves to the end of the pool. */
static fmb_status reserve_list(fmb_strips *l, fmb_arena *arena, int i, int more)
{
    if (l->size[i] + more <= l->room[i])
        return FMB_OK;
    size_t size = (size_t)l->size[i], room = 2 * (size + (size_t)more);
    FMB_TRY(FMB_ARENA_RESERVE(arena, &l->entry, &l->entry_room, l->used + room));
    if (l->value)
        FMB_TRY(FMB_ARENA_RESERVE(arena, &l->value, &l->value_room, l->used + room));
    memcpy(l->entry + l->used, l->entry + l->start[i], size * sizeof *l->entry);
    if (l->value)
        memcpy(l->value + l->used, l->value + l->start[i], size * sizeof *l->value);
    l->start[i] = l->used;
    l->room[i] = (int)room;
    l->used += room;
    return FMB_OK;
}

/* The search starts at the end, as buckets return the last of lines of equal length first. */
static void drop_from_list(fmb_strips *l, int i, int entry)
{
    int *e = l->entry + l->start[i], k = --l->size[i], last = e[k];
    while (e[k] != entry)
        k--;
    e[k] = last;
}

/* ---- buckets --------------------------------------------------------------------------------- */

static fmb_status open_buckets(fmb_buckets *b, fmb_arena *arena, size_t size)
{
    FMB_TRY(FMB_ARENA_GET(arena, b->head, size + 1));
    FMB_TRY(FMB_ARENA_GET(arena, b->next, size));
    FMB_TRY(FMB_ARENA_GET(arena, b->prev, size));
    memset(b->head, -1, (size + 1) * sizeof *b->head);
    return FMB_OK;
}

static void put_into_bucket(fmb_buckets *b, int i, int count)
{
    b->next[i] = b->head[count];
    b->prev[i] = -1;
    if (b->head[count] >= 0)
        b->prev[b->head[count]] = i;
    b->head[count] = i;
}

static void take_from_bucket(fmb_buckets *b, int i, int count)
{
    if (b->prev[i] >= 0)
        b->next[b->prev[i]] = b->next[i];
    else
        b->head[count] = b->next[i];
    if (b->next[i] >= 0)
        b->prev[b->next[i]] = b->prev[i];
}

/* ---- opening --------------------------------------------------------------------------------- */

fmb_status fmb_markowitz_open(fmb_markowitz *u, fmb_run *run, fmb_arena *arena,
                              const fmb_markowitz_numbers *kind, const void *self, size_t size,
                              size_t entries)
{
    *u = (fmb_markowitz){.run = run, .arena = arena, .kind = kind, .self = self, .size = (int)size};
    FMB_TRY(open_strips(&u->row, arena, size, entries, true));
    FMB_TRY(open_strips(&u->column, arena, size, entries, false));
    FMB_TRY(open_buckets(&u->by_row, arena, size));
    FMB_TRY(open_buckets(&u->by_column, arena, size));
    FMB_TRY(FMB_ARENA_GET(arena, u->row_at, size));
    FMB_TRY(FMB_ARENA_GET(arena, u->column_at, size));
    FMB_TRY(FMB_ARENA_GET(arena, u->divisor, size));
    FMB_TRY(FMB_ARENA_GET(arena, u->last, size));
    FMB_TRY(FMB_ARENA_GET(arena, u->mark, size));
    FMB_TRY(FMB_ARENA_GET(arena, u->met, size));
    memset(u->last, -1, size * sizeof *u->last);
    memset(u->mark, -1, size * sizeof *u->mark);
    memset(u->met, -1, size * sizeof *u->met);
    return FMB_OK;
}

/* Build the columns' lists from the rows', and all buckets. */
void fmb_markowitz_begin(fmb_markowitz *u)
{
    fmb_strips *row = &u->row, *column = &u->column;
    for (size_t at = 0, i = 0; i < (size_t)u->size; i++) {
        row->start[i] = at;
        row->room[i] = row->size[i];
        at += (size_t)row->size[i];
    }
    for (size_t t = 0; t < row->used; t++)
        column->size[row->entry[t]]++;
    for (int j = 0; j < u->size; j++) {
        column->start[j] = column->used;
        column->room[j] = column->size[j];
        column->used += (size_t)column->size[j];
        put_into_bucket(&u->by_column, j, column->size[j]);
        column->size[j] = 0;
    }
    for (int i = 0; i < u->size; i++) {
        for (int t = 0; t < row->size[i]; t++) {
            int j = row->entry[row->start[i] + (size_t)t];
            column->entry[column->start[j] + (size_t)column->size[j]++] = i;
        }
        put_into_bucket(&u->by_row, i, row->size[i]);
    }
    u->entries = row->used;
    u->active = u->size;
}

/* ---- the next pivot -------------------------------------------------------------------------- */

#define MOST_LINES_TRIED 4

typedef struct choice {
    int row, column, tried;
    int64_t cost; /* bound on new entries */
} choice;

static void try_pivot(const fmb_markowitz *u, int i, int j, choice *best)
{
    int64_t cost = (int64_t)(u->row.size[i] - 1) * (u->column.size[j] - 1);
    if (cost < best->cost)
        *best = (choice){i, j, best->tried, cost};
}

/* Try the pivots of row i. False: the row vanishes. */
static bool try_pivots_of_row(const fmb_markowitz *u, int i, choice *best)
{
    const int *e = u->row.entry + u->row.start[i];
    const fmb_number *v = u->row.value + u->row.start[i];
    double least = u->kind->least_pivot ? u->kind->least_pivot(v, u->row.size[i]) : 0;
    for (int t = 0; t < u->row.size[i] && least < HUGE_VAL; t++)
        if (!u->kind->least_pivot || fabs(v[t].real) >= least)
            try_pivot(u, i, e[t], best);
    best->tried += least < HUGE_VAL;
    return least < HUGE_VAL;
}

static size_t find_in_row(const fmb_markowitz *u, int i, int j)
{
    size_t t = u->row.start[i];
    while (u->row.entry[t] != j)
        t++;
    return t;
}

/* Try the pivots of column j; if numbers may be too small, only entries alone in their columns. */
static void try_pivots_of_column(const fmb_markowitz *u, int j, choice *best)
{
    const int *e = u->column.entry + u->column.start[j];
    bool alone = u->column.size[j] == 1;
    if (u->kind->least_pivot &&
        !(alone && fabs(u->row.value[find_in_row(u, *e, j)].real) > u->kind->least_alone))
        return;
    for (int t = 0; t < u->column.size[j]; t++)
        try_pivot(u, e[t], j, best);
    best->tried++;
}

/* Give up row i: no active row has entries in its columns any more. */
static void give_row_up(fmb_markowitz *u, int i)
{
    const int *e = u->row.entry + u->row.start[i];
    take_from_bucket(&u->by_row, i, u->row.size[i]);
    for (int t = 0; t < u->row.size[i]; t++) {
        take_from_bucket(&u->by_column, e[t], u->column.size[e[t]]);
        drop_from_list(&u->column, e[t], i);
        put_into_bucket(&u->by_column, e[t], u->column.size[e[t]]);
    }
    u->entries -= (size_t)u->row.size[i];
    u->row.size[i] = 0;
}

/* A line with `count` entries or more costs at least (count - 1)^2. False: no pivot is left. */
static bool choose_pivot(fmb_markowitz *u, choice *best)
{
    *best = (choice){-1, -1, 0, INT64_MAX};
    for (int count = 1; count <= u->size; count++) {
        int64_t least = (int64_t)(count - 1) * (count - 1);
        bool all = !u->kind->least_pivot || count == 1;
        if (all && best->cost <= least)
            return true;
        for (int j = u->by_column.head[count]; all && j >= 0; j = u->by_column.next[j]) {
            try_pivots_of_column(u, j, best);
            if (best->cost <= least || best->tried >= MOST_LINES_TRIED)
                return true;
        }
        for (int i = u->by_row.head[count], next; i >= 0; i = next) {
            next = u->by_row.next[i];
            if (!try_pivots_of_row(u, i, best))
                give_row_up(u, i);
            else if (best->cost <= least || best->tried >= MOST_LINES_TRIED)
                return true;
        }
    }
    return best->row >= 0;
}

/* ---- one pivot ------------------------------------------------------------------------------- */

/* Move the pivot to the front of its row; its row and column leave the active part. */
static void take_pivot_out(fmb_markowitz *u, int r, int c)
{
    fmb_strips *row = &u->row, *column = &u->column;
    size_t first = row->start[r], at = find_in_row(u, r, c);
    int *e = row->entry + first;
    fmb_number pivot = row->value[at];
    take_from_bucket(&u->by_row, r, row->size[r]);
    row->entry[at] = *e;
    row->value[at] = row->value[first];
    *e = c;
    row->value[first] = pivot;
    for (int t = 0; t < row->size[r]; t++) {
        take_from_bucket(&u->by_column, e[t], column->size[e[t]]);
        drop_from_list(column, e[t], r);
        u->mark[e[t]] = t;
    }
    u->mark[c] = -1;
    u->row_at[u->pivots] = r;
    u->column_at[u->pivots] = c;
    u->divisor[u->pivots] = u->kind->make_divisor(u->self, pivot);
    u->entries -= (size_t)row->size[r];
    u->active--;
}

static fmb_status note_multiplier(fmb_markowitz *u, int i, fmb_number value)
{
    FMB_TRY(FMB_ARENA_RESERVE(u->arena, &u->multiplier, &u->multiplier_room, u->multipliers + 1));
    u->multiplier[u->multipliers] = (fmb_multiplier){u->last[i], u->pivots, i, value};
    u->last[i] = (int)u->multipliers++;
    return FMB_OK;
}

/* Remove entry t from row i. */
static void drop_row_entry(fmb_markowitz *u, int i, size_t t)
{
    size_t end = u->row.start[i] + (size_t)--u->row.size[i];
    u->row.entry[t] = u->row.entry[end];
    u->row.value[t] = u->row.value[end];
    u->entries--;
}

/* Add the entries of pivot row r that row i lacks, 0 at first; met[k] is where row i has the column
 * of place k of row r. */
static fmb_status meet_pivot_row(fmb_markowitz *u, int i, int r)
{
    fmb_strips *row = &u->row;
    int size = row->size[r], common = 0;
    for (int t = 0; t < row->size[i]; t++) {
        int k = u->mark[row->entry[row->start[i] + (size_t)t]];
        if (k < 0)
            continue;
        u->met[k] = t;
        common++;
    }
    fmb_status st = reserve_list(row, u->arena, i, size - 1 - common);
    for (int k = 1; st == FMB_OK && k < size; k++) {
        if (u->met[k] >= 0)
            continue;
        int j = row->entry[row->start[r] + (size_t)k], t = u->met[k] = row->size[i]++;
        row->entry[row->start[i] + (size_t)t] = j;
        row->value[row->start[i] + (size_t)t].residue = 0;
        u->entries++;
        st = reserve_list(&u->column, u->arena, j, 1);
        if (st == FMB_OK)
            u->column.entry[u->column.start[j] + (size_t)u->column.size[j]++] = i;
    }
    return st;
}

static void drop_zeros_of_row(fmb_markowitz *u, int i)
{
    for (int t = u->row.size[i]; t-- > 0;) {
        size_t at = u->row.start[i] + (size_t)t;
        if (u->row.value[at].residue != 0)
            continue;
        drop_from_list(&u->column, u->row.entry[at], i);
        drop_row_entry(u, i, at);
    }
}

static fmb_status eliminate_from_row(fmb_markowitz *u, int i, int r, int c)
{
    fmb_strips *row = &u->row;
    size_t at = find_in_row(u, i, c);
    fmb_number f = u->kind->divide(u->self, row->value[at], u->divisor[u->pivots]);
    take_from_bucket(&u->by_row, i, row->size[i]);
    drop_row_entry(u, i, at);
    fmb_status st = note_multiplier(u, i, f);
    int others = row->size[r] - 1;
    if (st == FMB_OK && others > 0)
        st = meet_pivot_row(u, i, r);
    if (st == FMB_OK && others > 0 &&
        u->kind->subtract(u->self, row->value + row->start[i], u->met + 1,
                          row->value + row->start[r] + 1, others, f) > 0)
        drop_zeros_of_row(u, i);
    memset(u->met, -1, (size_t)(others + 1) * sizeof *u->met);
    put_into_bucket(&u->by_row, i, row->size[i]);
    return st;
}

static fmb_status eliminate_pivot(fmb_markowitz *u, int r, int c)
{
    take_pivot_out(u, r, c);
    fmb_status st = FMB_OK;
    for (int t = 0; st == FMB_OK && t < u->column.size[c]; t++)
        st = eliminate_from_row(u, u->column.entry[u->column.start[c] + (size_t)t], r, c);
    for (int t = 1; t < u->row.size[r]; t++) {
        int j = u->row.entry[u->row.start[r] + (size_t)t];
        u->mark[j] = -1;
        put_into_bucket(&u->by_column, j, u->column.size[j]);
    }
    u->column.size[c] = -1;
    u->pivots++;
    return st;
}

fmb_status fmb_markowitz_step(fmb_markowitz *u, bool *done)
{
    choice next;
    *done = !choose_pivot(u, &next);
    if (*done)
        return FMB_OK;
    fmb_status st = eliminate_pivot(u, next.row, next.column);
    return st == FMB_OK ? fmb_run_poll(u->run) : st;
}
