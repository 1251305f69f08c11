/* met_points.c: see met_points.h. */
#include "solve/query/met_points.h"

#include <stdlib.h>

void fmb_met_points_begin(fmb_met_points *m, fmb_mem *mem, int part, size_t k)
{
    fmb_met_points_clear(m);
    *m = (fmb_met_points){.mem = mem, .part = part, .width = k + 1};
}

static void clear_met_point(fmb_met_point *p, size_t width, fmb_mem *mem)
{
    fmb_vec_clear(&p->y, width, mem);
    fmb_mem_put(mem, p->y.s, width, sizeof *p->y.s);
    fmb_integers_clear(&p->x, mem);
}

void fmb_met_points_clear(fmb_met_points *m)
{
    for (size_t i = 0; i < m->size; i++)
        clear_met_point(&m->point[i], m->width, m->mem);
    if (m->mem)
        fmb_mem_put(m->mem, m->point, m->capacity, sizeof *m->point);
    *m = (fmb_met_points){0};
}

fmb_status fmb_met_points_add(fmb_met_points *m, const fmb_vec *y, fmb_integers *x, fmb_num *num)
{
    fmb_met_point p = {.y.s = fmb_mem_get(m->mem, m->width, sizeof *p.y.s)};
    if (x) {
        p.x = *x;
        *x = (fmb_integers){0};
    }
    fmb_status st = p.y.s ? FMB_OK : fmb_mem_status(m->mem);
    FMB_THEN(st, fmb_vec_copy(&p.y, y, m->width, m->mem));
    if (st == FMB_OK && !p.y.z)
        fmb_vec_measure(&p.y, m->width);
    FMB_THEN(st, fmb_vec_reduce(&p.y, m->width, num));
    FMB_THEN(st, FMB_RESERVE(m->mem, &m->point, &m->capacity, m->size + 1));
    if (st != FMB_OK) {
        clear_met_point(&p, m->width, m->mem);
        return st;
    }
    m->point[m->size++] = p;
    m->sorted = false;
    return FMB_OK;
}

/* A point and its width, as the comparison of qsort gets no other argument. */
typedef struct placed_point {
    fmb_met_point point;
    size_t width;
} placed_point;

/* Among equal points those with a known preimage come first. */
static int compare_met_points(const void *a, const void *b)
{
    const placed_point *p = a, *q = b;
    int order = fmb_vec_compare(&p->point.y, &q->point.y, p->width);
    return order != 0 ? order : (p->point.x.size == 0) - (q->point.x.size == 0);
}

/* False without memory. */
static bool sort_met_points(fmb_met_points *m)
{
    placed_point *list = m->sorted ? NULL : fmb_mem_get(m->mem, m->size, sizeof *list);
    if (m->sorted || !list)
        return m->sorted;
    for (size_t i = 0; i < m->size; i++)
        list[i] = (placed_point){m->point[i], m->width};
    qsort(list, m->size, sizeof *list, compare_met_points);
    for (size_t i = 0; i < m->size; i++)
        m->point[i] = list[i].point;
    fmb_mem_put(m->mem, list, m->size, sizeof *list);
    return m->sorted = true;
}

const fmb_met_point *fmb_met_points_find(fmb_met_points *m, const fmb_vec *y)
{
    size_t from = 0, to = m->size;
    if (m->size == 0 || !sort_met_points(m))
        return NULL;
    while (from < to) {
        size_t middle = from + (to - from) / 2;
        if (fmb_vec_compare(&m->point[middle].y, y, m->width) < 0)
            from = middle + 1;
        else
            to = middle;
    }
    bool found = from < m->size && fmb_vec_equal(&m->point[from].y, y, m->width) &&
                 m->point[from].x.size > 0;
    return found ? &m->point[from] : NULL;
}
