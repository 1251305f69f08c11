/* leading_rows.c: see leading_rows.h. */
#include "lp/redundancy/active_set/leading_rows.h"

#include <limits.h>
#include <stdlib.h>

#include "base/arrays.h"
#include "lp/model/column_units.h"

/* The longest entry of each row is made so many bits long. */
#define LEADING_BITS 28

static fmb_status hold_leading_rows(fmb_leading_rows *t, bool get)
{
    size_t m = t->most_rows, n = t->most_columns;
    return FMB_ARRAYS_IN_BLOCK(t->mem, get, FMB_ARRAY(t->column, n),
                               FMB_ARRAY_ZERO(t->shift, n + 1), FMB_ARRAY(t->row, m),
                               FMB_ARRAY(t->v, m), FMB_ARRAY(t->entry, m * (n + 1)));
}

fmb_status fmb_leading_rows_open(fmb_leading_rows *t, fmb_mem *mem, size_t most_columns,
                                 size_t most_rows)
{
    *t = (fmb_leading_rows){
        .mem = mem, .most_columns = most_columns, .most_rows = most_rows, .right = SIZE_MAX};
    return hold_leading_rows(t, true);
}

void fmb_leading_rows_close(fmb_leading_rows *t)
{
    if (t->inside.run)
        fmb_interior_point_clear(&t->inside);
    (void)hold_leading_rows(t, false);
}

static bool is_column_nonzero(size_t j, size_t m, const fmb_lp_row *row)
{
    for (size_t i = 0; i < m; i++)
        if (fmb_vec_entry_bits(row[i].v, j) > 0)
            return true;
    return false;
}

void fmb_leading_rows_list_columns(fmb_leading_rows *t, size_t n, size_t m, const fmb_lp_row *row)
{
    for (size_t j = 0; j < n; j++)
        if (is_column_nonzero(j, m, row))
            t->column[t->n++] = j;
    t->right = n;
}

/* ---- units ----------------------------------------------------------------------------------- */

/* Doubles, and leading bits, tell numbers apart that differ by so many bits, far above their
 * rounding errors. */
#define NEAR_BITS 12

static bool are_all_bits_near(size_t m, const fmb_lp_row *row)
{
    for (size_t i = 0; i < m; i++)
        if (fmb_vec_is_wide(row[i].v) || row[i].v->bits > NEAR_BITS)
            return false;
    return true;
}

/* The length of coefficient k of a row. */
static int bits_of_entry(const fmb_leading_rows *t, const fmb_vec *a, size_t k)
{
    return (int)fmb_vec_entry_bits(a, t->column[k]);
}

/* The length of the longest coefficient of a row in the units of columns; INT_MIN if all are 0. */
static int most_bits_of_coefficients(const fmb_leading_rows *t, const fmb_vec *a)
{
    int most = INT_MIN;
    for (size_t k = 0; k < t->n; k++) {
        int bits = bits_of_entry(t, a, k);
        most = bits > 0 && bits - t->shift[k] > most ? bits - t->shift[k] : most;
    }
    return most;
}

typedef struct listed_rows {
    const fmb_leading_rows *t;
    const fmb_lp_row *row;
} listed_rows;

/* With the right side, so that bounds tell units of their columns. */
static size_t read_lengths(const void *rows, size_t i, int *column, int *bits)
{
    const listed_rows *l = rows;
    const fmb_leading_rows *t = l->t;
    size_t size = 0;
    for (size_t k = 0; k < t->n + (t->right < SIZE_MAX); k++) {
        column[size] = (int)k;
        bits[size] = (int)fmb_vec_entry_bits(l->row[i].v, k < t->n ? t->column[k] : t->right);
        size += bits[size] > 0;
    }
    return size;
}

static int compare_ints(const void *a, const void *b)
{
    int x = *(const int *)a, y = *(const int *)b;
    return (x > y) - (x < y);
}

/* By how many bits right sides are longer than coefficients in their units, the median of the rows
 * with both: some rows may be very far from 0, or very near. more[m]: scratch. */
static int median_bits_of_right_sides(const fmb_leading_rows *t, size_t m, const fmb_lp_row *row,
                                      int *more)
{
    size_t rows = 0;
    for (size_t i = 0; i < m; i++) {
        int left = most_bits_of_coefficients(t, row[i].v);
        int right = (int)fmb_vec_entry_bits(row[i].v, t->right);
        if (right > 0 && left > INT_MIN)
            more[rows++] = right - left;
    }
    qsort(more, rows, sizeof *more, compare_ints);
    return rows > 0 ? more[rows / 2] : 0;
}

fmb_status fmb_leading_rows_choose_units(fmb_leading_rows *t, size_t m, const fmb_lp_row *row)
{
    int *scratch;
    listed_rows l = {t, row};
    if (!are_all_bits_near(m, row))
        FMB_TRY(fmb_column_units(t->mem, NULL, t->n + 1, m, read_lengths, &l, t->shift));
    if (t->right == SIZE_MAX)
        return FMB_OK;
    FMB_TRY(FMB_GET(t->mem, scratch, m));
    t->shift[t->n] = median_bits_of_right_sides(t, m, row, scratch);
    fmb_mem_put(t->mem, scratch, m, sizeof *scratch);
    return FMB_OK;
}

/* ---- rows ------------------------------------------------------------------------------------ */

/* a / 2^down, rounded towards 0; less than 2^62. */
static int64_t leading_bits(const fmb_vec *a, size_t j, int down, mpz_t scratch)
{
    if (!fmb_vec_is_wide(a) && down > -62)
        return down >= 62 ? 0
               : down > 0 ? a->s[j] / ((int64_t)1 << down)
                          : a->s[j] * ((int64_t)1 << -down);
    fmb_vec_get(a, j, scratch);
    if (down > 0)
        mpz_tdiv_q_2exp(scratch, scratch, (mp_bitcnt_t)down);
    else
        mpz_mul_2exp(scratch, scratch, (mp_bitcnt_t)-down);
    return mpz_get_si(scratch);
}

int fmb_leading_rows_bits(const fmb_leading_rows *t, const fmb_vec *a)
{
    int most = most_bits_of_coefficients(t, a);
    if (t->right == SIZE_MAX || fmb_vec_sgn(a, t->right) == 0)
        return most;
    int right = (int)fmb_vec_entry_bits(a, t->right) - t->shift[t->n];
    return right > most ? right : most;
}

void fmb_leading_rows_add(fmb_leading_rows *t, const fmb_vec *a, mpz_t scratch)
{
    int64_t *value = &t->entry[t->m * (t->n + 1)];
    int bits = fmb_leading_rows_bits(t, a), down = bits > INT_MIN ? bits - LEADING_BITS : 0;
    value[t->n] = 0;
    for (size_t k = 0; k <= t->n && (k < t->n || t->right < SIZE_MAX); k++) {
        value[k] = leading_bits(a, k < t->n ? t->column[k] : t->right, down + t->shift[k], scratch);
        t->rough |= down + t->shift[k] > 0;
    }
    t->v[t->m] = (fmb_vec){.s = value, .bits = LEADING_BITS};
    t->row[t->m] = (fmb_lp_row){&t->v[t->m], FMB_LE};
    t->m++;
}

fmb_status fmb_leading_rows_find_inside(fmb_leading_rows *t, fmb_run *run, double patience,
                                        bool *found)
{
    fmb_interior_point *p = &t->inside;
    fmb_status st = FMB_OK;
    *found = false;
    if (!p->run) {
        fmb_run_count(run, t->m * (100 + 8 * t->n));
        FMB_TRY(fmb_interior_point_open(p, run, t->n, t->m, t->row, &t->possible));
        st = t->possible ? fmb_interior_point_find_quickly(p, found) : FMB_OK;
    }
    if (st == FMB_OK && t->possible && !*found && fmb_interior_point_most_work(p) <= patience)
        st = fmb_interior_point_find(p, found);
    p->near = t->rough;
    p->near_right = t->right < SIZE_MAX;
    if (st == FMB_OK && *found && p->near)
        *found = fmb_interior_point_sees_near_rows(p);
    return st;
}
