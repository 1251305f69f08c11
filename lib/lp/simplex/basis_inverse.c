/* basis_inverse.c: see basis_inverse.h. */
#include "lp/simplex/basis_inverse.h"

#include <math.h>

#include "base/ways.h"

/* Up to this many columns the inverse is explicit. */
#define FEW_COLUMNS 100
/* Entries below this, relative to the largest, are no pivots. */
#define DEPENDENT 1e-9
/* Exchanges after which errors have accumulated in an inverse. */
#define STALE 100

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_basis_inverse_init(fmb_basis_inverse *c, const fmb_scaled_program *f,
                                  fmb_inverse_kind kind)
{
    size_t n = f->n;
    fmb_mem *mem = f->run->mem;
    bool large = kind == FMB_INVERSE_BY_SIZE ? n > FEW_COLUMNS : kind == FMB_INVERSE_FACTORS;
    bool sparse = large && fmb_way(FMB_WAY_FACTORED);
    *c = (fmb_basis_inverse){.f = f, .n = n, .lu.f = f, .has_inverse = !sparse};
    fmb_way_answered(FMB_WAY_FACTORED, sparse);
    c->member = fmb_mem_get(mem, n, sizeof *c->member);
    c->old = fmb_mem_get(mem, n, sizeof *c->old);
    if (!c->member || !c->old)
        return fmb_mem_status(mem);
    for (size_t r = 0; r < n; r++)
        c->member[r] = FMB_UNIT + r;
    FMB_TRY(fmb_indexed_vector_resize(&c->work, mem, n));
    if (c->has_inverse)
        return fmb_dense_inverse_init(&c->inverse, mem, f->run->kernels, n);
    fmb_status st = fmb_updated_lu_init(&c->lu, f);
    return st == FMB_OK ? fmb_updated_lu_factor(&c->lu, c->member) : st;
}

void fmb_basis_inverse_clear(fmb_basis_inverse *c)
{
    fmb_mem *mem = c->f->run->mem;
    fmb_mem_put(mem, c->member, c->n, sizeof *c->member);
    fmb_mem_put(mem, c->old, c->n, sizeof *c->old);
    fmb_indexed_vector_free(&c->work, mem);
    if (c->has_inverse)
        fmb_dense_inverse_clear(&c->inverse, mem);
    else
        fmb_updated_lu_clear(&c->lu);
}

/* ---- the inverse ----------------------------------------------------------------------------- */

static void write_in_inverse(const fmb_basis_inverse *c, size_t i, fmb_indexed_vector *entry)
{
    int one;
    fmb_terms m = fmb_member_terms(c->f, i, &one);
    fmb_indexed_vector_clear(entry, true);
    for (size_t t = 0; t < m.size; t++)
        fmb_dense_inverse_add_term(&c->inverse, (size_t)m.column[t], m.value[t], entry->at);
}

/* Put member i into the basis unless it depends on others. */
static void span_member(fmb_basis_inverse *c, size_t i, fmb_indexed_vector *entry)
{
    double largest = 0;
    write_in_inverse(c, i, entry);
    for (size_t r = 0; r < c->n; r++)
        largest = fmax(largest, fabs(entry->at[r]));
    size_t r = fmb_dense_inverse_span(&c->inverse, entry->at, DEPENDENT * largest);
    if (r != SIZE_MAX)
        c->member[r] = i;
}

/* ---- either way ------------------------------------------------------------------------------ */

fmb_status fmb_basis_inverse_set(fmb_basis_inverse *c, const size_t *member,
                                 fmb_indexed_vector *entry)
{
    c->pivots = 0;
    memcpy(c->old, member, c->n * sizeof *c->old);
    if (!c->has_inverse) {
        memcpy(c->member, c->old, c->n * sizeof *c->member);
        fmb_status st = fmb_updated_lu_factor(&c->lu, c->member);
        c->failed = st != FMB_OK;
        return st;
    }
    fmb_dense_inverse_restart(&c->inverse, c->n);
    for (size_t r = 0; r < c->n; r++)
        c->member[r] = FMB_UNIT + r;
    for (size_t r = 0; r < c->n; r++) /* these stay at their places */
        if (c->old[r] >= FMB_UNIT)
            c->inverse.is_unit[c->old[r] - FMB_UNIT] = false;
    for (size_t r = 0; r < c->n; r++)
        if (c->old[r] < FMB_UNIT)
            span_member(c, c->old[r], entry);
    return FMB_OK;
}

fmb_status fmb_basis_inverse_replace(fmb_basis_inverse *c, size_t r, size_t i,
                                     const fmb_indexed_vector *entry)
{
    fmb_status st = FMB_OK;
    if (c->has_inverse)
        fmb_dense_inverse_replace(&c->inverse, r, entry->at);
    else
        st = fmb_updated_lu_pivot(&c->lu, r, i, entry->at[r]);
    c->failed = st != FMB_OK;
    c->member[r] = i;
    c->pivots++;
    return st;
}

bool fmb_basis_inverse_is_stale(const fmb_basis_inverse *c)
{
    return c->failed || (c->has_inverse ? c->pivots > STALE : fmb_updated_lu_is_long(&c->lu));
}

void fmb_basis_inverse_write(fmb_basis_inverse *c, size_t i, fmb_indexed_vector *entry)
{
    if (c->has_inverse) {
        write_in_inverse(c, i, entry);
        return;
    }
    int one;
    fmb_terms m = fmb_member_terms(c->f, i, &one);
    for (size_t t = 0; t < m.size; t++)
        fmb_indexed_vector_add(&c->work, (size_t)m.column[t], m.value[t]);
    fmb_updated_lu_solve_transposed(&c->lu, &c->work, entry);
}

/* Load the nonzeros for a solution with the factors. */
static void load_work(fmb_basis_inverse *c, const double *from)
{
    for (size_t k = 0; k < c->n; k++)
        if (from[k] != 0)
            fmb_indexed_vector_add(&c->work, k, from[k]);
}

void fmb_basis_inverse_price(fmb_basis_inverse *c, const double *cost, fmb_indexed_vector *y)
{
    if (!c->has_inverse) {
        load_work(c, cost);
        fmb_updated_lu_solve_transposed(&c->lu, &c->work, y);
        return;
    }
    fmb_indexed_vector_clear(y, true);
    fmb_dense_inverse_write(&c->inverse, cost, y->at);
}

void fmb_basis_inverse_edge(fmb_basis_inverse *c, size_t r, fmb_indexed_vector *edge)
{
    if (!c->has_inverse) {
        fmb_indexed_vector_add(&c->work, r, 1);
        fmb_updated_lu_solve(&c->lu, &c->work, edge);
        return;
    }
    fmb_indexed_vector_clear(edge, true);
    fmb_dense_inverse_edge(&c->inverse, r, edge->at);
}

void fmb_basis_inverse_point(fmb_basis_inverse *c, const double *right, fmb_indexed_vector *x)
{
    if (!c->has_inverse) {
        load_work(c, right);
        fmb_updated_lu_solve(&c->lu, &c->work, x);
        return;
    }
    fmb_indexed_vector_clear(x, true);
    size_t named = 0;
    for (size_t r = 0; r < c->n; r++) /* x is full: its index is free */
        if (right[r] != 0)
            x->index[named++] = (int)r;
    for (size_t j = 0; j < c->n; j++) {
        const double *row = c->inverse.at + j * c->n;
        double sum = 0;
        for (size_t t = 0; t < named; t++)
            sum += row[x->index[t]] * right[x->index[t]];
        x->at[j] = sum;
    }
}
