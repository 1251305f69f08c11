/* generate_rays.c: the choice of an algorithm for rays; see some_rays.h.
 *
 * - Few coordinates and many rows: rows are generators of the dual cone, whose facets are the rays.
 *   The incremental hull keeps facets with their neighbours (hull/facets/facets.h). With a few more
 *   coordinates that is cheaper only where numbers grow long, as facets are kept in doubles most of
 *   the time, or where there are very many rows, most of which lie behind a facet at once; and
 *   where few rows meet in a vertex.
 * - Else double description (dd/cone.h), rows of few coefficients first. For many rows that look
 *   alike, its insertion order can be arbitrarily bad: for the rows of a cross-polytope it inserts
 *   those that cut most, with millions of intermediate rays where the lexicographic order has
 *   hundreds. So the lexicographic order gets turns: the first ones where rows have a pattern, that
 *   is where each agrees with its predecessor in most entries.
 */
#include "solve/generate/some_rays.h"

#include <stdlib.h>

#include "hull/facets/facets.h"

/* Up to so many coordinates, t included, the incremental hull is cheaper (measured: 2 to 4 times
 * with 4 or 5, half as fast with 7) ... */
#define FEW_COORDINATES 6
/* ... with so many rows per coordinate; with one coordinate more, VERY_MANY_ROWS of them. */
#define MANY_ROWS      4
#define VERY_MANY_ROWS 32
/* Rays with such a Hadamard bound [bits] mostly do not fit into 62 bits (measured). */
#define LONG_BITS 72
/* Rays of the first turn and the last one of two orders. */
#define FIRST_RAYS 512
#define LAST_RAYS  4096
/* Rays between two checks of options.max_rows, also where there is no limit. */
#define RAYS_AT_A_TIME 512
#define RAYS_AT_ONCE   65536

/* ---- rows in order --------------------------------------------------------------------------- */

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
    sorted_row *list;
    FMB_TRY(FMB_GET(mem, list, h->rows.size));
    for (size_t i = 0; i < h->rows.size; i++)
        list[i] = (sorted_row){h->rows.row[i], h->d};
    qsort(list, h->rows.size, sizeof *list, compare_rows);
    for (size_t i = 0; i < h->rows.size; i++)
        row[i] = list[i].row;
    fmb_mem_put(mem, list, h->rows.size, sizeof *list);
    return FMB_OK;
}

/* Do sorted rows agree with their predecessors in half of their leading entries, on average? */
static bool have_rows_a_pattern(const fmb_lifted *h, const fmb_cone_row *sorted)
{
    size_t shared = 0;
    for (size_t i = 1; i < h->rows.size; i++)
        for (size_t k = 0; k < h->d && fmb_vec_compare(sorted[i - 1].v, sorted[i].v, k + 1) == 0;
             k++)
            shared++;
    return 2 * shared >= h->d * h->rows.size;
}

/* ---- rows as vectors ------------------------------------------------------------------------- */

static fmb_status find_rays_as_facets(fmb_lifted *h)
{
    fmb_run *run = &h->q->run;
    bool wide = fmb_query_is_wide(h->q);
    fmb_image rows = {0};
    bool *line;
    FMB_TRY(FMB_GET(run->mem, line, h->rows.size));
    for (size_t i = 0; i < h->rows.size; i++)
        line[i] = h->rows.row[i].equality;
    fmb_status st = fmb_image_init_vectors(&rows, run, h->d, h->rows.size, h->rows.v, line, wide);
    FMB_THEN(st, fmb_image_init_dual(&h->image, &rows));
    fmb_image_clear(&rows);
    fmb_mem_put(run->mem, line, h->rows.size, sizeof *line);
    return st;
}

/* ---- double description ---------------------------------------------------------------------- */

/* Continue until so many more rays were made (0: any number); live rays count as rows. */
static fmb_status run_cone(fmb_cone *c, uint64_t rays, bool *done)
{
    uint64_t most = rays > 0 ? c->made + rays : UINT64_MAX;
    uint64_t step = c->run->max_rows > 0 ? RAYS_AT_A_TIME : RAYS_AT_ONCE;
    for (*done = false; !*done && c->made < most;) {
        FMB_TRY(fmb_cone_run(c, step < most - c->made ? step : most - c->made, done));
        FMB_TRY(fmb_run_rows(c->run, c->ray.size));
    }
    return FMB_OK;
}

/* Do all inequalities but t >= 0 have the same number of coefficients? */
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

/* Two orders in turns of 512 and 4,096 rays: the lexicographic one gets twice as many, and four
 * times as many where it comes first. *done: one of them ended, and h->image has the rays. */
static fmb_status run_in_turns(fmb_lifted *h, const fmb_cone_row *sorted, bool *done)
{
    fmb_cone lexicographic = {0};
    fmb_cone_problem of = {
        .d = h->d, .m = h->rows.size, .row = sorted, .wide_only = fmb_query_is_wide(h->q)};
    bool first = have_rows_a_pattern(h, sorted);
    fmb_cone *turn[2] = {first ? &lexicographic : &h->cone, first ? &h->cone : &lexicographic};
    const uint64_t share[2] = {first ? 4 : 1, first ? 1 : 2};
    fmb_status st = fmb_cone_init(&lexicographic, &h->q->run, &of);
    for (uint64_t rays = FIRST_RAYS; st == FMB_OK && !*done && rays <= LAST_RAYS; rays *= 8)
        for (int k = 0; st == FMB_OK && !*done && k < 2; k++) {
            st = run_cone(turn[k], share[k] * rays, done);
            if (st == FMB_OK && *done)
                st = fmb_image_init(&h->image, &h->q->run, turn[k], h->d, fmb_query_is_wide(h->q));
        }
    h->image.of = NULL;
    fmb_cone_clear(&lexicographic);
    return st;
}

static fmb_status find_rays_row_by_row(fmb_lifted *h, const fmb_cone_row *sorted)
{
    bool done = false;
    if (sorted && do_rows_look_alike(&h->cone))
        FMB_TRY(run_in_turns(h, sorted, &done));
    if (done)
        return FMB_OK;
    FMB_TRY(run_cone(&h->cone, 0, &done));
    return fmb_image_init(&h->image, &h->q->run, &h->cone, h->d, fmb_query_is_wide(h->q));
}

/* ---- the way --------------------------------------------------------------------------------- */

/* Does the origin satisfy all inequalities? Then they are points of the polar polytope, and the
 * farthest of these points are vertices of their hull. */
static bool is_origin_inside(const fmb_lifted *h)
{
    for (size_t i = 0; i < h->rows.size; i++)
        if (!h->rows.row[i].equality && fmb_vec_sgn(&h->rows.v[i], h->d - 1) < 0)
            return false;
    return true;
}

/* Is the incremental hull cheaper, with more than a few coordinates? */
static bool are_facets_cheaper(const fmb_lifted *h, const fmb_cone_row *sorted)
{
    bool many = h->rows.size >= VERY_MANY_ROWS * h->d && is_origin_inside(h);
    return h->d <= FMB_FACETS_FEW &&
           (many || fmb_vec_minor_bits(h->rows.v, h->rows.size, h->d) > LONG_BITS) &&
           !have_rows_a_pattern(h, sorted);
}

/* sorted: the order of insertion; NULL: the cone's default. */
static fmb_status find_rays(fmb_lifted *h, const fmb_cone_row *sorted, bool facets)
{
    const fmb_attempt a = {.engine = facets ? "hull of the polar" : "double description",
                           .task = "rays",
                           .part = -1,
                           .columns = h->d,
                           .rows = h->rows.size};
    fmb_status st = facets ? find_rays_as_facets(h) : find_rays_row_by_row(h, sorted);
    fmb_run_tell_attempt(&h->q->run, a, st, true);
    return st;
}

fmb_status fmb_lifted_find_rays(fmb_lifted *h)
{
    fmb_mem *mem = h->q->run.mem;
    if (h->rows.size < MANY_ROWS * h->d)
        return find_rays(h, NULL, false);
    if (h->d <= FEW_COORDINATES)
        return find_rays(h, NULL, true);
    fmb_cone_row *sorted = fmb_mem_get(mem, h->rows.size, sizeof *sorted);
    fmb_status st = sorted ? sort_rows(h, sorted) : fmb_mem_status(mem);
    FMB_THEN(st, find_rays(h, sorted, are_facets_cheaper(h, sorted)));
    fmb_mem_put(mem, sorted, h->rows.size, sizeof *sorted);
    return st;
}
