/* weights.c: multipliers over numbered rows; see weights.h. */
#include "num/weights.h"

fmb_status fmb_weights_add(fmb_weights *w, uint32_t row, const mpq_t value, fmb_mem *mem)
{
    FMB_TRY(FMB_RESERVE(mem, &w->index, &w->index_capacity, w->size + 1));
    FMB_TRY(FMB_RESERVE(mem, &w->value, &w->value_capacity, w->size + 1));
    mpq_init(w->value[w->size]);
    mpq_set(w->value[w->size], value);
    w->index[w->size++] = row;
    return FMB_OK;
}

void fmb_weights_clear(fmb_weights *w, fmb_mem *mem)
{
    for (size_t i = 0; i < w->size; i++)
        mpq_clear(w->value[i]);
    fmb_mem_put(mem, w->index, w->index_capacity, sizeof *w->index);
    fmb_mem_put(mem, w->value, w->value_capacity, sizeof *w->value);
    *w = (fmb_weights){0};
}
