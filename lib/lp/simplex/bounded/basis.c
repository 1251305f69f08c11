/* basis.c: see basis.h. */
#include "lp/simplex/bounded/basis.h"

#include <math.h>
#include <string.h>

#include "base/arrays.h"

/* ---- life ------------------------------------------------------------------------------------ */

/* Allocate or free the arrays by place. */
static fmb_status hold_places(fmb_basis *b, bool get)
{
    const size_t d = b->most_d;
    return FMB_ARRAYS_IN_BLOCK(b->mem, get, FMB_ARRAY(b->basic, d), FMB_ARRAY(b->old, d),
                               FMB_ARRAY(b->edge, d), FMB_ARRAY_ZERO(b->value, d),
                               FMB_ARRAY_ZERO(b->normal, d), FMB_ARRAY(b->entry, d),
                               FMB_ARRAY(b->rest, d));
}

/* Allocate or free the arrays by column. */
static fmb_status hold_columns(fmb_basis *b, bool get)
{
    const size_t n = b->capacity;
    return FMB_ARRAYS_IN_BLOCK(b->mem, get, FMB_ARRAY(b->at, b->most_d * n), FMB_ARRAY(b->range, n),
                               FMB_ARRAY(b->is_high, n), FMB_ARRAY(b->is_basic, n),
                               FMB_ARRAY(b->price, n), FMB_ARRAY(b->gain, n));
}

fmb_status fmb_basis_init(fmb_basis *b, fmb_mem *mem, const fmb_kernels *kernels, size_t d)
{
    *b = (fmb_basis){.mem = mem, .kernels = kernels, .d = d, .most_d = d};
    FMB_TRY(hold_places(b, true));
    FMB_TRY(fmb_dense_inverse_init(&b->inverse, mem, kernels, d));
    fmb_basis_restart(b, d);
    return FMB_OK;
}

void fmb_basis_clear(fmb_basis *b)
{
    if (!b->mem)
        return;
    (void)hold_columns(b, false);
    (void)hold_places(b, false);
    fmb_dense_inverse_clear(&b->inverse, b->mem);
}

/* Columns are stored row by row, so each row moves. */
fmb_status fmb_basis_reserve(fmb_basis *b, size_t capacity)
{
    fmb_basis old = *b;
    b->capacity = capacity;
    fmb_status st = hold_columns(b, true);
    if (st != FMB_OK) {
        (void)hold_columns(b, false);
        *b = old;
        return st;
    }
    if (old.size > 0) {
        for (size_t k = 0; k < b->d; k++)
            memcpy(&b->at[k * capacity], &old.at[k * old.capacity], old.size * sizeof *b->at);
        memcpy(b->range, old.range, old.size * sizeof *b->range);
        memcpy(b->is_high, old.is_high, old.size * sizeof *b->is_high);
        memcpy(b->is_basic, old.is_basic, old.size * sizeof *b->is_basic);
    }
    (void)hold_columns(&old, false);
    return FMB_OK;
}

/* ---- columns --------------------------------------------------------------------------------- */

void fmb_basis_restart(fmb_basis *b, size_t d)
{
    b->d = d;
    b->size = b->highs = 0;
    fmb_basis_empty(b);
}

fmb_status fmb_basis_add(fmb_basis *b, const double *v, fmb_range range)
{
    fmb_status st = FMB_OK;
    if (b->size == b->capacity)
        st = fmb_basis_reserve(b, b->capacity == 0 ? 64 : 2 * b->capacity);
    if (st != FMB_OK)
        return st;
    for (size_t k = 0; k < b->d; k++)
        b->at[k * b->capacity + b->size] = v[k];
    b->range[b->size] = (uint8_t)range;
    b->is_high[b->size] = b->is_basic[b->size] = false;
    b->size++;
    return FMB_OK;
}

/* ---- the basis ------------------------------------------------------------------------------- */

void fmb_basis_empty(fmb_basis *b)
{
    fmb_dense_inverse_restart(&b->inverse, b->d);
    if (b->size > 0)
        memset(b->is_basic, 0, b->size * sizeof *b->is_basic);
    for (size_t k = 0; k < b->d; k++)
        b->basic[k] = SIZE_MAX;
    b->pivots = 0;
}

void fmb_basis_write(fmb_basis *b, size_t j)
{
    for (size_t k = 0; k < b->d; k++)
        b->rest[k] = b->at[k * b->capacity + j];
    fmb_dense_inverse_write(&b->inverse, b->rest, b->entry);
}

static void note_column(fmb_basis *b, size_t r, size_t j)
{
    if (b->basic[r] != SIZE_MAX)
        b->is_basic[b->basic[r]] = false;
    b->highs -= b->is_high[j];
    b->is_high[j] = false;
    b->is_basic[j] = true;
    b->basic[r] = j;
    b->pivots++;
}

void fmb_basis_replace(fmb_basis *b, size_t r, size_t j)
{
    fmb_dense_inverse_replace(&b->inverse, r, b->entry);
    note_column(b, r, j);
}

bool fmb_basis_span(fmb_basis *b, size_t j, double least)
{
    fmb_basis_write(b, j);
    size_t r = fmb_dense_inverse_span(&b->inverse, b->entry, least);
    if (r != SIZE_MAX)
        note_column(b, r, j);
    return r != SIZE_MAX;
}

void fmb_basis_invert(fmb_basis *b)
{
    memcpy(b->old, b->basic, b->d * sizeof *b->old);
    fmb_basis_empty(b);
    for (size_t k = 0; k < b->d; k++)
        if (b->old[k] != SIZE_MAX)
            (void)fmb_basis_span(b, b->old[k], b->entry_zero);
    b->pivots = 0;
}
