/* rays.c: which way to rays; see rays.h.
 *
 * - Few coordinates and many rows: rows are vectors of the dual cone, whose facets are the rays.
 *   Vector by vector these stay known with their neighbours (dd/facets.h).
 * - Else double description (dd/cone.h), rows of few coefficients first. Where rows look alike and
 *   there are many of them, its order can go wrong without bounds: of the cross-polytope's rows
 *   it keeps those that cut most, and gets millions of rays in between, where in lexicographic
 * order there are hundreds. So that order gets its turns.
 */
#include "solve/generate/rays.h"

#include <stdlib.h>

/* Up to so many coordinates, t included, facets with their neighbours are cheaper (measured: 2 to 4
 * times with 4 or 5, half as much with 7) ... */
#define FEW_COORDINATES 6
/* ... if there are so many rows for each. */
#define MANY_ROWS 4
/* Rays of the first turn and the last one of two orders. */
#define FIRST_RAYS 512
#define LAST_RAYS  4096
/* Between two looks at options.max_rows. */
#define RAYS_AT_A_TIME 512

/* ---- rows as vectors ------------------------------------------------------------------------- */

static fmb_status find_rays_as_facets(fmb_lifted *h)
{
    fmb_run *run = &h->q->run;
    bool wide = fmb_query_is_wide(h->q);
    fmb_image rows = {0};
    bool *line = fmb_mem_get(run->mem, h->rows, sizeof *line);
    if (!line)
        return fmb_mem_status(run->mem);
    for (size_t i = 0; i < h->rows; i++)
        line[i] = h->row[i].equality;
    fmb_status st = fmb_image_init_vectors(&rows, run, h->d, h->rows, h->v, line, wide);
    if (st == FMB_OK)
        st = fmb_image_init_dual(&h->image, &rows);
    fmb_image_clear(&rows);
    fmb_mem_put(run->mem, line, h->rows, sizeof *line);
    return st;
}

/* ---- double description ---------------------------------------------------------------------- */

typedef struct sorted_row {
    fmb_cone_row row;
    size_t d;
} sorted_row;

/* Equalities first, then lexicographically. */
static int compare_rows(const void *x, const void *y)
{
    const sorted_row *a = x, *b = y;
    if (a->row.equality != b->row.equality)
        return a->row.equality ? -1 : 1;
    return fmb_vec_compare(a->row.v, b->row.v, a->d);
}

static fmb_status sort_rows(const fmb_lifted *h, fmb_cone_row *row)
{
    fmb_mem *mem = h->q->run.mem;
    sorted_row *list = fmb_mem_get(mem, h->rows, sizeof *list);
    if (!list)
        return fmb_mem_status(mem);
    for (size_t i = 0; i < h->rows; i++)
        list[i] = (sorted_row){h->row[i], h->d};
    qsort(list, h->rows, sizeof *list, compare_rows);
    for (size_t i = 0; i < h->rows; i++)
        row[i] = list[i].row;
    fmb_mem_put(mem, list, h->rows, sizeof *list);
    return FMB_OK;
}

/* Go on until that many more rays were made (0: any number); those alive count as rows. */
static fmb_status run_cone(fmb_cone *c, uint64_t rays, bool *done)
{
    uint64_t most = rays > 0 ? c->made + rays : UINT64_MAX;
    fmb_status st = FMB_OK;
    for (*done = false; st == FMB_OK && !*done && c->made < most;) {
        st = fmb_cone_run(c, RAYS_AT_A_TIME, done);
        if (st == FMB_OK)
            st = fmb_run_rows(c->run, c->ray.size);
    }
    return st;
}

/* Do all inequalities but t >= 0 have as many coefficients? */
static bool do_rows_look_alike(const fmb_cone *c)
{
    size_t seen = 0;
    for (size_t i = 1; i < c->of.m; i++) {
        if (c->of.row[i].equality)
            continue;
        if (seen > 0 && c->weight[i] != seen)
            return false;
        seen = c->weight[i];
    }
    return true;
}

/* The rows in another order. */
typedef struct sorted_cone {
    fmb_cone cone;
    fmb_cone_row *row; /* [rows] */
} sorted_cone;

static fmb_status open_sorted_cone(sorted_cone *s, const fmb_lifted *h)
{
    s->row = fmb_mem_get(h->q->run.mem, h->rows, sizeof *s->row);
    fmb_status st = s->row ? sort_rows(h, s->row) : fmb_mem_status(h->q->run.mem);
    fmb_cone_problem of = {
        .d = h->d, .m = h->rows, .row = s->row, .wide_only = fmb_query_is_wide(h->q)};
    return st == FMB_OK ? fmb_cone_init(&s->cone, &h->q->run, &of) : st;
}

static void close_sorted_cone(sorted_cone *s, const fmb_lifted *h)
{
    fmb_cone_clear(&s->cone);
    fmb_mem_put(h->q->run.mem, s->row, h->rows, sizeof *s->row);
    *s = (sorted_cone){0};
}

/* Turns of 512 and 4,096 rays, the other order twice as many. *done: by one of them, and h->image
 * has the rays. */
static fmb_status run_in_turns(fmb_lifted *h, bool *done)
{
    sorted_cone s = {0};
    const fmb_cone *complete = &h->cone;
    fmb_status st = open_sorted_cone(&s, h);
    for (uint64_t rays = FIRST_RAYS; st == FMB_OK && !*done && rays <= LAST_RAYS; rays *= 8) {
        st = run_cone(&h->cone, rays, done);
        if (st == FMB_OK && !*done) {
            st = run_cone(&s.cone, 2 * rays, done);
            complete = *done ? &s.cone : complete;
        }
    }
    if (st == FMB_OK && *done)
        st = fmb_image_init(&h->image, &h->q->run, complete, fmb_query_is_wide(h->q));
    h->image.of = NULL;
    close_sorted_cone(&s, h);
    return st;
}

static fmb_status find_rays_row_by_row(fmb_lifted *h)
{
    bool done = false;
    fmb_status st = FMB_OK;
    if (h->rows >= MANY_ROWS * h->d && do_rows_look_alike(&h->cone))
        st = run_in_turns(h, &done);
    if (st != FMB_OK || done)
        return st;
    st = run_cone(&h->cone, 0, &done);
    return st == FMB_OK ? fmb_image_init(&h->image, &h->q->run, &h->cone, fmb_query_is_wide(h->q))
                        : st;
}

fmb_status fmb_lifted_find_rays(fmb_lifted *h)
{
    return h->d <= FEW_COORDINATES && h->rows >= MANY_ROWS * h->d ? find_rays_as_facets(h)
                                                                  : find_rays_row_by_row(h);
}
