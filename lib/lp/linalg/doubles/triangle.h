/* triangle.h: a sparse triangle in doubles, solved either way, without looking at what is zero.
 *
 * Step k has a pivot p_k, and numbers t_kq beside earlier steps q. Forwards, v_k becomes
 * (v_k - sum_{q<k} v_q t_kq) / p_k; backwards, v_q becomes (v_q - sum_{k>q} v_k t_kq) / p_q. Steps
 * where something is not zero are marked in a bit set. Steps may be added at the end, and dropped
 * anywhere: v is 0 there, after either.
 */
#ifndef FMB_LP_TRIANGLE_H
#define FMB_LP_TRIANGLE_H

#include <math.h>
#include <stdint.h>

#include "base/mem.h"
#include "lp/linalg/doubles/indexed_vector.h"

/* Lists of numbered values, one after another: list k is start[k] .. start[k + 1]. */
typedef struct fmb_compressed_rows {
    size_t *start; /* [lists + 1] */
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

/* A number of a step that was added; the links of an earlier step lead from one to the next. */
typedef struct fmb_link {
    int before, step; /* another one of that earlier step, or -1 */
    double value;
} fmb_link;

typedef struct fmb_triangle {
    size_t most, steps;
    fmb_compressed_rows ahead, back; /* by earlier step: later step, number; by later step: earlier
                                        step, number. Steps that are added are in back only. */
    int *last;                       /* [most] by earlier step: its last link, or -1 */
    fmb_link *link;                  /* [links] */
    size_t links, link_room;
    double *pivot;   /* [most] infinite where the step was dropped */
    double *v;       /* [most] all zero between calls */
    uint64_t *marks; /* [most / 64 + 1] likewise */
} fmb_triangle;

/* No steps yet, and room for some. In any case fmb_triangle_clear it. Errors: MEMORY, LIMIT. */
fmb_status fmb_triangle_init(fmb_triangle *t, fmb_mem *mem, size_t most);
void fmb_triangle_clear(fmb_triangle *t, fmb_mem *mem);
/* Pivots and `ahead` are those of so many steps, with step_of[i] as i: write `back`. Errors:
 * MEMORY, LIMIT. */
fmb_status fmb_triangle_finish(fmb_triangle *t, fmb_mem *mem, size_t steps, const int *step_of);

/* Room for one more step, with so many numbers. Errors: MEMORY, LIMIT. */
fmb_status fmb_triangle_reserve(fmb_triangle *t, fmb_mem *mem, size_t numbers);
/* The step that is being added has this number beside step q. */
void fmb_triangle_push(fmb_triangle *t, size_t q, double value);
/* And this pivot, with which it is complete. */
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
/* Numbers that are marked, by step, become list l. */
void fmb_triangle_list(const fmb_triangle *t, fmb_compressed_rows *l);
/* All of them become 0, and are added to another triangle, or to a vector: number k at place at[k].
 */
void fmb_triangle_move(fmb_triangle *t, const int *at, fmb_triangle *to);
void fmb_triangle_hand_out(fmb_triangle *t, const int *at, fmb_indexed_vector *to);

#endif
