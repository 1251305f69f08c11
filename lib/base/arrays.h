/* arrays.h: the arrays of a structure, listed once both for allocating and for freeing them.
 *
 *   static fmb_status hold(body *b, bool get)
 *   {
 *       return FMB_ARRAYS(b->mem, get, FMB_ARRAY(b->place, b->n), FMB_ARRAY_ZERO(b->met, b->n));
 *   }
 */
#ifndef FMB_BASE_ARRAYS_H
#define FMB_BASE_ARRAYS_H

#include "base/mem.h"

typedef struct fmb_array {
    void *pointer; /* address of the pointer to the array */
    size_t count;
    uint32_t size; /* of an element [bytes] */
    bool zero;     /* allocated with zeros */
} fmb_array;

/* An array of that many elements, of the type that p points to. */
#define FMB_ARRAY(p, count)                                                                        \
    {                                                                                              \
        &(p), (count), sizeof *(p), false                                                          \
    }
#define FMB_ARRAY_ZERO(p, count)                                                                   \
    {                                                                                              \
        &(p), (count), sizeof *(p), true                                                           \
    }

/* get: allocate the arrays; after an error the others are NULL, so all may be freed even then. Else
 * free them and set the pointers to NULL. Errors: MEMORY, LIMIT. */
fmb_status fmb_arrays(fmb_mem *m, bool get, const fmb_array *array, size_t n);
#define FMB_ARRAYS(m, get, ...)                                                                    \
    fmb_arrays(m, get, (const fmb_array[]){__VA_ARGS__},                                           \
               sizeof((const fmb_array[]){__VA_ARGS__}) / sizeof(fmb_array))
/* Like fmb_arrays, but with one block for all arrays: freed only together, with the same list, as
 * the first pointer is the address of the block; none of them may be freed or grown alone. */
fmb_status fmb_arrays_in_block(fmb_mem *m, bool get, const fmb_array *array, size_t n);
#define FMB_ARRAYS_IN_BLOCK(m, get, ...)                                                           \
    fmb_arrays_in_block(m, get, (const fmb_array[]){__VA_ARGS__},                                  \
                        sizeof((const fmb_array[]){__VA_ARGS__}) / sizeof(fmb_array))
/* For argument lists: an array and the number of its elements. */
#define FMB_ALL(arrays) (arrays), sizeof(arrays) / sizeof *(arrays)
/* Free arrays that have grown one by one, each with its own capacity as the count. */
#define FMB_ARRAYS_PUT(m, ...) (void)FMB_ARRAYS(m, false, __VA_ARGS__)

#endif
