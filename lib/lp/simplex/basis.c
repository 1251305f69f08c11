/* basis.c: see basis.h. */
#include "lp/simplex/basis.h"

#include <math.h>
#include <string.h>

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_basis_init(fmb_basis *b, fmb_mem *mem, const fmb_kernels *kernels, size_t d)
{
    *b = (fmb_basis){.mem = mem, .kernels = kernels, .d = d, .most_d = d};
    b->basic = fmb_mem_get(mem, d, sizeof *b->basic);
    b->old = fmb_mem_get(mem, d, sizeof *b->old);
    fmb_status st = fmb_dense_inverse_init(&b->inverse, mem, kernels, d);
    b->edge = fmb_mem_get(mem, d, sizeof *b->edge);
    b->value = fmb_mem_zero(mem, d, sizeof *b->value);
    b->normal = fmb_mem_zero(mem, d, sizeof *b->normal);
    b->entry = fmb_mem_get(mem, d, sizeof *b->entry);
    b->rest = fmb_mem_get(mem, d, sizeof *b->rest);
    b->length = fmb_mem_get(mem, d, sizeof *b->length);
    b->is_mirrored = fmb_mem_zero(mem, d, sizeof *b->is_mirrored);
    if (!b->basic || !b->old || !b->edge || !b->value || !b->normal || !b->entry || !b->rest ||
        !b->length || !b->is_mirrored)
        return fmb_mem_status(mem);
    if (st == FMB_OK)
        fmb_basis_restart(b, d);
    return st;
}

static void free_columns(fmb_basis *b)
{
    fmb_mem_put(b->mem, b->at, b->most_d * b->capacity, sizeof *b->at);
    fmb_mem_put(b->mem, b->range, b->capacity, sizeof *b->range);
    fmb_mem_put(b->mem, b->is_high, b->capacity, sizeof *b->is_high);
    fmb_mem_put(b->mem, b->is_basic, b->capacity, sizeof *b->is_basic);
    fmb_mem_put(b->mem, b->price, b->capacity, sizeof *b->price);
    fmb_mem_put(b->mem, b->gain, b->capacity, sizeof *b->gain);
    fmb_mem_put(b->mem, b->candidate, b->capacity, sizeof *b->candidate);
    fmb_mem_put(b->mem, b->cost, b->capacity, sizeof *b->cost);
}

void fmb_basis_clear(fmb_basis *b)
{
    if (!b->mem)
        return;
    free_columns(b);
    fmb_mem_put(b->mem, b->basic, b->most_d, sizeof *b->basic);
    fmb_mem_put(b->mem, b->old, b->most_d, sizeof *b->old);
    fmb_dense_inverse_clear(&b->inverse, b->mem);
    fmb_mem_put(b->mem, b->edge, b->most_d, sizeof *b->edge);
    fmb_mem_put(b->mem, b->value, b->most_d, sizeof *b->value);
    fmb_mem_put(b->mem, b->normal, b->most_d, sizeof *b->normal);
    fmb_mem_put(b->mem, b->entry, b->most_d, sizeof *b->entry);
    fmb_mem_put(b->mem, b->rest, b->most_d, sizeof *b->rest);
    fmb_mem_put(b->mem, b->length, b->most_d, sizeof *b->length);
    fmb_mem_put(b->mem, b->is_mirrored, b->most_d, sizeof *b->is_mirrored);
}

/* Columns lie by row, so each row moves. */
fmb_status fmb_basis_reserve(fmb_basis *b, size_t capacity)
{
    fmb_basis old = *b;
    b->capacity = capacity;
    b->at = fmb_mem_get(b->mem, b->most_d * capacity, sizeof *b->at);
    b->range = fmb_mem_get(b->mem, capacity, sizeof *b->range);
    b->is_high = fmb_mem_get(b->mem, capacity, sizeof *b->is_high);
    b->is_basic = fmb_mem_get(b->mem, capacity, sizeof *b->is_basic);
    b->price = fmb_mem_get(b->mem, capacity, sizeof *b->price);
    b->gain = fmb_mem_get(b->mem, capacity, sizeof *b->gain);
    b->cost = fmb_mem_get(b->mem, capacity, sizeof *b->cost);
    b->candidate = fmb_mem_get(b->mem, capacity, sizeof *b->candidate);
    if (!b->at || !b->range || !b->is_high || !b->is_basic || !b->price || !b->gain || !b->cost ||
        !b->candidate) {
        fmb_status st = fmb_mem_status(b->mem);
        free_columns(b);
        *b = old;
        return st;
    }
    if (old.size > 0) {
        for (size_t k = 0; k < b->d; k++)
            memcpy(&b->at[k * capacity], &old.at[k * old.capacity], old.size * sizeof *b->at);
        memcpy(b->range, old.range, old.size * sizeof *b->range);
        memcpy(b->is_high, old.is_high, old.size * sizeof *b->is_high);
        memcpy(b->is_basic, old.is_basic, old.size * sizeof *b->is_basic);
        memcpy(b->gain, old.gain, old.size * sizeof *b->gain);
        memcpy(b->cost, old.cost, old.size * sizeof *b->cost);
    }
    free_columns(&old);
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
    b->cost[b->size] = b->gain[b->size] = 0;
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
    for (size_t k = 0; k < b->d; k++) {
        b->basic[k] = SIZE_MAX;
        b->length[k] = 1;
        b->inverse.at[k * b->d + k] = b->is_mirrored[k] ? -1 : 1;
    }
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
