/* triangle.c: see triangle.h. */
#include "lp/linalg/doubles/triangle.h"

#include <assert.h>
#include <string.h>

#include "base/arrays.h"

/* ---- lists ----------------------------------------------------------------------------------- */

fmb_status fmb_compressed_rows_reserve(fmb_compressed_rows *l, fmb_mem *mem, size_t more)
{
    size_t need = l->size + more;
    fmb_status st = FMB_RESERVE(mem, &l->index, &l->index_room, need);
    return st == FMB_OK ? FMB_RESERVE(mem, &l->value, &l->value_room, need) : st;
}

fmb_status fmb_compressed_rows_reserve_starts(fmb_compressed_rows *l, fmb_mem *mem, size_t lists)
{
    return FMB_RESERVE(mem, &l->start, &l->start_room, lists + 1);
}

void fmb_compressed_rows_free(fmb_compressed_rows *l, fmb_mem *mem)
{
    fmb_mem_put(mem, l->start, l->start_room, sizeof *l->start);
    fmb_mem_put(mem, l->index, l->index_room, sizeof *l->index);
    fmb_mem_put(mem, l->value, l->value_room, sizeof *l->value);
}

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status hold_arrays_of_steps(fmb_triangle *t, fmb_mem *mem, bool get)
{
    const size_t n = t->most;
    return FMB_ARRAYS(mem, get, FMB_ARRAY(t->last, n), FMB_ARRAY(t->pivot, n),
                      FMB_ARRAY_ZERO(t->v, n), FMB_ARRAY_ZERO(t->marks, n / 64 + 1));
}

fmb_status fmb_triangle_init(fmb_triangle *t, fmb_mem *mem, size_t most)
{
    *t = (fmb_triangle){.most = most};
    fmb_status st = hold_arrays_of_steps(t, mem, true);
    FMB_THEN(st, fmb_compressed_rows_reserve_starts(&t->ahead, mem, most));
    return st == FMB_OK ? fmb_compressed_rows_reserve_starts(&t->back, mem, most) : st;
}

void fmb_triangle_clear(fmb_triangle *t, fmb_mem *mem)
{
    fmb_compressed_rows_free(&t->ahead, mem);
    fmb_compressed_rows_free(&t->back, mem);
    fmb_mem_put(mem, t->link, t->link_room, sizeof *t->link);
    (void)hold_arrays_of_steps(t, mem, false);
}

/* ---- steps ----------------------------------------------------------------------------------- */

fmb_status fmb_triangle_finish(fmb_triangle *t, fmb_mem *mem, size_t steps, const int *step_of)
{
    fmb_compressed_rows *from = &t->ahead, *to = &t->back;
    t->steps = steps;
    t->links = to->size = 0;
    FMB_TRY(fmb_compressed_rows_reserve(to, mem, from->size));
    memset(to->start, 0, (steps + 1) * sizeof *to->start);
    memset(t->last, -1, t->most * sizeof *t->last);
    for (size_t i = 0; i < from->size; i++) {
        from->index[i] = step_of[from->index[i]];
        to->start[from->index[i]]++;
    }
    for (size_t k = 0, sum = 0; k <= steps; k++) {
        sum += to->start[k];
        to->start[k] = sum;
    }
    for (size_t k = steps; k-- > 0;)
        for (size_t i = from->start[k]; i < from->start[k + 1]; i++) {
            size_t at = --to->start[from->index[i]];
            to->index[at] = (int)k;
            to->value[at] = from->value[i];
        }
    to->size = from->size;
    return FMB_OK;
}

fmb_status fmb_triangle_reserve(fmb_triangle *t, fmb_mem *mem, size_t numbers)
{
    fmb_status st = FMB_RESERVE(mem, &t->link, &t->link_room, t->links + numbers);
    return st == FMB_OK ? fmb_compressed_rows_reserve(&t->back, mem, numbers) : st;
}

void fmb_triangle_push(fmb_triangle *t, size_t q, double value)
{
    fmb_compressed_rows_push(&t->back, q, value);
    t->link[t->links] = (fmb_link){t->last[q], (int)t->steps, value};
    t->last[q] = (int)t->links++;
}

void fmb_triangle_add(fmb_triangle *t, double pivot)
{
    assert(t->steps < t->most);
    t->pivot[t->steps++] = pivot;
    t->ahead.start[t->steps] = t->ahead.size;
    t->back.start[t->steps] = t->back.size;
}

/* ---- solving --------------------------------------------------------------------------------- */

/* Divide the otherwise complete v_k by the pivot. False: it is negligible. */
static inline bool divide_by_pivot(fmb_triangle *t, size_t k)
{
    t->v[k] /= t->pivot[k];
    return fabs(t->v[k]) > FMB_NOTHING;
}

static inline void subtract_list(fmb_triangle *t, const fmb_compressed_rows *l, size_t k)
{
    double factor = -t->v[k];
    for (size_t i = l->start[k]; i < l->start[k + 1]; i++)
        fmb_triangle_put(t, (size_t)l->index[i], factor * l->value[i]);
}

static inline void subtract_links(fmb_triangle *t, size_t k)
{
    double factor = -t->v[k];
    for (int i = t->last[k]; i >= 0; i = t->link[i].before)
        fmb_triangle_put(t, (size_t)t->link[i].step, factor * t->link[i].value);
}

/* Steps marked meanwhile are later ones. */
void fmb_triangle_forward(fmb_triangle *t)
{
    for (size_t w = 0; w <= t->steps / 64; w++)
        for (uint64_t done = 0, left; (left = t->marks[w] & ~done) != 0;) {
            int bit = __builtin_ctzll(left);
            size_t k = 64 * w + (size_t)bit;
            done |= (uint64_t)1 << bit;
            if (!divide_by_pivot(t, k))
                continue;
            subtract_list(t, &t->ahead, k);
            subtract_links(t, k);
        }
}

/* Here steps marked meanwhile are earlier ones. */
void fmb_triangle_backward(fmb_triangle *t)
{
    for (size_t w = t->steps / 64 + 1; w-- > 0;)
        for (uint64_t done = 0, left; (left = t->marks[w] & ~done) != 0;) {
            int bit = 63 - __builtin_clzll(left);
            size_t k = 64 * w + (size_t)bit;
            done |= (uint64_t)1 << bit;
            if (divide_by_pivot(t, k))
                subtract_list(t, &t->back, k);
        }
}

/* ---- numbers --------------------------------------------------------------------------------- */

void fmb_triangle_list(const fmb_triangle *t, fmb_compressed_rows *l)
{
    l->size = 0;
    for (size_t w = 0; w <= t->steps / 64; w++)
        for (uint64_t left = t->marks[w]; left != 0; left &= left - 1) {
            size_t k = 64 * w + (size_t)__builtin_ctzll(left);
            if (fabs(t->v[k]) > FMB_NOTHING)
                fmb_compressed_rows_push(l, k, t->v[k]);
        }
}

/* The next marked step k, from word *w of the marks on, is unmarked, and its value *x reset to 0.
 * False: none is marked. */
static inline bool take_number(fmb_triangle *t, size_t *w, size_t *k, double *x)
{
    while (t->marks[*w] == 0)
        if (++*w > t->steps / 64)
            return false;
    *k = 64 * *w + (size_t)__builtin_ctzll(t->marks[*w]);
    t->marks[*w] &= t->marks[*w] - 1;
    *x = t->v[*k];
    t->v[*k] = 0;
    return true;
}

void fmb_triangle_move(fmb_triangle *t, const int *at, fmb_triangle *to)
{
    size_t k, w = 0;
    for (double x; take_number(t, &w, &k, &x);)
        if (fabs(x) > FMB_NOTHING)
            fmb_triangle_put(to, (size_t)at[k], x);
}

void fmb_triangle_hand_out(fmb_triangle *t, const int *at, fmb_indexed_vector *to)
{
    size_t k, w = 0;
    for (double x; take_number(t, &w, &k, &x);)
        if (fabs(x) > FMB_NOTHING)
            fmb_indexed_vector_add(to, (size_t)at[k], x);
}
