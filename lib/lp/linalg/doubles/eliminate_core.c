/* eliminate_core.c: factors the core of a basis in doubles into triangles; see updated_lu.h.
 *
 * Markowitz's elimination (markowitz.h) on the rows and columns without singletons, numbered in
 * their order. A pivot is not small relative to the largest of its row, which is about 1 at first.
 */
#include "lp/linalg/doubles/updated_lu.h"

#include <math.h>

#include "lp/linalg/markowitz.h"

/* A pivot is at least this share of the largest in its row. */
#define SHARE_OF_PIVOT 0.1
/* In rows whose largest was about 1, smaller numbers are rounding errors. */
#define VANISHES 1e-11
/* Smaller results of a subtraction have cancelled. */
#define CANCELLED 1e-14

/* ---- numbers --------------------------------------------------------------------------------- */

static fmb_number keep_pivot(const void *self, fmb_number pivot)
{
    (void)self;
    return pivot;
}

/* Division, not a product with the reciprocal, so that equal numbers cancel. */
static fmb_number divide_doubles(const void *self, fmb_number a, fmb_number pivot)
{
    (void)self;
    return (fmb_number){.real = a.real / pivot.real};
}

static int subtract_doubles(const void *self, fmb_number *v, const int *at, const fmb_number *pivot,
                            int size, fmb_number factor)
{
    int zeros = 0;
    (void)self;
    for (int k = 0; k < size; k++) {
        double *x = &v[at[k]].real;
        *x -= factor.real * pivot[k].real;
        if (fabs(*x) <= CANCELLED) {
            *x = 0;
            zeros++;
        }
    }
    return zeros;
}

static double find_least_pivot(const fmb_number *v, int size)
{
    double largest = 0;
    for (int k = 0; k < size; k++)
        largest = fmax(largest, fabs(v[k].real));
    return largest > VANISHES ? SHARE_OF_PIVOT * largest : HUGE_VAL;
}

static const fmb_markowitz_numbers doubles = {keep_pivot, divide_doubles, subtract_doubles,
                                              find_least_pivot, VANISHES};

/* ---- the core -------------------------------------------------------------------------------- */

/* Load the rows of the core, numbered consecutively: place[k]; and its columns: column[k]. */
static fmb_status load_core(const fmb_updated_lu *u, fmb_markowitz *m, fmb_arena *arena,
                            const int *place, size_t size, const int *number)
{
    size_t entries = 0;
    int one;
    for (size_t i = 0; i < size; i++)
        entries += fmb_member_terms(u->f, u->member[place[i]], &one).size;
    fmb_status st = fmb_markowitz_open(m, u->f->run, arena, &doubles, NULL, size, entries);
    for (size_t i = 0; st == FMB_OK && i < size; i++) {
        fmb_terms t = fmb_member_terms(u->f, u->member[place[i]], &one);
        for (size_t k = 0; k < t.size; k++)
            if (number[t.column[k]] >= 0)
                fmb_markowitz_put(m, (int)i, number[t.column[k]], (fmb_number){.real = t.value[k]});
    }
    if (st == FMB_OK)
        fmb_markowitz_begin(m);
    return st;
}

/* Write pivots and their rows, then the multipliers, which are sorted by pivot. */
static fmb_status write_core_factors(fmb_updated_lu *u, const fmb_markowitz *m, const int *place,
                                     const int *column)
{
    fmb_mem *mem = u->f->run->mem;
    fmb_compressed_rows *upper = &u->upper.ahead, *lower = &u->lower.ahead;
    size_t entries = 0, at = 0;
    for (int k = 0; k < m->pivots; k++)
        entries += (size_t)m->row.size[m->row_at[k]];
    FMB_TRY(fmb_compressed_rows_reserve(upper, mem, entries));
    FMB_TRY(fmb_compressed_rows_reserve(lower, mem, m->multipliers));
    for (int k = 0; k < m->pivots; k++) {
        int r = m->row_at[k], c = m->column_at[k];
        const int *e = &m->row.entry[m->row.start[r]];
        const fmb_number *v = &m->row.value[m->row.start[r]];
        for (int t = 1; t < m->row.size[r]; t++)
            fmb_compressed_rows_push(upper, (size_t)column[e[t]], v[t].real);
        for (; at < m->multipliers && m->multiplier[at].pivot == k; at++)
            fmb_compressed_rows_push(lower, (size_t)place[m->multiplier[at].row],
                                     m->multiplier[at].value.real);
        fmb_updated_lu_take_slot(u, place[r], column[c], v[0].real);
    }
    return FMB_OK;
}

static fmb_status eliminate_in(fmb_updated_lu *u, fmb_arena *arena)
{
    fmb_markowitz m;
    size_t rows = 0, columns = 0;
    int *place, *column, *number;
    FMB_TRY(FMB_ARENA_GET(arena, place, u->n));
    FMB_TRY(FMB_ARENA_GET(arena, column, u->n));
    FMB_TRY(FMB_ARENA_GET(arena, number, u->n));
    for (size_t k = 0; k < u->n; k++) {
        number[k] = u->singleton_of[k] < 0 ? (int)columns : -1;
        if (number[k] >= 0)
            column[columns++] = (int)k;
        if (u->singleton[k] < 0)
            place[rows++] = (int)k;
    }
    fmb_status st = load_core(u, &m, arena, place, rows, number);
    for (bool done = false; st == FMB_OK && !done;)
        st = fmb_markowitz_step(&m, &done);
    return st == FMB_OK ? write_core_factors(u, &m, place, column) : st;
}

fmb_status fmb_updated_lu_eliminate(fmb_updated_lu *u)
{
    fmb_arena_reset(&u->arena);
    return eliminate_in(u, &u->arena);
}
