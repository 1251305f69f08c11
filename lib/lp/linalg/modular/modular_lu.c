/* modular_lu.c: sparse LU factors modulo p; see modular_lu.h. */
#include "lp/linalg/modular/modular_lu.h"

#include <string.h>

#include "lp/linalg/modular/nucleus.h"

/* ---- peeling --------------------------------------------------------------------------------- */

/* Rows and columns of what is left: how many entries each has, and all their numbers xored, which
 * is the last one's number when one is left. */
typedef struct peeling {
    const fmb_sparse *a;
    fmb_modular_lu *f;
    const fmb_prime *q;
    size_t *column_start; /* [n + 1] the rows of each column */
    int *column_rows;
    int *row_count, *column_count;  /* [n] */
    uint32_t *row_xor, *column_xor; /* [n] */
    int *waiting_rows, *waiting_columns;
    size_t rows, columns; /* that wait */
    bool *by_row;         /* [n] by pivot: its row was the one with one entry */
    size_t pivots;
} peeling;

static fmb_status open_peeling(peeling *p, fmb_arena *arena)
{
    size_t n = p->a->n, terms = p->a->start[n];
    p->column_start = fmb_arena_get(arena, n + 2, sizeof *p->column_start);
    p->column_rows = fmb_arena_get(arena, terms, sizeof *p->column_rows);
    p->row_count = fmb_arena_get(arena, n, sizeof *p->row_count);
    p->column_count = fmb_arena_get(arena, n, sizeof *p->column_count);
    p->row_xor = fmb_arena_get(arena, n, sizeof *p->row_xor);
    p->column_xor = fmb_arena_get(arena, n, sizeof *p->column_xor);
    p->waiting_rows = fmb_arena_get(arena, n, sizeof *p->waiting_rows);
    p->waiting_columns = fmb_arena_get(arena, n, sizeof *p->waiting_columns);
    p->by_row = fmb_arena_get(arena, n, sizeof *p->by_row);
    if (!p->column_start || !p->column_rows || !p->row_count || !p->column_count || !p->row_xor ||
        !p->column_xor || !p->waiting_rows || !p->waiting_columns || !p->by_row)
        return fmb_mem_status(arena->mem);
    memset(p->column_count, 0, n * sizeof *p->column_count);
    memset(p->row_xor, 0, n * sizeof *p->row_xor);
    memset(p->column_xor, 0, n * sizeof *p->column_xor);
    memset(p->by_row, 0, n * sizeof *p->by_row);
    return FMB_OK;
}

static void count_entries_to_peel(peeling *p)
{
    const fmb_sparse *a = p->a;
    for (size_t i = 0; i < a->n; i++) {
        p->row_count[i] = (int)(a->start[i + 1] - a->start[i]);
        for (size_t t = a->start[i]; t < a->start[i + 1]; t++) {
            p->column_count[a->index[t]]++;
            p->column_xor[a->index[t]] ^= (uint32_t)i;
            p->row_xor[i] ^= (uint32_t)a->index[t];
        }
    }
    /* start[j + 1] is where column j is filled next, and start[j + 1] at the end */
    p->column_start[0] = p->column_start[1] = 0;
    for (size_t j = 0; j < a->n; j++)
        p->column_start[j + 2] = p->column_start[j + 1] + (size_t)p->column_count[j];
    for (size_t i = 0; i < a->n; i++)
        for (size_t t = a->start[i]; t < a->start[i + 1]; t++)
            p->column_rows[p->column_start[a->index[t] + 1]++] = (int)i;
    for (size_t i = 0; i < a->n; i++) {
        if (p->row_count[i] == 1)
            p->waiting_rows[p->rows++] = (int)i;
        if (p->column_count[i] == 1)
            p->waiting_columns[p->columns++] = (int)i;
    }
}

static void peel_pivot(peeling *p, size_t i, size_t j, bool by_row)
{
    const fmb_sparse *a = p->a;
    for (size_t t = a->start[i]; t < a->start[i + 1]; t++) {
        size_t c = (size_t)a->index[t];
        p->column_xor[c] ^= (uint32_t)i;
        if (--p->column_count[c] == 1)
            p->waiting_columns[p->columns++] = (int)c;
    }
    for (size_t t = p->column_start[j]; t < p->column_start[j + 1]; t++) {
        size_t r = (size_t)p->column_rows[t];
        p->row_xor[r] ^= (uint32_t)j;
        if (--p->row_count[r] == 1)
            p->waiting_rows[p->rows++] = (int)r;
    }
    p->f->row_at[p->pivots] = (int)i;
    p->f->column_at[p->pivots] = (int)j;
    p->f->row_place[i] = p->f->column_place[j] = (int)p->pivots;
    p->by_row[p->pivots++] = by_row;
}

/* An entry that is 0 modulo p is no pivot; where that happens, the row goes to the nucleus. */
static bool is_entry_pivot(const peeling *p, size_t i, size_t j)
{
    size_t t = p->a->start[i];
    while ((size_t)p->a->index[t] != j)
        t++;
    return fmb_sparse_residue(p->a, t, p->q) != 0;
}

/* Columns first: they are free of multipliers. */
static void peel_all_pivots(peeling *p)
{
    while (p->columns > 0 || p->rows > 0) {
        bool by_row = p->columns == 0;
        size_t i, j;
        if (by_row) {
            i = (size_t)p->waiting_rows[--p->rows];
            j = p->row_xor[i];
            if (p->row_count[i] != 1 || p->f->row_place[i] >= 0)
                continue;
        } else {
            j = (size_t)p->waiting_columns[--p->columns];
            i = p->column_xor[j];
            if (p->column_count[j] != 1 || p->f->column_place[j] >= 0)
                continue;
        }
        if (is_entry_pivot(p, i, j))
            peel_pivot(p, i, j, by_row);
    }
}

/* ---- the nucleus ----------------------------------------------------------------------------- */

/* Rows and columns not peeled get numbers there: place[i] = -1 - number until they have a place. */
static fmb_status load_nucleus(const peeling *p, fmb_nucleus *u, fmb_run *run, fmb_arena *arena,
                               int **rows, int **columns)
{
    fmb_modular_lu *f = p->f;
    size_t size = f->n - p->pivots, entries = 0, r = 0, c = 0;
    *rows = fmb_arena_get(arena, size, sizeof(int));
    *columns = fmb_arena_get(arena, size, sizeof(int));
    if (!*rows || !*columns)
        return fmb_mem_status(arena->mem);
    for (size_t i = 0; i < f->n; i++) {
        if (f->row_place[i] < 0) {
            (*rows)[r++] = (int)i;
            entries += (size_t)p->row_count[i];
        }
        if (f->column_place[i] < 0) {
            (*columns)[c] = (int)i;
            f->column_place[i] = -1 - (int)c++;
        }
    }
    fmb_status st = fmb_nucleus_open(u, run, arena, p->q, size, entries);
    for (r = 0; st == FMB_OK && r < size; r++) {
        size_t i = (size_t)(*rows)[r];
        for (size_t t = p->a->start[i]; t < p->a->start[i + 1]; t++) {
            int place = f->column_place[p->a->index[t]];
            uint64_t value = place < 0 ? fmb_sparse_residue(p->a, t, p->q) : 0;
            if (value != 0)
                fmb_nucleus_put(u, (int)r, -1 - place, value);
        }
    }
    return st;
}

static void place_pivot(fmb_modular_lu *f, size_t k, int i, int j)
{
    f->row_at[k] = i;
    f->column_at[k] = j;
    f->row_place[i] = f->column_place[j] = (int)k;
}

/* Places of the nucleus' pivots, and those of rows and columns that are left over. */
static void place_all_pivots(fmb_modular_lu *f, const fmb_nucleus *u, size_t peeled,
                             const int *rows, const int *columns)
{
    size_t k = peeled, left_rows, left_columns;
    for (size_t i = 0; i < f->n; i++)
        if (f->column_place[i] < 0)
            f->column_place[i] = -1;
    for (int s = 0; s < u->sparse.pivots; s++)
        place_pivot(f, k++, rows[u->sparse.row_at[s]], columns[u->sparse.column_at[s]]);
    for (size_t s = 0; s < u->dense.rank; s++)
        place_pivot(f, k++, rows[u->dense.row[s]], columns[u->dense.column[s]]);
    f->rank = left_rows = left_columns = k;
    for (size_t i = 0; f->rank < f->n && i < f->n; i++) {
        if (f->row_place[i] < 0)
            f->row_at[left_rows++] = (int)i;
        if (f->column_place[i] < 0)
            f->column_at[left_columns++] = (int)i;
    }
    for (; k < f->n; k++)
        place_pivot(f, k, f->row_at[k], f->column_at[k]);
}

/* ---- writing the factors --------------------------------------------------------------------- */

static fmb_status put_sweep_term(fmb_sweep *w, fmb_arena *arena, size_t *at, int index,
                                 uint64_t value)
{
    if (value == 0)
        return FMB_OK;
    if (*at >= w->value_room || *at >= w->index_room) {
        fmb_status st = fmb_sweep_reserve(w, arena, *at + 1);
        if (st != FMB_OK)
            return st;
    }
    w->index[*at] = index;
    w->value[(*at)++] = value;
    return FMB_OK;
}

/* Row k of a peeled pivot, or what a row of the nucleus has in peeled columns: entries before the
 * diagonal belong to the lower factor as they are, as the columns there bear their pivots
 * themselves. */
static fmb_status write_given_terms(const peeling *p, fmb_arena *arena, size_t k, size_t *low,
                                    size_t *up)
{
    fmb_modular_lu *f = p->f;
    size_t i = (size_t)f->row_at[k];
    fmb_status st = FMB_OK;
    for (size_t t = p->a->start[i]; st == FMB_OK && t < p->a->start[i + 1]; t++) {
        size_t place = (size_t)f->column_place[p->a->index[t]];
        uint64_t value = fmb_sparse_residue(p->a, t, p->q);
        if (place < k && place < p->pivots)
            st = put_sweep_term(&f->lower, arena, low, (int)place, value);
        else if (k >= p->pivots)
            continue;
        else if (place > k)
            st = put_sweep_term(&f->upper, arena, up, (int)place, value);
        else
            (p->by_row[k] ? &f->lower : &f->upper)->scale[k] = fmb_prime_inverse(p->q, value);
    }
    return st;
}

/* Pivot s of the nucleus, one of its sparse ones. */
static fmb_status write_sparse_upper(fmb_modular_lu *f, fmb_arena *arena, const fmb_nucleus *u,
                                     int s, const int *columns, size_t k, size_t *up)
{
    fmb_status st = FMB_OK;
    int r = u->sparse.row_at[s];
    f->upper.scale[k] = u->sparse.divisor[s].residue;
    for (int t = 1; st == FMB_OK && t < u->sparse.row.size[r]; t++) {
        size_t e = u->sparse.row.start[r] + (size_t)t;
        int place = f->column_place[columns[u->sparse.row.entry[e]]];
        st = put_sweep_term(&f->upper, arena, up, place, u->sparse.row.value[e].residue);
    }
    return st;
}

static fmb_status write_dense_row(fmb_modular_lu *f, fmb_arena *arena, const fmb_nucleus *u,
                                  size_t s, const int *columns, size_t first, size_t *low,
                                  size_t *up)
{
    const fmb_dense_lu *d = &u->dense;
    const uint64_t *row = d->at + s * d->columns;
    fmb_status st = FMB_OK;
    f->upper.scale[first + s] = d->inverse[s];
    for (size_t c = 0; st == FMB_OK && c < s; c++)
        st = put_sweep_term(&f->lower, arena, low, (int)(first + c), row[c]);
    for (size_t c = s + 1; st == FMB_OK && c < d->columns; c++) {
        int place = f->column_place[columns[d->column[c]]];
        st = put_sweep_term(&f->upper, arena, up, place, row[c]);
    }
    return st;
}

static fmb_status write_multipliers(fmb_modular_lu *f, fmb_arena *arena, const fmb_nucleus *u,
                                    int row, size_t first, size_t *low)
{
    fmb_status st = FMB_OK;
    for (int t = u->sparse.last[row]; st == FMB_OK && t >= 0; t = u->sparse.multiplier[t].before)
        st = put_sweep_term(&f->lower, arena, low, (int)first + u->sparse.multiplier[t].pivot,
                            u->sparse.multiplier[t].value.residue);
    return st;
}

static fmb_status write_factors(const peeling *p, fmb_arena *arena, const fmb_nucleus *u,
                                const int *columns)
{
    fmb_modular_lu *f = p->f;
    size_t low = 0, up = 0, dense = p->pivots + (size_t)u->sparse.pivots, terms = p->a->start[f->n];
    fmb_status st = fmb_sweep_open(&f->lower, arena, f->n, terms, false);
    if (st == FMB_OK)
        st = fmb_sweep_open(&f->upper, arena, f->n, terms, true);
    for (size_t k = 0; st == FMB_OK && k < f->n; k++) {
        f->lower.scale[k] = f->upper.scale[k] = 1;
        if (k < f->rank)
            st = write_given_terms(p, arena, k, &low, &up);
        if (st == FMB_OK && k >= p->pivots && k < f->rank) {
            bool sparse = k < dense;
            size_t s = sparse ? k - p->pivots : k - dense;
            int row = sparse ? u->sparse.row_at[s] : u->dense.row[s];
            st = write_multipliers(f, arena, u, row, p->pivots, &low);
            if (st == FMB_OK)
                st = sparse ? write_sparse_upper(f, arena, u, (int)s, columns, k, &up)
                            : write_dense_row(f, arena, u, s, columns, dense, &low, &up);
        }
        f->lower.start[k + 1] = low;
        f->upper.start[k + 1] = up;
    }
    return st;
}

/* See modular_lu.h. */
static void order_turns(const peeling *p)
{
    fmb_modular_lu *f = p->f;
    size_t turns = 0;
    f->is_triangular = p->pivots == f->n;
    for (size_t k = 0; f->is_triangular && k < f->n; k++)
        if (p->by_row[k])
            f->turn[turns++] = (int)k;
    for (size_t k = f->n; f->is_triangular && k-- > 0;)
        if (!p->by_row[k])
            f->turn[turns++] = (int)k;
}

/* ---- the whole ------------------------------------------------------------------------------- */

static fmb_status open_lu(fmb_modular_lu *f, fmb_arena *arena, size_t n)
{
    *f = (fmb_modular_lu){.n = n};
    f->row_at = fmb_arena_get(arena, n, sizeof *f->row_at);
    f->column_at = fmb_arena_get(arena, n, sizeof *f->column_at);
    f->row_place = fmb_arena_get(arena, n, sizeof *f->row_place);
    f->column_place = fmb_arena_get(arena, n, sizeof *f->column_place);
    f->turn = fmb_arena_get(arena, n, sizeof *f->turn);
    if (!f->row_at || !f->column_at || !f->row_place || !f->column_place || !f->turn)
        return fmb_mem_status(arena->mem);
    memset(f->row_place, -1, n * sizeof *f->row_place);
    memset(f->column_place, -1, n * sizeof *f->column_place);
    return FMB_OK;
}

fmb_status fmb_modular_lu_factor(fmb_modular_lu *f, fmb_run *run, fmb_arena *lasting,
                                 fmb_arena *passing, const fmb_sparse *a, const fmb_prime *q)
{
    peeling p = {.a = a, .f = f, .q = q};
    fmb_nucleus u;
    int *rows, *columns;
    fmb_status st = open_lu(f, lasting, a->n);
    if (st == FMB_OK)
        st = open_peeling(&p, passing);
    if (st != FMB_OK)
        return st;
    count_entries_to_peel(&p);
    peel_all_pivots(&p);
    order_turns(&p);
    st = load_nucleus(&p, &u, run, passing, &rows, &columns);
    if (st == FMB_OK)
        st = fmb_nucleus_factor(&u);
    if (st != FMB_OK)
        return st;
    place_all_pivots(f, &u, p.pivots, rows, columns);
    return write_factors(&p, lasting, &u, columns);
}
