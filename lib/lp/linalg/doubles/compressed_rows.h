/* compressed_rows.h: lists of numbered values, one after another: those of rows, columns, steps. */
#ifndef FMB_LP_COMPRESSED_ROWS_H
#define FMB_LP_COMPRESSED_ROWS_H

#include "base/mem.h"

/* List k is start[k] .. start[k + 1]. */
typedef struct fmb_lists {
    size_t *start; /* [n + 1] */
    int *index;
    double *value;
    size_t size, index_room, value_room, start_room;
} fmb_lists;

/* Room for the starts of so many lists. Errors: MEMORY, LIMIT. */
fmb_status fmb_lists_reserve_starts(fmb_lists *l, fmb_mem *mem, size_t lists);
void fmb_lists_free(fmb_lists *l, fmb_mem *mem);

/* Room for so many values more. Errors: MEMORY, LIMIT. */
fmb_status fmb_lists_reserve(fmb_lists *l, fmb_mem *mem, size_t more);
static inline void fmb_lists_push(fmb_lists *l, size_t index, double value)
{
    l->index[l->size] = (int)index;
    l->value[l->size++] = value;
}

#endif
