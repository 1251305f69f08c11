/* indexed_vector.c: see indexed_vector.h. */
#include "lp/linalg/doubles/indexed_vector.h"

fmb_status fmb_indexed_vector_resize(fmb_indexed_vector *v, fmb_mem *mem, size_t size)
{
    if (size >= v->room) {
        size_t room = size + size / 2 + 1;
        double *at = fmb_mem_get(mem, room, sizeof *at);
        int *index = fmb_mem_get(mem, room, sizeof *index);
        if (!at || !index) {
            fmb_mem_put(mem, at, room, sizeof *at);
            fmb_mem_put(mem, index, room, sizeof *index);
            return fmb_mem_status(mem);
        }
        fmb_indexed_vector_free(v, mem);
        *v = (fmb_indexed_vector){.at = at, .index = index, .room = room};
    }
    v->size = size;
    fmb_indexed_vector_clear(v, true);
    fmb_indexed_vector_clear(v, false);
    return FMB_OK;
}

void fmb_indexed_vector_free(fmb_indexed_vector *v, fmb_mem *mem)
{
    fmb_mem_put(mem, v->at, v->room, sizeof *v->at);
    fmb_mem_put(mem, v->index, v->room, sizeof *v->index);
    *v = (fmb_indexed_vector){0};
}

void fmb_indexed_vector_clear(fmb_indexed_vector *v, bool full)
{
    if (v->full || full || v->count > v->size / 8)
        memset(v->at, 0, v->size * sizeof *v->at);
    else
        for (size_t t = 0; t < v->count; t++)
            v->at[v->index[t]] = 0;
    v->count = 0;
    v->full = full;
}

void fmb_indexed_vector_make_sparse(fmb_indexed_vector *v)
{
    size_t count = 0;
    for (size_t k = 0; v->full && k < v->size; k++) {
        v->index[count] = (int)k;
        count += v->at[k] != 0;
    }
    if (!v->full || 2 * count >= v->size)
        return;
    v->full = false;
    v->count = count;
}

void fmb_indexed_vector_subtract(const fmb_indexed_vector *v, double factor, double *to,
                                 const fmb_kernels *k)
{
    if (v->full)
        k->accumulate(to, v->at, v->size, -factor);
    for (size_t t = 0; !v->full && t < v->count; t++)
        to[v->index[t]] -= factor * v->at[v->index[t]];
}
