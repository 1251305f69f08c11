/* compressed_rows.h: lists of numbered values, one after another: those of rows, columns, steps. */
#ifndef FMB_LP_COMPRESSED_ROWS_H
#define FMB_LP_COMPRESSED_ROWS_H

#include "base/mem.h"

/* List k is start[k] .. start[k + 1]. */
typedef struct fmb_compressed_rows {
    size_t *start; /* [n + 1] */
    int *index;
    double *value;
    size_t size, index_room, value_room, start_room;
} fmb_compressed_rows;

/* Room for the starts of so many lists. Errors: MEMORY, LIMIT. */
fmb_status fmb_compressed_rows_reserve_starts(fmb_compressed_rows *l, fmb_mem *mem, size_t lists);
void fmb_compressed_rows_free(fmb_compressed_rows *l, fmb_mem *mem);

/* Room for so many values more. Errors: MEMORY, LIMIT. */
fmb_status fmb_compressed_rows_reserve(fmb_compressed_rows *l, fmb_mem *mem, size_t more);
static inline void fmb_compressed_rows_push(fmb_compressed_rows *l, size_t index, double value)
{
    l->index[l->size] = (int)index;
    l->value[l->size++] = value;
}

#endif
