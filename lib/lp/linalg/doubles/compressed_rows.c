/* compressed_rows.c: see updated_lu.h. */
#include "lp/linalg/doubles/updated_lu.h"

fmb_status fmb_compressed_rows_reserve(fmb_compressed_rows *l, fmb_mem *mem, size_t more)
{
    size_t need = l->size + more;
    fmb_status st = FMB_RESERVE(mem, &l->index, &l->index_room, need);
    return st == FMB_OK ? FMB_RESERVE(mem, &l->value, &l->value_room, need) : st;
}

fmb_status fmb_compressed_rows_reserve_starts(fmb_compressed_rows *l, fmb_mem *mem, size_t lists)
{
    return FMB_RESERVE(mem, &l->start, &l->start_room, lists + 1);
}

void fmb_compressed_rows_free(fmb_compressed_rows *l, fmb_mem *mem)
{
    fmb_mem_put(mem, l->start, l->start_room, sizeof *l->start);
    fmb_mem_put(mem, l->index, l->index_room, sizeof *l->index);
    fmb_mem_put(mem, l->value, l->value_room, sizeof *l->value);
}
