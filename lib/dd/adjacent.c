/* adjacent.c: adjacency of extreme rays; see adjacent.h.
 *
 * Simple rays find each other by their edges (edges.h) if that is cheaper than a test of all pairs;
 * for other neighbours of a simple ray the size of a union decides. For two rays a and b that are
 * not simple, a third ray inside the union of their supports has as many zeros in common with a as
 * b has. So it is looked for among the few such rays only, which are listed when the first pair of
 * a needs them.
 */
#include "dd/adjacent.h"
#include "base/arrays.h"
#include "base/ways.h"

#include <string.h>

void fmb_adjacency_clear(fmb_adjacency *p, fmb_mem *mem)
{
    FMB_ARRAYS_PUT(mem, FMB_ARRAY(p->near.word, p->near.capacity),
                   FMB_ARRAY(p->far, p->far_capacity), FMB_ARRAY(p->far_rest, p->far_rest_capacity),
                   FMB_ARRAY(p->nearby, p->nearby_capacity), FMB_ARRAY(p->joint, p->joint_capacity),
                   FMB_ARRAY(p->found, p->found_capacity));
}

/* ---- planes ---------------------------------------------------------------------------------- */

static fmb_status gather_supports(const fmb_cone *c, fmb_mem *mem, fmb_support_planes *s,
                                  const uint32_t *ray, size_t count)
{
    size_t words = c->ray.words, stride = (count + 7) / 8 * 8;
    FMB_TRY(FMB_RESERVE(mem, &s->word, &s->capacity, words * stride));
    for (size_t j = 0; j < count; j++) {
        const uint64_t *from = fmb_rays_support(&c->ray, ray[j]);
        for (size_t k = 0; k < words; k++)
            s->word[k * stride + j] = from[k];
    }
    for (size_t k = 0; k < words && stride > count; k++)
        memset(&s->word[k * stride + count], 0, (stride - count) * sizeof *s->word);
    s->planes = (fmb_planes){s->word, stride, words, count};
    s->ready = true;
    return FMB_OK;
}

/* Set the bits of the sets whose union with a has more than `most` elements. */
static fmb_status mark_far_supports(fmb_run *run, const fmb_support_planes *s, const uint64_t *a,
                                    size_t most, uint64_t **far, size_t *capacity)
{
    size_t words = s->planes.stride / 64 + 1;
    FMB_TRY(FMB_RESERVE(run->mem, far, capacity, words));
    memset(*far, 0, words * sizeof **far);
    fmb_run_count(run, s->planes.count * s->planes.words / 4);
    run->kernels->larger(&s->planes, a, (int)most, *far);
    return FMB_OK;
}

/* ---- a third ray ----------------------------------------------------------------------------- */

static size_t list_unmarked_rays(const uint64_t *far, const uint32_t *ray, size_t n, uint32_t *to,
                                 size_t at)
{
    for (size_t j = 0; j < n; j += 64) {
        uint64_t near = ~far[j / 64];
        if (n - j < 64)
            near &= ((uint64_t)1 << (n - j)) - 1;
        for (; near != 0; near &= near - 1)
            to[at++] = ray[j + (size_t)__builtin_ctzll(near)];
    }
    return at;
}

/* Gather all rays with enough zeros in common with a. */
static fmb_status gather_near_rays(fmb_cone *c, fmb_run *run, fmb_adjacency *p, uint32_t a,
                                   size_t most)
{
    const fmb_insertion *s = c->at;
    FMB_TRY(s->rest.ready ? FMB_OK : fmb_adjacency_gather_rest(c));
    FMB_TRY(FMB_RESERVE(run->mem, &p->nearby, &p->nearby_capacity, s->rays));
    FMB_TRY(mark_far_supports(run, &s->rest, fmb_rays_support(&c->ray, a), most, &p->far_rest,
                              &p->far_rest_capacity));
    size_t n = list_unmarked_rays(p->far, s->ray, s->large, p->nearby, 0);
    n = list_unmarked_rays(p->far_rest, s->ray + s->large, s->small + s->zeros, p->nearby, n);
    return gather_supports(c, run->mem, &p->near, p->nearby, n);
}

/* Two supports inside the union are those of a and b; is there a third? */
static bool is_third_ray_between(const fmb_cone *c, const fmb_adjacency *p, uint32_t a, uint32_t b)
{
    const uint64_t *x = fmb_rays_support(&c->ray, a), *y = fmb_rays_support(&c->ray, b);
    for (size_t k = 0; k < c->ray.words; k++)
        p->joint[k] = x[k] | y[k];
    return c->run->kernels->inside(&p->near.planes, p->joint, 3) >= 3;
}

/* ---- pairs ----------------------------------------------------------------------------------- */

fmb_edge_sides fmb_adjacency_sides(const fmb_cone *c)
{
    const fmb_insertion *s = c->at;
    return (fmb_edge_sides){.support = c->ray.support,
                            .words = c->ray.words,
                            .bits = c->bits,
                            .rank = c->rank,
                            .small = s->ray + s->large,
                            .large = s->ray,
                            .smalls = s->small,
                            .larges = s->large};
}

/* A ray of the larger side costs a test with each ray of the smaller one, or a hash of each edge,
 * which takes as long as so many words in a test (measured: 8 to 16). */
#define HASHED_EDGE 12

static bool do_edges_pay(const fmb_edge_sides *of)
{
    size_t simple = 0, degree = of->rank - 1;
    if (of->rank < 3 || of->smalls > UINT32_MAX / 2 / degree)
        return false;
    for (size_t i = 0; i < of->smalls; i++)
        simple += fmb_is_simple(of, of->small[i]);
    return simple * of->words > HASHED_EDGE * degree;
}

/* List the rays of the larger side that are not simple. */
static fmb_status list_crowded_rays(fmb_cone *c, const fmb_edge_sides *of)
{
    fmb_insertion *s = c->at;
    fmb_mem *mem = c->run->mem;
    FMB_TRY(FMB_RESERVE(mem, &s->crowded, &s->crowded_capacity, of->larges));
    s->crowds = 0;
    for (size_t j = 0; j < of->larges; j++)
        if (!fmb_is_simple(of, of->large[j]))
            s->crowded[s->crowds++] = of->large[j];
    return gather_supports(c, mem, &s->crowd, s->crowded, s->crowds);
}

fmb_status fmb_adjacency_begin(fmb_cone *c)
{
    fmb_insertion *s = c->at;
    fmb_edge_sides of = fmb_adjacency_sides(c);
    fmb_status st = gather_supports(c, c->run->mem, &s->large_side, s->ray, s->large);
    s->by_edges = do_edges_pay(&of) && fmb_way(FMB_WAY_EDGES);
    fmb_way_answered(FMB_WAY_EDGES, s->by_edges);
    return st == FMB_OK && s->by_edges ? list_crowded_rays(c, &of) : st;
}

fmb_status fmb_adjacency_gather_rest(fmb_cone *c)
{
    fmb_insertion *s = c->at;
    return gather_supports(c, c->run->mem, &s->rest, s->ray + s->large, s->small + s->zeros);
}

static fmb_status reserve_pairs(const fmb_cone *c, fmb_adjacency *p, fmb_mem *mem)
{
    FMB_TRY(FMB_RESERVE(mem, &p->joint, &p->joint_capacity, c->ray.words));
    return FMB_RESERVE(mem, &p->found, &p->found_capacity, c->at->large + c->rank);
}

/* Find the neighbours of simple ray number i: at its edges, and among rays that are not simple. */
static fmb_status find_by_edges(fmb_cone *c, fmb_run *run, fmb_adjacency *p, size_t i, size_t most)
{
    const fmb_insertion *s = c->at;
    const fmb_ray_edge *edge = s->edges.edge + i * s->edges.degree;
    uint32_t a = s->ray[s->large + i];
    FMB_TRY(mark_far_supports(run, &s->crowd, fmb_rays_support(&c->ray, a), most, &p->far,
                              &p->far_capacity));
    size_t n = list_unmarked_rays(p->far, s->crowded, s->crowds, p->found, 0);
    for (size_t k = 0; k < s->edges.degree; k++)
        if (edge[k].end != FMB_NO_RAY)
            p->found[n++] = edge[k].end;
    run->stats.pairs += s->crowds + n;
    p->founds = n;
    return FMB_OK;
}

/* Test all rays of the larger side. A single ray with many near rays may take long. */
static fmb_status find_by_unions(fmb_cone *c, fmb_run *run, fmb_adjacency *p, uint32_t a,
                                 size_t most)
{
    const fmb_insertion *s = c->at;
    fmb_edge_sides of = fmb_adjacency_sides(c);
    bool simple = fmb_is_simple(&of, a);
    fmb_status st = mark_far_supports(run, &s->large_side, fmb_rays_support(&c->ray, a), most,
                                      &p->far, &p->far_capacity);
    p->near.ready = false;
    size_t near = st == FMB_OK ? list_unmarked_rays(p->far, s->ray, s->large, p->found, 0) : 0;
    run->stats.pairs += s->large;
    for (size_t k = 0; st == FMB_OK && k < near; k++) {
        uint32_t b = p->found[k];
        bool adjacent = simple || fmb_is_simple(&of, b);
        if (!adjacent && !p->near.ready)
            st = gather_near_rays(c, run, p, a, most);
        if (!adjacent) {
            fmb_run_count(run, 20 + p->near.planes.count * p->near.planes.words / 8);
            st = st == FMB_OK ? fmb_run_poll(run) : st;
        }
        if (adjacent || (st == FMB_OK && !is_third_ray_between(c, p, a, b)))
            p->found[p->founds++] = b;
    }
    return st;
}

fmb_status fmb_find_adjacent(fmb_cone *c, fmb_run *run, fmb_adjacency *p, size_t i)
{
    const fmb_insertion *s = c->at;
    fmb_edge_sides of = fmb_adjacency_sides(c);
    uint32_t a = s->ray[s->large + i];
    size_t most = c->bits + 2 - c->rank; /* of a union: rank - 2 zeros are shared */
    fmb_status st = reserve_pairs(c, p, run->mem);
    p->founds = 0;
    if (st != FMB_OK)
        return st;
    return s->by_edges && fmb_is_simple(&of, a) ? find_by_edges(c, run, p, i, most)
                                                : find_by_unions(c, run, p, a, most);
}
