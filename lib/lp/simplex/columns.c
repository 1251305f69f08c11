/* columns.c: see columns.h. */
#include "lp/simplex/columns.h"

/* Least share of nonzeros for dense storage, and most entries of that. */
#define DENSE      0.3
#define MOST_DENSE ((size_t)1 << 22)

fmb_status fmb_columns_init(fmb_columns *c, const fmb_scaled_program *f)
{
    *c = (fmb_columns){.f = f};
    c->start = fmb_mem_zero(f->run->mem, f->n + 1, sizeof *c->start);
    return c->start ? FMB_OK : fmb_mem_status(f->run->mem);
}

void fmb_columns_clear(fmb_columns *c)
{
    fmb_mem *mem = c->f->run->mem;
    fmb_mem_put(mem, c->start, c->f->n + 1, sizeof *c->start);
    fmb_mem_put(mem, c->row, c->row_room, sizeof *c->row);
    fmb_mem_put(mem, c->value, c->value_room, sizeof *c->value);
}

static fmb_status fill_sparse_columns(fmb_columns *c)
{
    const fmb_scaled_program *f = c->f;
    size_t terms = f->start[f->m];
    fmb_mem *mem = f->run->mem;
    FMB_TRY(FMB_RESERVE(mem, &c->row, &c->row_room, terms));
    FMB_TRY(FMB_RESERVE(mem, &c->value, &c->value_room, terms));
    memset(c->start, 0, (f->n + 1) * sizeof *c->start);
    for (size_t i = 0; i < f->m; i++)
        for (size_t k = 0; k < f->p->row[i].size; k++)
            c->start[fmb_scaled_program_columns(f, i)[k]]++;
    for (size_t j = 0, sum = 0; j <= f->n; j++) {
        sum += c->start[j];
        c->start[j] = sum;
    }
    for (size_t i = f->m; i-- > 0;)
        for (size_t k = 0; k < f->p->row[i].size; k++) {
            size_t at = --c->start[fmb_scaled_program_columns(f, i)[k]];
            c->row[at] = (int)i;
            c->value[at] = f->value[f->start[i] + k];
        }
    return FMB_OK;
}

/* Copy the rows from number `first` on into dense columns. */
static fmb_status fill_dense_columns(fmb_columns *c, size_t first)
{
    const fmb_scaled_program *f = c->f;
    if (f->m > c->capacity) {
        size_t capacity = f->m + (first > 0 ? f->m / 2 : 0);
        fmb_status st = FMB_RESERVE(f->run->mem, &c->value, &c->value_room, f->n * capacity);
        if (st != FMB_OK)
            return st;
        c->capacity = capacity;
        first = 0;
    }
    for (size_t j = 0; j < f->n; j++)
        memset(&c->value[j * c->capacity + first], 0, (f->m - first) * sizeof *c->value);
    for (size_t i = first; i < f->m; i++)
        for (size_t k = 0; k < f->p->row[i].size; k++)
            c->value[(size_t)fmb_scaled_program_columns(f, i)[k] * c->capacity + i] =
                f->value[f->start[i] + k];
    return FMB_OK;
}

fmb_status fmb_columns_grow(fmb_columns *c)
{
    const fmb_scaled_program *f = c->f;
    bool was_dense = c->dense;
    c->dense =
        f->n * f->m <= MOST_DENSE && (double)f->start[f->m] > DENSE * (double)f->n * (double)f->m;
    if (!was_dense)
        c->capacity = 0;
    fmb_status st = c->dense ? fill_dense_columns(c, was_dense ? c->m : 0) : fill_sparse_columns(c);
    if (st == FMB_OK)
        c->m = f->m;
    return st;
}

/* The number of terms in columns where x is nonzero; counting stops at `most`. */
static size_t count_touched_terms(const fmb_columns *c, const fmb_indexed_vector *x, size_t most)
{
    size_t terms = 0;
    for (size_t t = 0; t < x->count && terms < most; t++)
        terms += c->start[x->index[t] + 1] - c->start[x->index[t]];
    return terms;
}

static void multiply_sparse_columns(const fmb_columns *c, const fmb_indexed_vector *x,
                                    fmb_indexed_vector *rate)
{
    bool full = x->full || count_touched_terms(c, x, c->m / 4 + 1) > c->m / 4;
    fmb_indexed_vector_clear(rate, full);
    for (size_t t = 0; t < fmb_indexed_vector_count(x); t++) {
        size_t j = fmb_indexed_vector_key(x, t);
        double factor = x->at[j];
        if (factor == 0)
            continue;
        for (size_t k = c->start[j]; k < c->start[j + 1]; k++)
            if (full)
                rate->at[c->row[k]] += factor * c->value[k];
            else
                fmb_indexed_vector_add(rate, (size_t)c->row[k], factor * c->value[k]);
    }
}

void fmb_columns_times(const fmb_columns *c, const fmb_indexed_vector *x, fmb_indexed_vector *rate)
{
    if (!c->dense) {
        multiply_sparse_columns(c, x, rate);
        return;
    }
    fmb_indexed_vector_clear(rate, true);
    for (size_t t = 0; t < fmb_indexed_vector_count(x); t++) {
        size_t j = fmb_indexed_vector_key(x, t);
        if (x->at[j] != 0)
            c->f->run->kernels->accumulate(rate->at, &c->value[j * c->capacity], c->m, x->at[j]);
    }
}
