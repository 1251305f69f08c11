/* nucleus.c: LU factors modulo p by Markowitz's rule; see nucleus.h. */
#include "lp/linalg/modular/nucleus.h"

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

fmb_status fmb_nucleus_open(fmb_nucleus *u, fmb_run *run, fmb_arena *arena, const fmb_prime *q,
                            size_t size, size_t entries)
{
    *u = (fmb_nucleus){.q = q};
    return fmb_markowitz_open(&u->sparse, run, arena, &residues, q, size, entries);
}

/* ---- the dense rest -------------------------------------------------------------------------- */

/* mark[j] becomes a place in the dense columns. */
static fmb_status factor_dense_rest(fmb_nucleus *n)
{
    fmb_markowitz *u = &n->sparse;
    size_t rows = 0, columns = 0, at = 0;
    for (int k = 1; k <= u->size; k++) {
        for (int i = u->by_row.head[k]; i >= 0; i = u->by_row.next[i])
            rows++;
        for (int j = u->by_column.head[k]; j >= 0; j = u->by_column.next[j])
            columns++;
    }
    fmb_dense_lu *d = &n->dense;
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
                d->at[at * columns + (size_t)u->mark[u->row.entry[e]]] = u->row.value[e].residue;
            }
        }
    return fmb_dense_lu_factor(d, u->run, n->q);
}

/* A dense entry costs about a third of a sparse one. */
static bool is_rest_dense(const fmb_markowitz *u)
{
    return 3 * u->entries >= (size_t)u->active * (size_t)u->active;
}

fmb_status fmb_nucleus_factor(fmb_nucleus *u)
{
    fmb_status st = FMB_OK;
    fmb_markowitz_begin(&u->sparse);
    for (bool done = false; st == FMB_OK && !done && !is_rest_dense(&u->sparse);)
        st = fmb_markowitz_step(&u->sparse, &done);
    return st == FMB_OK ? factor_dense_rest(u) : st;
}
