/* basis_inverse.c: see basis_inverse.h. */
#include "lp/simplex/basis_inverse.h"

#include <math.h>

#include "base/ways.h"

/* Up to so many columns there is an inverse. */
#define FEW_COLUMNS 100
/* Less than this times the largest is no pivot. */
#define DEPENDENT 1e-9
/* Exchanges after which errors have gathered in an inverse. */
#define STALE 100

/* ---- life ------------------------------------------------------------------------------------ */

static void invert_units(fmb_basis_inverse *c)
{
    memset(c->inverse, 0, c->n * c->n * sizeof *c->inverse);
    for (size_t r = 0; r < c->n; r++) {
        c->member[r] = FMB_UNIT + r;
        c->inverse[r * c->n + r] = 1;
    }
}

fmb_status fmb_basis_inverse_init(fmb_basis_inverse *c, const fmb_scaled_program *f, bool factors)
{
    size_t n = f->n;
    fmb_mem *mem = f->run->mem;
    bool sparse = (n > FEW_COLUMNS || factors) && fmb_way(FMB_WAY_FACTORED);
    *c = (fmb_basis_inverse){.f = f, .n = n, .lu.f = f, .has_inverse = !sparse};
    fmb_way_answered(FMB_WAY_FACTORED, sparse);
    c->member = fmb_mem_get(mem, n, sizeof *c->member);
    c->old = fmb_mem_get(mem, n, sizeof *c->old);
    if (!c->member || !c->old)
        return fmb_mem_status(mem);
    for (size_t r = 0; r < n; r++)
        c->member[r] = FMB_UNIT + r;
    fmb_status st = fmb_indexed_vector_resize(&c->work, mem, n);
    if (st != FMB_OK)
        return st;
    if (c->has_inverse) {
        c->inverse = fmb_mem_get(mem, n * n, sizeof *c->inverse);
        if (!c->inverse)
            return fmb_mem_status(mem);
        invert_units(c);
        return FMB_OK;
    }
    st = fmb_updated_lu_init(&c->lu, f);
    return st == FMB_OK ? fmb_updated_lu_factor(&c->lu, c->member) : st;
}

void fmb_basis_inverse_clear(fmb_basis_inverse *c)
{
    fmb_mem *mem = c->f->run->mem;
    fmb_mem_put(mem, c->member, c->n, sizeof *c->member);
    fmb_mem_put(mem, c->old, c->n, sizeof *c->old);
    fmb_indexed_vector_free(&c->work, mem);
    if (c->has_inverse)
        fmb_mem_put(mem, c->inverse, c->n * c->n, sizeof *c->inverse);
    else
        fmb_updated_lu_clear(&c->lu);
}

/* ---- the inverse ----------------------------------------------------------------------------- */

/* out = row times the inverse: the sum of its rows. */
static void combine_inverse(const fmb_basis_inverse *c, size_t i, fmb_indexed_vector *entry)
{
    const fmb_scaled_program *f = c->f;
    fmb_indexed_vector_clear(entry, true);
    if (i >= FMB_UNIT) {
        memcpy(entry->at, &c->inverse[(i - FMB_UNIT) * c->n], c->n * sizeof *entry->at);
        return;
    }
    for (size_t t = f->start[i]; t < f->start[i + 1]; t++) {
        size_t j = (size_t)fmb_scaled_program_columns(f, i)[t - f->start[i]];
        f->run->kernels->accumulate(entry->at, &c->inverse[j * c->n], c->n, f->value[t]);
    }
}

static void pivot_inverse(fmb_basis_inverse *c, size_t r, const fmb_indexed_vector *entry)
{
    double pivot = entry->at[r];
    for (size_t k = 0; k < c->n; k++)
        c->work.at[k] = entry->at[k] / pivot;
    for (size_t j = 0; j < c->n; j++) {
        double *row = &c->inverse[j * c->n], f = row[r];
        if (f == 0)
            continue;
        c->f->run->kernels->accumulate(row, c->work.at, c->n, -f);
        row[r] = f / pivot;
    }
}

/* Take in member i in place of the unit vector that it replaces best. */
static void span_member(fmb_basis_inverse *c, size_t i, fmb_indexed_vector *entry)
{
    size_t best = FMB_NOWHERE;
    double most = 0, largest = 0;
    combine_inverse(c, i, entry);
    for (size_t r = 0; r < c->n; r++) {
        double weight = fabs(entry->at[r]);
        largest = fmax(largest, weight);
        if (c->member[r] >= FMB_UNIT && weight > most) {
            most = weight;
            best = r;
        }
    }
    if (best == FMB_NOWHERE || most <= DEPENDENT * largest)
        return;
    pivot_inverse(c, best, entry);
    c->member[best] = i;
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
    invert_units(c);
    for (size_t r = 0; r < c->n; r++)
        if (c->old[r] < FMB_UNIT)
            span_member(c, c->old[r], entry);
    return FMB_OK;
}

fmb_status fmb_basis_inverse_replace(fmb_basis_inverse *c, size_t r, size_t i,
                                     const fmb_indexed_vector *entry,
                                     const fmb_indexed_vector *edge)
{
    fmb_status st = FMB_OK;
    if (c->has_inverse)
        pivot_inverse(c, r, entry);
    else
        st = fmb_updated_lu_pivot(&c->lu, r, i, entry, edge);
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
    const fmb_scaled_program *f = c->f;
    if (c->has_inverse) {
        combine_inverse(c, i, entry);
        return;
    }
    if (i >= FMB_UNIT)
        fmb_indexed_vector_add(&c->work, i - FMB_UNIT, 1);
    for (size_t t = 0; i < FMB_UNIT && t < f->start[i + 1] - f->start[i]; t++)
        fmb_indexed_vector_add(&c->work, (size_t)fmb_scaled_program_columns(f, i)[t],
                               f->value[f->start[i] + t]);
    fmb_updated_lu_solve_transposed(&c->lu, &c->work, entry);
}

/* What is not zero, on its way through the factors. */
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
    for (size_t j = 0; j < c->n; j++)
        if (cost[j] != 0)
            c->f->run->kernels->accumulate(y->at, &c->inverse[j * c->n], c->n, cost[j]);
}

void fmb_basis_inverse_edge(fmb_basis_inverse *c, size_t r, fmb_indexed_vector *edge)
{
    if (!c->has_inverse) {
        fmb_indexed_vector_add(&c->work, r, 1);
        fmb_updated_lu_solve(&c->lu, &c->work, edge);
        return;
    }
    fmb_indexed_vector_clear(edge, true);
    for (size_t j = 0; j < c->n; j++)
        edge->at[j] = c->inverse[j * c->n + r];
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
    for (size_t r = 0; r < c->n; r++)
        named += right[r] != 0;
    if (8 * named <= c->n) /* the inverse is by rows: else columns take longer */
        for (size_t r = 0; r < c->n; r++)
            for (size_t j = 0; j < c->n && right[r] != 0; j++)
                x->at[j] += c->inverse[j * c->n + r] * right[r];
    else
        for (size_t j = 0; j < c->n; j++) {
            double sum = 0;
            for (size_t r = 0; r < c->n; r++)
                sum += c->inverse[j * c->n + r] * right[r];
            x->at[j] = sum;
        }
}
