/* arrays.c: see arrays.h. */
#include "base/arrays.h"

#include <string.h>

static void *get_array(fmb_mem *m, const fmb_array *a)
{
    return a->zero ? fmb_mem_zero(m, a->count, a->size) : fmb_mem_get(m, a->count, a->size);
}

fmb_status fmb_arrays(fmb_mem *m, bool get, const fmb_array *array, size_t n)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; i < n; i++) {
        void *block = NULL;
        if (get && st == FMB_OK)
            block = get_array(m, &array[i]);
        if (get && !block && st == FMB_OK)
            st = fmb_mem_status(m);
        if (!get) {
            memcpy(&block, array[i].pointer, sizeof block);
            fmb_mem_put(m, block, array[i].count, array[i].size);
            block = NULL;
        }
        memcpy(array[i].pointer, &block, sizeof block);
    }
    return st;
}
