/* arrays.c: see arrays.h. */
#include "base/arrays.h"

#include <stddef.h>
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

/* Bytes of an array, rounded up to the strictest alignment; SIZE_MAX: too many. */
static size_t room_of_array(const fmb_array *a)
{
    const size_t unit = _Alignof(max_align_t);
    size_t bytes;
    bool fits = !__builtin_mul_overflow(a->count, a->size, &bytes) && bytes <= SIZE_MAX - unit;
    return fits ? (bytes + unit - 1) / unit * unit : SIZE_MAX;
}

static size_t room_of_arrays(const fmb_array *array, size_t n)
{
    size_t bytes = 0;
    for (size_t i = 0; i < n; i++)
        if (__builtin_add_overflow(bytes, room_of_array(&array[i]), &bytes))
            return SIZE_MAX;
    return bytes;
}

static void place_array(const fmb_array *a, char *at)
{
    if (at && a->zero && a->count > 0)
        memset(at, 0, a->count * a->size);
    memcpy(a->pointer, &at, sizeof at);
}

fmb_status fmb_arrays_in_block(fmb_mem *m, bool get, const fmb_array *array, size_t n)
{
    size_t bytes = room_of_arrays(array, n);
    char *block = NULL, *at;
    memcpy(&at, array[0].pointer, sizeof at);
    if (get)
        block = at = fmb_mem_get(m, bytes, 1);
    else
        fmb_mem_put(m, at, bytes, 1);
    for (size_t i = 0; i < n; i++) {
        place_array(&array[i], block ? at : NULL);
        at = block ? at + room_of_array(&array[i]) : NULL;
    }
    return get && !block ? fmb_mem_status(m) : FMB_OK;
}
