/* modular_lu.c: sparse LU factors modulo p; see modular_lu.h. */
#include "lp/linalg/modular/modular_lu.h"

#include <string.h>

#include "lp/linalg/markowitz.h"

/* A matrix being eliminated, with pivots by Markowitz's rule. */
typedef struct elimination {
    fmb_modular_lu *f;
    const fmb_prime *q;
    fmb_markowitz sparse;
} elimination;

/* ---- numbers --------------------------------------------------------------------------------- */

static fmb_number invert_residue(const void *self, fmb_number a)
{
    return (fmb_number){.residue = fmb_prime_inverse(self, a.residue)};
}

static fmb_number divide_residue(const void *self, fmb_number a, fmb_number inverse)
{
    return (fmb_number){.residue = fmb_prime_times(self, a.residue, inverse.residue)};
}

static int subtract_residues(const void *self, fmb_number *v, const int *at,
                             const fmb_number *pivot, int size, fmb_number factor)
{
    int zeros = 0;
    for (int k = 0; k < size; k++) {
        uint64_t *x = &v[at[k]].residue;
        *x = fmb_prime_minus(self, *x, fmb_prime_times(self, factor.residue, pivot[k].residue));
        zeros += *x == 0;
    }
    return zeros;
}

static const fmb_markowitz_numbers residues = {invert_residue, divide_residue, subtract_residues,
                                               NULL, 0};

/* ---- pivots ---------------------------------------------------------------------------------- */

/* *whole: no entry is zero modulo the prime. */
static fmb_status load_residues(elimination *e, fmb_run *run, fmb_arena *arena, const fmb_sparse *a,
                                bool *whole)
{
    fmb_markowitz *u = &e->sparse;
    fmb_status st = fmb_markowitz_open(u, run, arena, &residues, e->q, a->n, a->start[a->n]);
    *whole = true;
    for (size_t i = 0; st == FMB_OK && i < a->n; i++)
        for (size_t t = a->start[i]; t < a->start[i + 1]; t++) {
            uint64_t value = fmb_sparse_residue(a, t, e->q);
            *whole = *whole && value != 0;
            if (value != 0)
                fmb_markowitz_put(u, (int)i, a->index[t], (fmb_number){.residue = value});
        }
    if (st == FMB_OK)
        fmb_markowitz_begin(u);
    return st;
}

/* Is the last pivot alone in its row, or in its column, which then has `multipliers`? Those of rows
 * take turns from the front, those of columns from the back. */
static bool note_turn(fmb_modular_lu *f, const fmb_markowitz *u, size_t multipliers, size_t *rows,
                      size_t *columns)
{
    int k = u->pivots - 1;
    if (u->row.size[u->row_at[k]] == 1)
        f->turn[(*rows)++] = k;
    else if (u->multipliers == multipliers)
        f->turn[--*columns] = k;
    else
        return false;
    return true;
}

static fmb_status take_pivots(elimination *e, bool whole)
{
    fmb_markowitz *u = &e->sparse;
    size_t rows = 0, columns = e->f->n;
    fmb_status st = FMB_OK;
    bool alone = whole;
    for (bool done = false; st == FMB_OK;) {
        size_t multipliers = u->multipliers;
        st = fmb_markowitz_step(u, &done);
        if (done)
            break;
        alone = st == FMB_OK && alone && note_turn(e->f, u, multipliers, &rows, &columns);
    }
    e->f->is_triangular = alone && (size_t)u->pivots == e->f->n;
    return st;
}

static void place_pivot(fmb_modular_lu *f, size_t k, int i, int j)
{
    f->row_at[k] = i;
    f->column_at[k] = j;
    f->row_place[i] = f->column_place[j] = (int)k;
}

/* Place the pivots, and the rows and columns left over. */
static void place_all_pivots(const elimination *e)
{
    fmb_modular_lu *f = e->f;
    size_t k = 0, left_rows, left_columns;
    for (int s = 0; s < e->sparse.pivots; s++)
        place_pivot(f, k++, e->sparse.row_at[s], e->sparse.column_at[s]);
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

static fmb_status write_upper_row(const elimination *e, fmb_arena *arena, size_t k, size_t *up)
{
    fmb_modular_lu *f = e->f;
    const fmb_strips *row = &e->sparse.row;
    fmb_status st = FMB_OK;
    int r = f->row_at[k];
    f->upper.scale[k] = e->sparse.divisor[k].residue;
    for (int t = 1; st == FMB_OK && t < row->size[r]; t++) {
        size_t from = row->start[r] + (size_t)t;
        st = put_sweep_term(&f->upper, arena, up, f->column_place[row->entry[from]],
                            row->value[from].residue);
    }
    return st;
}

static fmb_status write_multipliers(const elimination *e, fmb_arena *arena, size_t k, size_t *low)
{
    const fmb_markowitz *u = &e->sparse;
    for (int t = u->last[e->f->row_at[k]]; t >= 0; t = u->multiplier[t].before)
        FMB_TRY(put_sweep_term(&e->f->lower, arena, low, u->multiplier[t].pivot,
                               u->multiplier[t].value.residue));
    return FMB_OK;
}

static fmb_status write_factors(const elimination *e, fmb_arena *arena, size_t terms)
{
    fmb_modular_lu *f = e->f;
    size_t low = 0, up = 0;
    fmb_status st = fmb_sweep_open(&f->lower, arena, f->n, terms, false);
    FMB_THEN(st, fmb_sweep_open(&f->upper, arena, f->n, terms, true));
    for (size_t k = 0; st == FMB_OK && k < f->n; k++) {
        f->lower.scale[k] = f->upper.scale[k] = 1;
        if (k < f->rank)
            st = write_multipliers(e, arena, k, &low);
        if (st == FMB_OK && k < f->rank)
            st = write_upper_row(e, arena, k, &up);
        f->lower.start[k + 1] = low;
        f->upper.start[k + 1] = up;
    }
    return st;
}

/* ---- the whole ------------------------------------------------------------------------------- */

static fmb_status open_lu(fmb_modular_lu *f, fmb_arena *arena, size_t n)
{
    *f = (fmb_modular_lu){.n = n};
    FMB_TRY(FMB_ARENA_GET(arena, f->row_at, n));
    FMB_TRY(FMB_ARENA_GET(arena, f->column_at, n));
    FMB_TRY(FMB_ARENA_GET(arena, f->row_place, n));
    FMB_TRY(FMB_ARENA_GET(arena, f->column_place, n));
    FMB_TRY(FMB_ARENA_GET(arena, f->turn, n));
    memset(f->row_place, -1, n * sizeof *f->row_place);
    memset(f->column_place, -1, n * sizeof *f->column_place);
    return FMB_OK;
}

fmb_status fmb_modular_lu_factor(fmb_modular_lu *f, fmb_run *run, fmb_arena *lasting,
                                 fmb_arena *passing, const fmb_sparse *a, const fmb_prime *q)
{
    elimination e = {.f = f, .q = q};
    bool whole;
    FMB_TRY(open_lu(f, lasting, a->n));
    FMB_TRY(load_residues(&e, run, passing, a, &whole));
    FMB_TRY(take_pivots(&e, whole));
    place_all_pivots(&e);
    return write_factors(&e, lasting, a->start[a->n]);
}
