/* indexed_vector.h: a vector of doubles, many of which may be zero, with a list of its nonzeros.
 *
 * Invariant: either it is full, and every place counts; or at[k] is 0 except for k in index[count],
 * which are distinct. room > size: an index may be written beyond the last one, uncounted.
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

/* Make room for size entries, all zero; size may grow later. Errors: MEMORY, LIMIT. */
fmb_status fmb_indexed_vector_resize(fmb_indexed_vector *v, fmb_mem *mem, size_t size);
void fmb_indexed_vector_free(fmb_indexed_vector *v, fmb_mem *mem);

/* Set all entries to zero; the vector becomes full or sparse. */
void fmb_indexed_vector_clear(fmb_indexed_vector *v, bool full);
/* If most entries of a full vector are zero, make it sparse. */
void fmb_indexed_vector_make_sparse(fmb_indexed_vector *v);
/* to -= factor v, to[v->size]. */
void fmb_indexed_vector_subtract(const fmb_indexed_vector *v, double factor, double *to,
                                 const fmb_kernels *k);

/* The number of places that count, and the t-th of them. */
static inline size_t fmb_indexed_vector_count(const fmb_indexed_vector *v)
{
    return v->full ? v->size : v->count;
}
static inline size_t fmb_indexed_vector_key(const fmb_indexed_vector *v, size_t t)
{
    return v->full ? t : (size_t)v->index[t];
}

/* Entries below this count as zero; half of it replaces entries that have cancelled to 0, which
 * stay in the index. */
#define FMB_NOTHING 1e-40

/* Add x to entry k of a vector that is not full. */
static inline void fmb_indexed_vector_add(fmb_indexed_vector *v, size_t k, double x)
{
    double sum = v->at[k] + x;
    if (v->at[k] == 0)
        v->index[v->count++] = (int)k;
    v->at[k] = sum != 0 ? sum : FMB_NOTHING / 2;
}

#endif
