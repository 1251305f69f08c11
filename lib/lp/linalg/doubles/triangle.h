/* triangle.h: a sparse triangular matrix in doubles, solved in both directions, skipping zeros.
 *
 * Step k has a pivot p_k, and coefficients t_kq at earlier steps q. Forwards, v_k becomes (v_k -
 * sum_{q<k} v_q t_kq) / p_k; backwards, v_q becomes (v_q - sum_{k>q} v_k t_kq) / p_q. A bit set
 * marks the steps that may be nonzero. Steps may be added at the end, and dropped anywhere: at
 * these v becomes 0 in both directions.
 */
#ifndef FMB_LP_TRIANGLE_H
#define FMB_LP_TRIANGLE_H

#include <math.h>
#include <stdint.h>

#include "base/mem.h"
#include "lp/linalg/doubles/indexed_vector.h"

/* Lists of indexed values, one after another: list k is start[k] .. start[k + 1]. */
typedef struct fmb_compressed_rows {
    size_t *start; /* [lists + 1] */
    int *index;
    double *value;
    size_t size, index_room, value_room, start_room;
} fmb_compressed_rows;

/* Make room for the starts of so many lists. Errors: MEMORY, LIMIT. */
fmb_status fmb_compressed_rows_reserve_starts(fmb_compressed_rows *l, fmb_mem *mem, size_t lists);
void fmb_compressed_rows_free(fmb_compressed_rows *l, fmb_mem *mem);
/* Make room for so many more values. Errors: MEMORY, LIMIT. */
fmb_status fmb_compressed_rows_reserve(fmb_compressed_rows *l, fmb_mem *mem, size_t more);
static inline void fmb_compressed_rows_push(fmb_compressed_rows *l, size_t index, double value)
{
    l->index[l->size] = (int)index;
    l->value[l->size++] = value;
}

/* A coefficient of an added step; the links of an earlier step form a list. */
typedef struct fmb_link {
    int before, step; /* the previous link of the earlier step, or -1 */
    double value;
} fmb_link;

typedef struct fmb_triangle {
    size_t most, steps;
    fmb_compressed_rows ahead, back; /* by earlier step: later step, value; by later step: earlier
                                        step, value. Added steps are in `back` only. */
    int *last;                       /* [most] by earlier step: its last link, or -1 */
    fmb_link *link;                  /* [links] */
    size_t links, link_room;
    double *pivot;   /* [most] infinite if the step was dropped */
    double *v;       /* [most] all zero between calls */
    uint64_t *marks; /* [most / 64 + 1] likewise */
} fmb_triangle;

/* No steps. Errors: MEMORY, LIMIT. The caller must call fmb_triangle_clear even after an error. */
fmb_status fmb_triangle_init(fmb_triangle *t, fmb_mem *mem, size_t most);
void fmb_triangle_clear(fmb_triangle *t, fmb_mem *mem);
/* Pivots and `ahead` have been filled in for so many steps, with step i written as step_of[i]:
 * write `back`. Errors: MEMORY, LIMIT. */
fmb_status fmb_triangle_finish(fmb_triangle *t, fmb_mem *mem, size_t steps, const int *step_of);

/* Make room for one more step with so many coefficients. Errors: MEMORY, LIMIT. */
fmb_status fmb_triangle_reserve(fmb_triangle *t, fmb_mem *mem, size_t numbers);
/* Give the step being added this coefficient at step q. */
void fmb_triangle_push(fmb_triangle *t, size_t q, double value);
/* Complete the step being added, with this pivot. */
void fmb_triangle_add(fmb_triangle *t, double pivot);
static inline void fmb_triangle_drop(fmb_triangle *t, size_t k)
{
    t->pivot[k] = INFINITY;
}

/* v_k += x. */
static inline void fmb_triangle_put(fmb_triangle *t, size_t k, double x)
{
    t->v[k] += x;
    t->marks[k / 64] |= (uint64_t)1 << (k % 64);
}
void fmb_triangle_forward(fmb_triangle *t);
void fmb_triangle_backward(fmb_triangle *t);
/* List l of the marked entries, by step. */
void fmb_triangle_list(const fmb_triangle *t, fmb_compressed_rows *l);
/* Add all entries to another triangle, or to a vector, entry k at place at[k]; here they become 0.
 */
void fmb_triangle_move(fmb_triangle *t, const int *at, fmb_triangle *to);
void fmb_triangle_hand_out(fmb_triangle *t, const int *at, fmb_indexed_vector *to);

#endif
