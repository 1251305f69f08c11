/* arrays.h: the arrays of a structure, which come and go together: named once for both.
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
    void *pointer; /* where the pointer to it is */
    size_t count;
    uint32_t size; /* of an element [bytes] */
    bool zero;     /* it comes with zeros in it */
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

/* get: each pointer gets a block, or NULL where there is no memory, so that all of them may be put
 * in any case. If not, blocks are put, and pointers are NULL. Errors: MEMORY, LIMIT. */
fmb_status fmb_arrays(fmb_mem *m, bool get, const fmb_array *array, size_t n);
#define FMB_ARRAYS(m, get, ...)                                                                    \
    fmb_arrays(m, get, (const fmb_array[]){__VA_ARGS__},                                           \
               sizeof((const fmb_array[]){__VA_ARGS__}) / sizeof(fmb_array))
/* The same in one block, for arrays that are all put as they were got: then each is where the first
 * one's block is, and is never put or grown alone. */
fmb_status fmb_arrays_in_block(fmb_mem *m, bool get, const fmb_array *array, size_t n);
#define FMB_ARRAYS_IN_BLOCK(m, get, ...)                                                           \
    fmb_arrays_in_block(m, get, (const fmb_array[]){__VA_ARGS__},                                  \
                        sizeof((const fmb_array[]){__VA_ARGS__}) / sizeof(fmb_array))
/* A list of them and how many. */
#define FMB_ALL(arrays) (arrays), sizeof(arrays) / sizeof *(arrays)
/* The same of those that have grown one by one, each to a capacity of its own. */
#define FMB_ARRAYS_PUT(m, ...) (void)FMB_ARRAYS(m, false, __VA_ARGS__)

#endif
