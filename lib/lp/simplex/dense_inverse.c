/* dense_inverse.c: see dense_inverse.h. */
#include "lp/simplex/dense_inverse.h"

#include <math.h>
#include <string.h>

#include "base/arrays.h"

static fmb_status hold_inverse(fmb_dense_inverse *v, fmb_mem *mem, bool get)
{
    const size_t n = v->most_n;
    return FMB_ARRAYS_IN_BLOCK(mem, get, FMB_ARRAY(v->at, n * n), FMB_ARRAY(v->work, n),
                               FMB_ARRAY(v->is_unit, n));
}

fmb_status fmb_dense_inverse_init(fmb_dense_inverse *v, fmb_mem *mem, const fmb_kernels *kernels,
                                  size_t n)
{
    *v = (fmb_dense_inverse){.kernels = kernels, .most_n = n};
    FMB_TRY(hold_inverse(v, mem, true));
    fmb_dense_inverse_restart(v, n);
    return FMB_OK;
}

void fmb_dense_inverse_clear(fmb_dense_inverse *v, fmb_mem *mem)
{
    (void)hold_inverse(v, mem, false);
}

void fmb_dense_inverse_restart(fmb_dense_inverse *v, size_t n)
{
    v->n = n;
    memset(v->at, 0, n * n * sizeof *v->at);
    for (size_t r = 0; r < n; r++) {
        v->at[r * n + r] = 1;
        v->is_unit[r] = true;
    }
}

/* For short vectors a function call would not pay. */
static inline void add_multiple(const fmb_dense_inverse *v, double *restrict to,
                                const double *restrict from, double factor)
{
    if (v->n > 16)
        v->kernels->accumulate(to, from, v->n, factor);
    else
        for (size_t r = 0; r < v->n; r++)
            to[r] += factor * from[r];
}

void fmb_dense_inverse_add_term(const fmb_dense_inverse *v, size_t j, double factor, double *entry)
{
    add_multiple(v, entry, &v->at[j * v->n], factor);
}

void fmb_dense_inverse_write(const fmb_dense_inverse *v, const double *a, double *entry)
{
    memset(entry, 0, v->n * sizeof *entry);
    for (size_t j = 0; j < v->n; j++)
        if (a[j] != 0)
            add_multiple(v, entry, &v->at[j * v->n], a[j]);
}

void fmb_dense_inverse_replace(fmb_dense_inverse *v, size_t r, const double *entry)
{
    double pivot = entry[r];
    for (size_t k = 0; k < v->n; k++)
        v->work[k] = entry[k] / pivot;
    for (size_t j = 0; j < v->n; j++) {
        double *row = &v->at[j * v->n], f = row[r];
        if (f == 0)
            continue;
        add_multiple(v, row, v->work, -f);
        row[r] = f / pivot;
    }
    v->is_unit[r] = false;
}

size_t fmb_dense_inverse_span(fmb_dense_inverse *v, const double *entry, double least)
{
    size_t best = SIZE_MAX;
    for (size_t r = 0; r < v->n; r++)
        if (v->is_unit[r] && fabs(entry[r]) > least) {
            least = fabs(entry[r]);
            best = r;
        }
    if (best != SIZE_MAX)
        fmb_dense_inverse_replace(v, best, entry);
    return best;
}

void fmb_dense_inverse_edge(const fmb_dense_inverse *v, size_t r, double *edge)
{
    for (size_t j = 0; j < v->n; j++)
        edge[j] = v->at[j * v->n + r];
}

/* Four at a time, for parallel execution. */
void fmb_dense_inverse_measure(const fmb_dense_inverse *v, double *square)
{
    size_t n = v->n, r = 0;
    for (; r + 4 <= n; r += 4) {
        double sum[4] = {0};
        const double *at = &v->at[r];
        for (size_t k = 0; k < n; k++, at += n)
            for (size_t i = 0; i < 4; i++)
                sum[i] += at[i] * at[i];
        memcpy(&square[r], sum, sizeof sum);
    }
    for (; r < n; r++) {
        square[r] = 0;
        for (size_t k = 0; k < n; k++)
            square[r] += v->at[k * n + r] * v->at[k * n + r];
    }
}
