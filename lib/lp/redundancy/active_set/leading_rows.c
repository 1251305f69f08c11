/* leading_rows.c: see leading_rows.h. */
#include "lp/redundancy/active_set/leading_rows.h"

#include "base/arrays.h"

/* Entries of more bits are shortened to so many. */
#define LEADING_BITS 28

static fmb_status hold_leading_rows(fmb_leading_rows *t, bool get)
{
    size_t m = t->most_rows, n = t->most_columns;
    return FMB_ARRAYS_IN_BLOCK(t->mem, get, FMB_ARRAY(t->column, n), FMB_ARRAY(t->row, m),
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

static size_t most_bits_of_column(size_t j, size_t m, const fmb_lp_row *row)
{
    size_t most = 0;
    for (size_t i = 0; i < m; i++) {
        size_t bits = fmb_vec_entry_bits(row[i].v, j);
        most = bits > most ? bits : most;
    }
    return most;
}

void fmb_leading_rows_measure(fmb_leading_rows *t, size_t n, size_t m, const fmb_lp_row *row)
{
    size_t left = 0, right = most_bits_of_column(n, m, row);
    for (size_t j = 0; j < n; j++) {
        size_t bits = most_bits_of_column(j, m, row);
        left = bits > left ? bits : left;
        if (bits > 0)
            t->column[t->n++] = j;
    }
    t->right = n;
    t->unit = right > left ? right - left : 0;
}

/* a / 2^down, rounded towards 0. */
static int64_t leading_bits(const fmb_vec *a, size_t j, size_t down, mpz_t scratch)
{
    if (!fmb_vec_is_wide(a))
        return down < 63 ? a->s[j] / ((int64_t)1 << down) : 0;
    mpz_tdiv_q_2exp(scratch, a->z[j], down);
    return mpz_get_si(scratch);
}

size_t fmb_leading_rows_bits(const fmb_leading_rows *t, const fmb_vec *a)
{
    size_t right = t->right < SIZE_MAX ? fmb_vec_entry_bits(a, t->right) : 0;
    size_t bits = right > t->unit ? right - t->unit : 0;
    for (size_t k = 0; k < t->n; k++) {
        size_t mine = fmb_vec_entry_bits(a, t->column[k]);
        bits = mine > bits ? mine : bits;
    }
    return bits;
}

void fmb_leading_rows_add(fmb_leading_rows *t, const fmb_vec *a, mpz_t scratch)
{
    int64_t *value = &t->entry[t->m * (t->n + 1)];
    size_t bits = fmb_leading_rows_bits(t, a), down = bits > LEADING_BITS ? bits - LEADING_BITS : 0;
    for (size_t k = 0; k < t->n; k++)
        value[k] = leading_bits(a, t->column[k], down, scratch);
    value[t->n] = t->right < SIZE_MAX ? leading_bits(a, t->right, down + t->unit, scratch) : 0;
    t->v[t->m] = (fmb_vec){.s = value, .bits = (int)(bits - down)};
    t->row[t->m] = (fmb_lp_row){&t->v[t->m], FMB_LE};
    t->rough |= down + t->unit > 0;
    t->m++;
}

fmb_status fmb_leading_rows_find_inside(fmb_leading_rows *t, fmb_run *run, double patience,
                                        bool *found)
{
    fmb_interior_point *p = &t->inside;
    bool possible;
    *found = false;
    fmb_run_count(run, t->m * (100 + 8 * t->n));
    fmb_status st = fmb_interior_point_open(p, run, t->n, t->m, t->row, &possible);
    if (st == FMB_OK && possible)
        st = fmb_interior_point_find_quickly(p, found);
    if (st == FMB_OK && possible && !*found && fmb_interior_point_most_work(p) <= patience)
        st = fmb_interior_point_find(p, found);
    p->near = t->rough;
    p->near_right = t->right < SIZE_MAX;
    if (st == FMB_OK && *found && p->near)
        *found = fmb_interior_point_sees_near_rows(p);
    return st;
}
