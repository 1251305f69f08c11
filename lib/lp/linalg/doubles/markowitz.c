/* markowitz.c: elimination of a sparse matrix in doubles, filling in little; see updated_lu.h.
 *
 * Columns and rows of one entry are pivots as they are. Else the pivot is an entry, among those of
 * a few of the shortest rows that are not small beside the largest of their row, with the least
 * product of what is left in its row and in its column. Rows hold columns with values, columns hold
 * rows without; both are linked by their lengths.
 */
#include "lp/linalg/doubles/updated_lu.h"

#include <math.h>

/* A pivot is at least this share of the largest in its row. */
#define SHARE_OF_PIVOT 0.1
/* What is less, of rows whose largest was about 1, is rounding error. */
#define VANISHES 1e-11
/* Rows that are looked at for a pivot. */
#define CANDIDATES 4

/* Rows, or columns, linked by length: first[length], -1 at the end. */
typedef struct fmb_by_length {
    int *first; /* [n + 1] */
    int *next, *before;
} fmb_by_length;

/* Entries of a row or a column: [start, start + size) of an array, with room to grow in. */
typedef struct fmb_strip {
    size_t start, size, room;
} fmb_strip;

typedef struct fmb_active {
    fmb_updated_lu *u;
    fmb_mem *mem;
    size_t n;
    fmb_strip *row, *column;    /* [n] */
    fmb_compressed_rows by_row; /* column, value */
    int *by_column;             /* row */
    size_t by_column_size, by_column_room;
    fmb_by_length rows, columns;
    double *pivot_row; /* [n] by column, zero between steps */
    int *seen;         /* [n] by column: the row that had it last, at this step */
} fmb_active;

/* ---- lengths --------------------------------------------------------------------------------- */

static void unlink_by_length(fmb_by_length *l, int k, size_t length)
{
    if (l->before[k] >= 0)
        l->next[l->before[k]] = l->next[k];
    else
        l->first[length] = l->next[k];
    if (l->next[k] >= 0)
        l->before[l->next[k]] = l->before[k];
}

static void link_by_length(fmb_by_length *l, int k, size_t length)
{
    l->before[k] = -1;
    l->next[k] = l->first[length];
    if (l->next[k] >= 0)
        l->before[l->next[k]] = k;
    l->first[length] = k;
}

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status open_lengths(fmb_active *a, fmb_by_length *l)
{
    l->first = fmb_mem_get(a->mem, a->n + 1, sizeof *l->first);
    l->next = fmb_mem_get(a->mem, a->n, sizeof *l->next);
    l->before = fmb_mem_get(a->mem, a->n, sizeof *l->before);
    if (!l->first || !l->next || !l->before)
        return fmb_mem_status(a->mem);
    for (size_t k = 0; k <= a->n; k++)
        l->first[k] = -1;
    return FMB_OK;
}

static void close_lengths(fmb_active *a, fmb_by_length *l)
{
    fmb_mem_put(a->mem, l->first, a->n + 1, sizeof *l->first);
    fmb_mem_put(a->mem, l->next, a->n, sizeof *l->next);
    fmb_mem_put(a->mem, l->before, a->n, sizeof *l->before);
}

static fmb_status open_active(fmb_active *a, fmb_updated_lu *u)
{
    *a = (fmb_active){.u = u, .mem = u->f->run->mem, .n = u->n};
    a->row = fmb_mem_get(a->mem, a->n, sizeof *a->row);
    a->column = fmb_mem_zero(a->mem, a->n, sizeof *a->column);
    a->pivot_row = fmb_mem_zero(a->mem, a->n, sizeof *a->pivot_row);
    a->seen = fmb_mem_get(a->mem, a->n, sizeof *a->seen);
    if (!a->row || !a->column || !a->pivot_row || !a->seen)
        return fmb_mem_status(a->mem);
    fmb_status st = open_lengths(a, &a->rows);
    return st == FMB_OK ? open_lengths(a, &a->columns) : st;
}

static void close_active(fmb_active *a)
{
    close_lengths(a, &a->rows);
    close_lengths(a, &a->columns);
    fmb_mem_put(a->mem, a->row, a->n, sizeof *a->row);
    fmb_mem_put(a->mem, a->column, a->n, sizeof *a->column);
    fmb_mem_put(a->mem, a->pivot_row, a->n, sizeof *a->pivot_row);
    fmb_mem_put(a->mem, a->seen, a->n, sizeof *a->seen);
    fmb_mem_put(a->mem, a->by_row.index, a->by_row.index_room, sizeof *a->by_row.index);
    fmb_mem_put(a->mem, a->by_row.value, a->by_row.value_room, sizeof *a->by_row.value);
    fmb_mem_put(a->mem, a->by_column, a->by_column_room, sizeof *a->by_column);
}

/* ---- loading --------------------------------------------------------------------------------- */

/* The rows of the core, then the columns. */
static fmb_status load_active_rows(fmb_active *a)
{
    const fmb_updated_lu *u = a->u;
    size_t terms = 0;
    int one;
    for (size_t r = 0; r < a->n; r++)
        if (u->singleton[r] < 0)
            terms += fmb_triangles_terms(u->f, u->member[r], &one).size;
    fmb_status st = fmb_compressed_rows_reserve(&a->by_row, a->mem, terms + terms / 2);
    if (st == FMB_OK)
        st = fmb_mem_reserve(a->mem, (void **)&a->by_column, &a->by_column_room, terms + terms / 2,
                             sizeof *a->by_column);
    for (size_t r = 0; st == FMB_OK && r < a->n; r++) {
        fmb_terms m = fmb_triangles_terms(u->f, u->member[r], &one);
        size_t start = a->by_row.size;
        for (size_t k = 0; u->singleton[r] < 0 && k < m.size; k++)
            if (u->singleton_of[m.column[k]] < 0)
                fmb_compressed_rows_push(&a->by_row, (size_t)m.column[k], m.value[k]);
        a->row[r] = (fmb_strip){start, a->by_row.size - start, a->by_row.size - start};
    }
    return st;
}

static void load_active_columns(fmb_active *a)
{
    for (size_t t = 0; t < a->by_row.size; t++)
        a->column[a->by_row.index[t]].room++;
    for (size_t j = 0; j < a->n; j++) {
        a->column[j].start = a->by_column_size;
        a->by_column_size += a->column[j].room;
        a->seen[j] = -1;
    }
    for (size_t r = 0; r < a->n; r++) {
        for (size_t t = a->row[r].start; t < a->row[r].start + a->row[r].size; t++) {
            fmb_strip *c = &a->column[a->by_row.index[t]];
            a->by_column[c->start + c->size++] = (int)r;
        }
        if (a->u->singleton[r] < 0)
            link_by_length(&a->rows, (int)r, a->row[r].size);
    }
    for (size_t j = 0; j < a->n; j++)
        if (a->u->singleton_of[j] < 0)
            link_by_length(&a->columns, (int)j, a->column[j].size);
}

/* ---- entries --------------------------------------------------------------------------------- */

/* Row r leaves column j. */
static void remove_from_column(fmb_active *a, size_t j, int r)
{
    fmb_strip *c = &a->column[j];
    size_t t = c->start;
    while (a->by_column[t] != r)
        t++;
    a->by_column[t] = a->by_column[c->start + --c->size];
}

/* The entry at t leaves row r. */
static void remove_from_row(fmb_active *a, size_t r, size_t t)
{
    size_t last = a->row[r].start + --a->row[r].size;
    a->by_row.index[t] = a->by_row.index[last];
    a->by_row.value[t] = a->by_row.value[last];
}

static size_t find_in_row(const fmb_active *a, size_t r, size_t j)
{
    size_t t = a->row[r].start;
    while (a->by_row.index[t] != (int)j)
        t++;
    return t;
}

/* Room for so many entries more in row r, which moves to the end if there is none. */
static fmb_status widen_active_row(fmb_active *a, size_t r, size_t more)
{
    fmb_strip *row = &a->row[r];
    size_t need = row->size + more;
    if (need <= row->room)
        return FMB_OK;
    fmb_status st = fmb_compressed_rows_reserve(&a->by_row, a->mem, 2 * need);
    if (st != FMB_OK)
        return st;
    size_t to = a->by_row.size;
    memcpy(&a->by_row.index[to], &a->by_row.index[row->start], row->size * sizeof(int));
    memcpy(&a->by_row.value[to], &a->by_row.value[row->start], row->size * sizeof(double));
    *row = (fmb_strip){to, row->size, 2 * need};
    a->by_row.size += 2 * need;
    return FMB_OK;
}

static fmb_status append_to_column(fmb_active *a, size_t j, int r)
{
    fmb_strip *c = &a->column[j];
    if (c->size == c->room) {
        size_t room = 2 * c->size + 2, to = a->by_column_size;
        fmb_status st = fmb_mem_reserve(a->mem, (void **)&a->by_column, &a->by_column_room,
                                        to + room, sizeof *a->by_column);
        if (st != FMB_OK)
            return st;
        memcpy(&a->by_column[to], &a->by_column[c->start], c->size * sizeof(int));
        *c = (fmb_strip){to, c->size, room};
        a->by_column_size += room;
    }
    a->by_column[c->start + c->size++] = r;
    return FMB_OK;
}

/* ---- pivots ---------------------------------------------------------------------------------- */

/* A row whose entries have vanished. */
static void give_row_up(fmb_active *a, int r)
{
    fmb_strip *row = &a->row[r];
    unlink_by_length(&a->rows, r, row->size);
    for (size_t t = row->start; t < row->start + row->size; t++) {
        int j = a->by_row.index[t];
        unlink_by_length(&a->columns, j, a->column[j].size);
        remove_from_column(a, (size_t)j, r);
        link_by_length(&a->columns, j, a->column[j].size);
    }
    row->size = 0;
}

static double find_largest_of_row(const fmb_active *a, int r)
{
    double largest = 0;
    for (size_t t = 0; t < a->row[r].size; t++)
        largest = fmax(largest, fabs(a->by_row.value[a->row[r].start + t]));
    return largest;
}

/* The best entry of row r, if its cost is less than *least. */
static void consider_row(const fmb_active *a, int r, double largest, double *least, int *row,
                         int *column)
{
    const fmb_strip *s = &a->row[r];
    for (size_t t = s->start; t < s->start + s->size; t++) {
        int j = a->by_row.index[t];
        double cost = (double)(s->size - 1) * (double)(a->column[j].size - 1);
        if (cost < *least && fabs(a->by_row.value[t]) >= SHARE_OF_PIVOT * largest) {
            *least = cost;
            *row = r;
            *column = j;
        }
    }
}

/* Row and column of the next pivot; false: there is none. */
static bool find_active_pivot(fmb_active *a, int *row, int *column)
{
    double least = INFINITY;
    int seen = 0;
    for (int j = a->columns.first[1]; j >= 0; j = a->columns.first[1]) {
        int r = a->by_column[a->column[j].start];
        if (fabs(a->by_row.value[find_in_row(a, (size_t)r, (size_t)j)]) > VANISHES) {
            *row = r;
            *column = j;
            return true;
        }
        give_row_up(a, r);
    }
    for (size_t length = 1; length <= a->n && seen < CANDIDATES; length++)
        for (int r = a->rows.first[length], next; r >= 0 && seen < CANDIDATES; r = next) {
            double largest = find_largest_of_row(a, r);
            next = a->rows.next[r];
            if (largest <= VANISHES) {
                give_row_up(a, r);
                continue;
            }
            consider_row(a, r, largest, &least, row, column);
            seen++;
            if (least <= (double)(length - 1) * (double)(length - 1))
                return true;
        }
    return least < INFINITY;
}

/* ---- a step ---------------------------------------------------------------------------------- */

/* The pivot row becomes a row of U, and leaves its columns. */
static fmb_status take_pivot_row(fmb_active *a, int p, int q, size_t step)
{
    fmb_updated_lu *u = a->u;
    const fmb_strip *row = &a->row[p];
    fmb_status st = fmb_compressed_rows_reserve(&u->upper, a->mem, row->size);
    if (st != FMB_OK)
        return st;
    unlink_by_length(&a->rows, p, row->size);
    for (size_t t = row->start; t < row->start + row->size; t++) {
        int j = a->by_row.index[t];
        unlink_by_length(&a->columns, j, a->column[j].size);
        remove_from_column(a, (size_t)j, p);
        if (j == q) {
            u->pivot[step] = a->by_row.value[t];
            continue;
        }
        a->pivot_row[j] = a->by_row.value[t];
        fmb_compressed_rows_push(&u->upper, (size_t)j, a->by_row.value[t]);
    }
    u->place[step] = p;
    u->column[step] = q;
    u->step_of_place[p] = u->step_of_column[q] = (int)step;
    u->upper.start[step + 1] = u->upper.size;
    return FMB_OK;
}

/* Row r less f times the pivot row, of which step's row of U is the rest. */
static fmb_status subtract_pivot_row(fmb_active *a, size_t r, double f, size_t step)
{
    const fmb_compressed_rows *upper = &a->u->upper;
    size_t begin = upper->start[step], end = upper->start[step + 1];
    fmb_status st = widen_active_row(a, r, end - begin);
    if (st != FMB_OK)
        return st;
    fmb_strip *row = &a->row[r];
    for (size_t t = row->start; t < row->start + row->size;) {
        int j = a->by_row.index[t];
        if (a->pivot_row[j] != 0) {
            a->seen[j] = (int)r;
            a->by_row.value[t] -= f * a->pivot_row[j];
            if (fabs(a->by_row.value[t]) <= 1e-3 * VANISHES) {
                remove_from_row(a, r, t);
                remove_from_column(a, (size_t)j, (int)r);
                continue;
            }
        }
        t++;
    }
    for (size_t t = begin; st == FMB_OK && t < end; t++) {
        int j = upper->index[t];
        if (a->seen[j] == (int)r)
            continue;
        a->by_row.index[row->start + row->size] = j;
        a->by_row.value[row->start + row->size++] = -f * upper->value[t];
        st = append_to_column(a, (size_t)j, (int)r);
    }
    return st;
}

static fmb_status eliminate_column(fmb_active *a, int p, int q, size_t step)
{
    fmb_updated_lu *u = a->u;
    fmb_strip *column = &a->column[q];
    fmb_status st = take_pivot_row(a, p, q, step);
    if (st == FMB_OK)
        st = fmb_compressed_rows_reserve(&u->lower, a->mem, column->size);
    for (size_t t = 0; st == FMB_OK && t < column->size; t++) {
        int r = a->by_column[column->start + t];
        size_t at = find_in_row(a, (size_t)r, (size_t)q);
        double f = a->by_row.value[at] / u->pivot[step];
        unlink_by_length(&a->rows, r, a->row[r].size);
        remove_from_row(a, (size_t)r, at);
        fmb_compressed_rows_push(&u->lower, (size_t)r, f);
        st = subtract_pivot_row(a, (size_t)r, f, step);
        link_by_length(&a->rows, r, a->row[r].size);
    }
    for (size_t t = u->upper.start[step]; t < u->upper.start[step + 1]; t++) {
        int j = u->upper.index[t];
        a->pivot_row[j] = 0;
        a->seen[j] = -1;
        link_by_length(&a->columns, j, a->column[j].size);
    }
    u->lower.start[step + 1] = u->lower.size;
    return st;
}

fmb_status fmb_updated_lu_eliminate(fmb_updated_lu *u)
{
    fmb_active a;
    int row = 0, column = 0;
    fmb_status st = open_active(&a, u);
    if (st == FMB_OK)
        st = load_active_rows(&a);
    if (st == FMB_OK)
        load_active_columns(&a);
    u->lower.size = u->upper.size = 0;
    u->lower.start[0] = u->upper.start[0] = 0;
    for (size_t k = 0; k < u->n; k++)
        u->step_of_place[k] = u->step_of_column[k] = -1;
    for (u->steps = 0; st == FMB_OK && find_active_pivot(&a, &row, &column); u->steps++) {
        st = eliminate_column(&a, row, column, u->steps);
        if (st == FMB_OK)
            st = fmb_run_poll(u->f->run);
    }
    close_active(&a);
    return st;
}
