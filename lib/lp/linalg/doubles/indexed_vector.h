/* indexed_vector.h: a vector in doubles of which most may be zero, and the places where it is not.
 *
 * Invariant: either it is full, and every place counts; or at[k] is 0 but for k in index[0..count),
 * which are different. room > size: an index may be written behind the last one, and not counted.
 */
#ifndef FMB_LP_INDEXED_VECTOR_H
#define FMB_LP_INDEXED_VECTOR_H

#include <math.h>
#include <string.h>

#include "base/mem.h"
#include "num/kernels/kernels.h"

typedef struct fmb_indexed_vector {
    double *at; /* [size] */
    int *index; /* [count] */
    size_t size, count, room;
    bool full;
} fmb_indexed_vector;

/* size may grow later: nothing is kept but zeros. Errors: MEMORY, LIMIT. */
fmb_status fmb_indexed_vector_resize(fmb_indexed_vector *v, fmb_mem *mem, size_t size);
void fmb_indexed_vector_free(fmb_indexed_vector *v, fmb_mem *mem);

/* All zero again; full or not. */
void fmb_indexed_vector_clear(fmb_indexed_vector *v, bool full);
/* If most of a full one is zero, only what is not counts from now on. */
void fmb_indexed_vector_make_sparse(fmb_indexed_vector *v);
/* to -= factor v, to[v->size]. */
void fmb_indexed_vector_subtract(const fmb_indexed_vector *v, double factor, double *to,
                                 const fmb_kernels *k);

/* Places that count, and the t-th of them. */
static inline size_t fmb_indexed_vector_count(const fmb_indexed_vector *v)
{
    return v->full ? v->size : v->count;
}
static inline size_t fmb_indexed_vector_key(const fmb_indexed_vector *v, size_t t)
{
    return v->full ? t : (size_t)v->index[t];
}

/* Less than this is nothing; half of it stands where numbers have cancelled, which stay in the
 * index. */
#define FMB_NOTHING 1e-40

/* Add x to place k of one that is not full. */
static inline void fmb_indexed_vector_add(fmb_indexed_vector *v, size_t k, double x)
{
    double sum = v->at[k] + x;
    if (v->at[k] == 0)
        v->index[v->count++] = (int)k;
    v->at[k] = sum != 0 ? sum : FMB_NOTHING / 2;
}

/* Place k becomes x, likewise. */
static inline void fmb_indexed_vector_put(fmb_indexed_vector *v, size_t k, double x)
{
    if (v->at[k] == 0)
        v->index[v->count++] = (int)k;
    v->at[k] = x != 0 ? x : FMB_NOTHING / 2;
}

#endif
