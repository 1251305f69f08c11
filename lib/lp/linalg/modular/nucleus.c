/* nucleus.c: LU factors modulo p by Markowitz's rule; see nucleus.h. */
#include "lp/linalg/modular/nucleus.h"

#include <string.h>

/* ---- lists ----------------------------------------------------------------------------------- */

static fmb_status open_lists(fmb_nucleus_lists *l, fmb_arena *arena, size_t size, size_t entries,
                             bool values)
{
    *l = (fmb_nucleus_lists){0};
    l->start = fmb_arena_get(arena, size, sizeof *l->start);
    l->size = fmb_arena_get(arena, size, sizeof *l->size);
    l->room = fmb_arena_get(arena, size, sizeof *l->room);
    if (!l->start || !l->size || !l->room)
        return fmb_mem_status(arena->mem);
    memset(l->size, 0, size * sizeof *l->size);
    fmb_status st =
        fmb_arena_reserve(arena, (void **)&l->entry, &l->entry_room, 2 * entries, sizeof(int));
    if (st == FMB_OK && values)
        st = fmb_arena_reserve(arena, (void **)&l->value, &l->value_room, 2 * entries,
                               sizeof(uint64_t));
    return st;
}

/* Room for `more` entries at the end of list i: a list that is too short moves to the end. */
static fmb_status reserve_list(fmb_nucleus_lists *l, fmb_arena *arena, int i, int more)
{
    if (l->size[i] + more <= l->room[i])
        return FMB_OK;
    size_t size = (size_t)l->size[i], room = 2 * (size + (size_t)more);
    fmb_status st =
        fmb_arena_reserve(arena, (void **)&l->entry, &l->entry_room, l->used + room, sizeof(int));
    if (st == FMB_OK && l->value)
        st = fmb_arena_reserve(arena, (void **)&l->value, &l->value_room, l->used + room,
                               sizeof(uint64_t));
    if (st != FMB_OK)
        return st;
    memcpy(l->entry + l->used, l->entry + l->start[i], size * sizeof *l->entry);
    if (l->value)
        memcpy(l->value + l->used, l->value + l->start[i], size * sizeof *l->value);
    l->start[i] = l->used;
    l->room[i] = (int)room;
    l->used += room;
    return FMB_OK;
}

static void drop_from_list(fmb_nucleus_lists *l, int i, int entry)
{
    int *e = l->entry + l->start[i], k = 0;
    while (e[k] != entry)
        k++;
    e[k] = e[--l->size[i]];
}

/* ---- buckets --------------------------------------------------------------------------------- */

static fmb_status open_buckets(fmb_buckets *b, fmb_arena *arena, size_t size)
{
    b->head = fmb_arena_get(arena, size + 1, sizeof *b->head);
    b->next = fmb_arena_get(arena, size, sizeof *b->next);
    b->prev = fmb_arena_get(arena, size, sizeof *b->prev);
    if (!b->head || !b->next || !b->prev)
        return fmb_mem_status(arena->mem);
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

fmb_status fmb_nucleus_open(fmb_nucleus *u, fmb_run *run, fmb_arena *arena, const fmb_prime *q,
                            size_t size, size_t entries)
{
    *u = (fmb_nucleus){.run = run, .arena = arena, .q = q, .size = (int)size};
    fmb_status st = open_lists(&u->row, arena, size, entries, true);
    if (st == FMB_OK)
        st = open_lists(&u->column, arena, size, entries, false);
    if (st == FMB_OK)
        st = open_buckets(&u->by_row, arena, size);
    if (st == FMB_OK)
        st = open_buckets(&u->by_column, arena, size);
    if (st != FMB_OK)
        return st;
    u->row_at = fmb_arena_get(arena, size, sizeof *u->row_at);
    u->column_at = fmb_arena_get(arena, size, sizeof *u->column_at);
    u->inverse = fmb_arena_get(arena, size, sizeof *u->inverse);
    u->last = fmb_arena_get(arena, size, sizeof *u->last);
    u->mark = fmb_arena_get(arena, size, sizeof *u->mark);
    u->met = fmb_arena_get(arena, size, sizeof *u->met);
    if (!u->row_at || !u->column_at || !u->inverse || !u->last || !u->mark || !u->met)
        return fmb_mem_status(arena->mem);
    memset(u->last, -1, size * sizeof *u->last);
    memset(u->mark, -1, size * sizeof *u->mark);
    memset(u->met, 0, size * sizeof *u->met);
    return FMB_OK;
}

/* The columns' lists from the rows', and all buckets. */
static void list_columns_of_rows(fmb_nucleus *u)
{
    fmb_nucleus_lists *row = &u->row, *column = &u->column;
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
    int64_t cost; /* entries that can be new */
} choice;

static void try_pivots_of_row(const fmb_nucleus *u, int i, choice *best)
{
    const int *e = u->row.entry + u->row.start[i];
    for (int t = 0; t < u->row.size[i]; t++) {
        int64_t cost = (int64_t)(u->row.size[i] - 1) * (u->column.size[e[t]] - 1);
        if (cost < best->cost)
            *best = (choice){i, e[t], best->tried, cost};
    }
    best->tried++;
}

static void try_pivots_of_column(const fmb_nucleus *u, int j, choice *best)
{
    const int *e = u->column.entry + u->column.start[j];
    for (int t = 0; t < u->column.size[j]; t++) {
        int64_t cost = (int64_t)(u->column.size[j] - 1) * (u->row.size[e[t]] - 1);
        if (cost < best->cost)
            *best = (choice){e[t], j, best->tried, cost};
    }
    best->tried++;
}

/* No line with `count` entries or more can do better than (count - 1)^2. False: nothing is left. */
static bool choose_sparse_pivot(const fmb_nucleus *u, choice *best)
{
    *best = (choice){-1, -1, 0, INT64_MAX};
    for (int count = 1; count <= u->size; count++) {
        int64_t least = (int64_t)(count - 1) * (count - 1);
        if (best->cost <= least)
            return true;
        for (int j = u->by_column.head[count]; j >= 0; j = u->by_column.next[j]) {
            try_pivots_of_column(u, j, best);
            if (best->cost <= least || best->tried >= MOST_LINES_TRIED)
                return true;
        }
        for (int i = u->by_row.head[count]; i >= 0; i = u->by_row.next[i]) {
            try_pivots_of_row(u, i, best);
            if (best->cost <= least || best->tried >= MOST_LINES_TRIED)
                return true;
        }
    }
    return best->row >= 0;
}

/* ---- one pivot ------------------------------------------------------------------------------- */

/* The pivot moves to the front of its row; both leave the active part. */
static void take_pivot_out(fmb_nucleus *u, int r, int c)
{
    fmb_nucleus_lists *row = &u->row, *column = &u->column;
    int *e = row->entry + row->start[r], t = 0;
    uint64_t *v = row->value + row->start[r];
    take_from_bucket(&u->by_row, r, row->size[r]);
    while (e[t] != c)
        t++;
    uint64_t pivot = v[t];
    e[t] = e[0];
    v[t] = v[0];
    e[0] = c;
    v[0] = pivot;
    for (t = 0; t < row->size[r]; t++) {
        take_from_bucket(&u->by_column, e[t], column->size[e[t]]);
        drop_from_list(column, e[t], r);
        u->mark[e[t]] = t;
    }
    u->mark[c] = -1;
    u->row_at[u->pivots] = r;
    u->column_at[u->pivots] = c;
    u->inverse[u->pivots] = fmb_prime_inverse(u->q, pivot);
    u->entries -= (size_t)row->size[r];
    u->active--;
}

static fmb_status note_multiplier(fmb_nucleus *u, int i, uint64_t value)
{
    fmb_status st = fmb_arena_reserve(u->arena, (void **)&u->multiplier, &u->multiplier_room,
                                      u->multipliers + 1, sizeof *u->multiplier);
    if (st != FMB_OK)
        return st;
    u->multiplier[u->multipliers] = (fmb_multiplier){u->last[i], u->pivots, value};
    u->last[i] = (int)u->multipliers++;
    return FMB_OK;
}

/* Take entry t out of row i. */
static void drop_row_entry(fmb_nucleus_lists *row, int i, int t)
{
    int *e = row->entry + row->start[i], end = --row->size[i];
    uint64_t *v = row->value + row->start[i];
    e[t] = e[end];
    v[t] = v[end];
}

/* Row i minus f times the pivot row r, in columns where row i has entries. Returns how many. */
static int combine_common_entries(fmb_nucleus *u, int i, int r, uint64_t f)
{
    fmb_nucleus_lists *row = &u->row;
    const uint64_t *pivot = row->value + row->start[r];
    int *e = row->entry + row->start[i], common = 0;
    uint64_t *v = row->value + row->start[i];
    for (int t = 0; t < row->size[i];) {
        int k = u->mark[e[t]];
        if (k < 0) {
            t++;
            continue;
        }
        u->met[k] = true;
        common++;
        v[t] = fmb_prime_minus(u->q, v[t], fmb_prime_times(u->q, f, pivot[k]));
        if (v[t] != 0) {
            t++;
            continue;
        }
        drop_from_list(&u->column, e[t], i);
        drop_row_entry(row, i, t);
        u->entries--;
    }
    return common;
}

/* The entries of the pivot row that row i lacks. */
static fmb_status append_new_entries(fmb_nucleus *u, int i, int r, uint64_t f, int common)
{
    fmb_nucleus_lists *row = &u->row, *column = &u->column;
    int size = row->size[r], fresh = size - 1 - common;
    fmb_status st = reserve_list(row, u->arena, i, fresh);
    for (int k = 1; st == FMB_OK && k < size; k++) {
        if (u->met[k]) {
            u->met[k] = false;
            continue;
        }
        int j = row->entry[row->start[r] + (size_t)k];
        size_t at = row->start[i] + (size_t)row->size[i]++;
        row->entry[at] = j;
        row->value[at] = fmb_prime_minus(
            u->q, 0, fmb_prime_times(u->q, f, row->value[row->start[r] + (size_t)k]));
        u->entries++;
        st = reserve_list(column, u->arena, j, 1);
        if (st == FMB_OK)
            column->entry[column->start[j] + (size_t)column->size[j]++] = i;
    }
    return st;
}

static fmb_status eliminate_from_row(fmb_nucleus *u, int i, int r, int c)
{
    fmb_nucleus_lists *row = &u->row;
    int t = 0;
    while (row->entry[row->start[i] + (size_t)t] != c)
        t++;
    uint64_t f =
        fmb_prime_times(u->q, row->value[row->start[i] + (size_t)t], u->inverse[u->pivots]);
    take_from_bucket(&u->by_row, i, row->size[i]);
    drop_row_entry(row, i, t);
    u->entries--;
    fmb_status st = note_multiplier(u, i, f);
    if (st == FMB_OK)
        st = append_new_entries(u, i, r, f, combine_common_entries(u, i, r, f));
    put_into_bucket(&u->by_row, i, row->size[i]);
    return st;
}

static fmb_status eliminate_sparse_pivot(fmb_nucleus *u, int r, int c)
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
    u->row_at[u->pivots] = r;
    u->pivots++;
    return st;
}

/* ---- the dense rest -------------------------------------------------------------------------- */

/* mark[j] becomes a place in the dense columns. */
static fmb_status factor_dense_rest(fmb_nucleus *u)
{
    size_t rows = 0, columns = 0, at = 0;
    for (int k = 1; k <= u->size; k++) {
        for (int i = u->by_row.head[k]; i >= 0; i = u->by_row.next[i])
            rows++;
        for (int j = u->by_column.head[k]; j >= 0; j = u->by_column.next[j])
            columns++;
    }
    fmb_dense_lu *d = &u->dense;
    fmb_status st = fmb_dense_lu_open(d, u->arena, rows, columns);
    if (st != FMB_OK)
        return st;
    for (int k = 1; k <= u->size; k++)
        for (int j = u->by_column.head[k]; j >= 0; j = u->by_column.next[j], at++) {
            d->column[at] = j;
            u->mark[j] = (int)at;
        }
    at = 0;
    for (int k = 1; k <= u->size; k++)
        for (int i = u->by_row.head[k]; i >= 0; i = u->by_row.next[i], at++) {
            d->row[at] = i;
            for (int t = 0; t < u->row.size[i]; t++) {
                size_t e = u->row.start[i] + (size_t)t;
                d->at[at * columns + (size_t)u->mark[u->row.entry[e]]] = u->row.value[e];
            }
        }
    return fmb_dense_lu_factor(d, u->run, u->q);
}

/* A dense entry costs about a third of a sparse one. */
static bool is_rest_dense(const fmb_nucleus *u)
{
    return 3 * u->entries >= (size_t)u->active * (size_t)u->active;
}

fmb_status fmb_nucleus_factor(fmb_nucleus *u)
{
    choice next;
    fmb_status st = FMB_OK;
    list_columns_of_rows(u);
    while (st == FMB_OK && !is_rest_dense(u) && choose_sparse_pivot(u, &next)) {
        st = eliminate_sparse_pivot(u, next.row, next.column);
        if (st == FMB_OK)
            st = fmb_run_poll(u->run);
    }
    return st == FMB_OK ? factor_dense_rest(u) : st;
}
