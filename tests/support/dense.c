/* dense.c: see dense.h. */
#include "dense.h"

#include "support/must.h"
#include <stdlib.h>

static void *get(size_t count, size_t size)
{
    void *p = calloc(count + 1, size);
    must(p ? FMB_OK : FMB_ERR_MEMORY);
    return p;
}

dense dense_new(int dim, int rows)
{
    size_t cells = (size_t)rows * (size_t)(dim + 1);
    dense d = {dim, rows, get((size_t)rows, sizeof *d.rel), get(cells, sizeof *d.cell)};
    for (size_t k = 0; k < cells; k++)
        mpq_init(d.cell[k]);
    return d;
}

void dense_free(dense *d)
{
    for (size_t k = 0; k < (size_t)d->rows * (size_t)(d->dim + 1); k++)
        mpq_clear(d->cell[k]);
    free(d->cell);
    free(d->rel);
}

mpq_t *dense_row(const dense *d, int i)
{
    return d->cell + (size_t)i * (size_t)(d->dim + 1);
}

mpq_ptr dense_rhs(const dense *d, int i)
{
    return dense_row(d, i)[d->dim];
}

dense dense_of(const fmb_system *s)
{
    dense d = dense_new(fmb_system_dim(s), (int)fmb_system_rows(s));
    mpq_t coef;
    mpq_init(coef);
    for (int i = 0; i < d.rows; i++) {
        d.rel[i] = fmb_system_rel(s, (size_t)i);
        fmb_system_rhs_q(s, (size_t)i, dense_rhs(&d, i));
        for (size_t k = 0; k < fmb_system_terms(s, (size_t)i); k++) {
            int var = fmb_system_term_q(s, (size_t)i, k, coef);
            mpq_set(dense_row(&d, i)[var], coef);
        }
    }
    mpq_clear(coef);
    return d;
}

void dense_swap(dense *d, int i, int k)
{
    fmb_rel rel = d->rel[i];
    d->rel[i] = d->rel[k];
    d->rel[k] = rel;
    for (int j = 0; j <= d->dim; j++)
        mpq_swap(dense_row(d, i)[j], dense_row(d, k)[j]);
}

dense dense_without(const dense *d, int i, int j)
{
    dense out = dense_new(d->dim - (j >= 0), d->rows - (i >= 0));
    for (int from = 0, to = 0; from < d->rows; from++) {
        if (from == i)
            continue;
        out.rel[to] = d->rel[from];
        for (int column = 0, k = 0; column <= d->dim; column++)
            if (column != j)
                mpq_set(dense_row(&out, to)[k++], dense_row(d, from)[column]);
        to++;
    }
    return out;
}

fmb_system *dense_system(const dense *d)
{
    fmb_system *s = NULL;
    int *var = get((size_t)d->dim, sizeof *var);
    for (int j = 0; j < d->dim; j++)
        var[j] = j;
    must(fmb_system_new(d->dim, NULL, &s));
    for (int i = 0; i < d->rows; i++)
        must(fmb_system_add_q(s, (size_t)d->dim, var, dense_row(d, i), d->rel[i], dense_rhs(d, i)));
    free(var);
    return s;
}

fmb_system *support_closure(const fmb_system *s)
{
    dense d = dense_of(s);
    for (int i = 0; i < d.rows; i++)
        d.rel[i] = d.rel[i] == FMB_LT ? FMB_LE : d.rel[i];
    fmb_system *closed = dense_system(&d);
    dense_free(&d);
    return closed;
}
