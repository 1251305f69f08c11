/* dense_lu.c: LU factors of a dense matrix modulo p; see dense_lu.h. */
#include "lp/linalg/modular/dense_lu.h"

#include <string.h>

fmb_status fmb_dense_lu_open(fmb_dense_lu *d, fmb_arena *arena, size_t rows, size_t columns)
{
    size_t least = rows < columns ? rows : columns;
    *d = (fmb_dense_lu){.rows = rows, .columns = columns};
    d->row = fmb_arena_get(arena, rows, sizeof *d->row);
    d->column = fmb_arena_get(arena, columns, sizeof *d->column);
    d->at = fmb_arena_get(arena, rows * columns, sizeof *d->at);
    d->across = fmb_arena_get(arena, rows * columns, sizeof *d->across);
    d->inverse = fmb_arena_get(arena, least, sizeof *d->inverse);
    if (!d->row || !d->column || !d->at || !d->across || !d->inverse)
        return fmb_mem_status(arena->mem);
    memset(d->at, 0, rows * columns * sizeof *d->at);
    return FMB_OK;
}

static void swap_dense_rows(fmb_dense_lu *d, size_t i, size_t k)
{
    if (i == k)
        return;
    for (size_t j = 0; j < d->columns; j++) {
        uint64_t t = d->at[i * d->columns + j];
        d->at[i * d->columns + j] = d->at[k * d->columns + j];
        d->at[k * d->columns + j] = t;
    }
    int t = d->row[i];
    d->row[i] = d->row[k];
    d->row[k] = t;
}

/* Column k, which is 0 now below its pivots and stays so, gives its place to column j. */
static void set_dense_column_aside(fmb_dense_lu *d, size_t k, size_t j)
{
    for (size_t i = 0; i < d->rows; i++) {
        uint64_t t = d->at[i * d->columns + j];
        d->at[i * d->columns + j] = d->at[i * d->columns + k];
        d->at[i * d->columns + k] = t;
    }
    memcpy(d->across + k * d->rows, d->across + j * d->rows, d->rank * sizeof *d->across);
    int t = d->column[j];
    d->column[j] = d->column[k];
    d->column[k] = t;
}

/* What is left of column k after k pivots; returns a row that has a pivot there, or rows. */
static size_t reduce_dense_column(fmb_dense_lu *d, const fmb_prime *q, size_t k)
{
    size_t pivot = d->rows;
    for (size_t i = k; i < d->rows; i++) {
        uint64_t *row = d->at + i * d->columns;
        row[k] = fmb_prime_minus_dot(q, row[k], row, d->across + k * d->rows, NULL, k);
        if (row[k] != 0 && pivot == d->rows)
            pivot = i;
    }
    return pivot;
}

/* Row k above the diagonal, in columns that may have a pivot, and the multipliers of column k. */
static void finish_dense_pivot(fmb_dense_lu *d, const fmb_prime *q, size_t k, size_t columns)
{
    uint64_t *row = d->at + k * d->columns;
    d->inverse[k] = fmb_prime_inverse(q, row[k]);
    for (size_t i = k + 1; i < d->rows; i++) {
        uint64_t *x = &d->at[i * d->columns + k];
        *x = *x == 0 ? 0 : fmb_prime_times(q, *x, d->inverse[k]);
    }
    for (size_t j = k + 1; j < columns; j++) {
        uint64_t *column = d->across + j * d->rows;
        row[j] = fmb_prime_minus_dot(q, row[j], row, column, NULL, k);
        column[k] = row[j];
    }
}

fmb_status fmb_dense_lu_factor(fmb_dense_lu *d, fmb_run *run, const fmb_prime *q)
{
    size_t columns = d->columns; /* that may have a pivot */
    while (d->rank < columns && d->rank < d->rows) {
        size_t k = d->rank, pivot = reduce_dense_column(d, q, k);
        if (pivot == d->rows) {
            set_dense_column_aside(d, k, --columns);
        } else {
            swap_dense_rows(d, k, pivot);
            finish_dense_pivot(d, q, k, columns);
            d->rank++;
        }
        fmb_run_count(run, (d->rows + d->columns) * (k + 4));
        fmb_status st = fmb_run_poll(run);
        if (st != FMB_OK)
            return st;
    }
    return FMB_OK;
}
