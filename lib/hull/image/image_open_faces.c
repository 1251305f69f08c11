/* image_open_faces.c: faces of an image that strict rows exclude; see image.h.
 *
 * A relative interior point of a face F is in the projection iff some point above it satisfies
 * every strict row; by convexity, iff each strict row is positive at some point above it; so, as
 * some of these are relative interior points of the preimage of F, iff each is positive on some ray
 * above F. Hence row s excludes F iff N contains no ray on F, N being the rays with s in their
 * support.
 *
 * Faces are intersections of facets: to each ray of N that is still on the face, one of the facets
 * without it is added, in all possible ways. Faces of strict facets are excluded anyway, and faces
 * of directions alone contain no points; of the others, the maximal ones need rows.
 */
#include <string.h>

#include "hull/image/image.h"
#include "num/bitset.h"

/* Most faces visited before the search is given up. */
#define MOST_STEPS 20000

/* A face, as the set of rays on it. */
typedef struct open_face {
    uint64_t *on;
    size_t *facet; /* [facets] that meet in it */
    size_t facets;
} open_face;

typedef struct open_search {
    fmb_image *m;
    size_t words;      /* of a set of rays */
    size_t facets;     /* before rows are added */
    uint64_t **on;     /* [facets] rays on each */
    uint64_t *points;  /* rays with t > 0 */
    uint64_t *outside; /* rays where the current strict row is positive */
    uint64_t *stack;   /* [facets + 1] sets of rays */
    size_t *taken;     /* [facets] */
    size_t steps;
    open_face *face;
    size_t faces, capacity;
} open_search;

/* ---- sets of rays ---------------------------------------------------------------------------- */

static uint64_t *new_set_of_rays(open_search *o)
{
    uint64_t *set = fmb_arena_get(&o->m->arena, o->words, sizeof *set);
    if (set)
        memset(set, 0, o->words * sizeof *set);
    return set;
}

static fmb_status list_rays_on_facets(open_search *o)
{
    fmb_image *m = o->m;
    for (size_t f = 0; f < o->facets; f++)
        o->on[f] = m->facet[f].on;
    for (size_t i = 0; i < m->rays; i++)
        if (fmb_vec_sgn(&m->ray[i], m->n - 1) > 0)
            fmb_set_put(o->points, i);
    return fmb_run_poll(m->run);
}

static fmb_status start_search(open_search *o)
{
    fmb_arena *arena = &o->m->arena;
    o->words = fmb_set_words(o->m->rays);
    o->facets = o->m->facets;
    o->on = fmb_arena_get(arena, o->facets, sizeof *o->on);
    o->taken = fmb_arena_get(arena, o->facets, sizeof *o->taken);
    o->stack = fmb_arena_get(arena, (o->facets + 1) * o->words, sizeof *o->stack);
    o->points = new_set_of_rays(o);
    o->outside = new_set_of_rays(o);
    if (!o->on || !o->taken || !o->stack || !o->points || !o->outside)
        return fmb_mem_status(arena->mem);
    return list_rays_on_facets(o);
}

/* ---- the search ------------------------------------------------------------------------------ */

/* Note a face unless it is part of one found before; remove those that are part of it. */
static fmb_status note_open_face(open_search *o, const uint64_t *on, size_t depth)
{
    fmb_mem *mem = o->m->run->mem;
    size_t left = 0;
    for (size_t i = 0; i < o->faces; i++)
        if (fmb_set_is_inside(on, o->face[i].on, o->words))
            return FMB_OK;
    for (size_t i = 0; i < o->faces; i++)
        if (!fmb_set_is_inside(o->face[i].on, on, o->words))
            o->face[left++] = o->face[i];
    o->faces = left;
    FMB_TRY(FMB_RESERVE(mem, &o->face, &o->capacity, left + 1));
    open_face *f = &o->face[o->faces];
    *f = (open_face){.on = new_set_of_rays(o),
                     .facet = fmb_arena_get(&o->m->arena, depth, sizeof *f->facet),
                     .facets = depth};
    if (!f->on || !f->facet)
        return fmb_mem_status(mem);
    memcpy(f->on, on, o->words * sizeof *on);
    memcpy(f->facet, o->taken, depth * sizeof *f->facet);
    o->faces++;
    return FMB_OK;
}

static bool is_in_strict_facet(const open_search *o, const uint64_t *on)
{
    for (size_t f = 0; f < o->facets; f++)
        if (o->m->facet[f].strict && fmb_set_is_inside(on, o->on[f], o->words))
            return true;
    return false;
}

/* A ray of N that is still on the face. */
static size_t find_ray_outside(const open_search *o, const uint64_t *on)
{
    for (size_t k = 0; k < o->words; k++)
        if (on[k] & o->outside[k])
            return 64 * k + (size_t)__builtin_ctzll(on[k] & o->outside[k]);
    return SIZE_MAX;
}

static fmb_status search_open_faces(open_search *o, size_t depth)
{
    const uint64_t *on = o->stack + depth * o->words;
    if (++o->steps > MOST_STEPS || !fmb_sets_meet(on, o->points, o->words) ||
        is_in_strict_facet(o, on))
        return FMB_OK;
    size_t ray = find_ray_outside(o, on);
    if (ray == SIZE_MAX)
        return note_open_face(o, on, depth);
    FMB_TRY(fmb_run_poll(o->m->run));
    for (size_t f = 0; f < o->facets; f++) {
        const fmb_image_row *row = &o->m->facet[f];
        if (row->equality || row->strict || fmb_set_has(o->on[f], ray))
            continue;
        uint64_t *next = o->stack + (depth + 1) * o->words;
        for (size_t k = 0; k < o->words; k++)
            next[k] = on[k] & o->on[f][k];
        o->taken[depth] = f;
        FMB_TRY(search_open_faces(o, depth + 1));
    }
    return FMB_OK;
}

static fmb_status search_for_strict_row(open_search *o, size_t bit)
{
    fmb_image *m = o->m;
    if (fmb_set_has(m->everywhere, bit))
        return FMB_OK;
    memset(o->outside, 0, o->words * sizeof *o->outside);
    memset(o->stack, 0, o->words * sizeof *o->stack);
    for (size_t i = 0; i < m->rays; i++) {
        fmb_set_put(o->stack, i);
        if (fmb_set_has(m->support[i], bit))
            fmb_set_put(o->outside, i);
    }
    return search_open_faces(o, 0);
}

/* ---- rows ------------------------------------------------------------------------------------ */

static void open_facets(open_search *o, const uint64_t *excludes)
{
    for (size_t f = 0; f < o->facets; f++) {
        fmb_image_row *row = &o->m->facet[f];
        for (size_t k = 0; k < o->m->words; k++)
            row->strict |= !row->equality && (excludes[k] & ~row->slack[k]) != 0;
    }
}

static fmb_status sum_facets(open_search *o, const open_face *face, fmb_image_row *row)
{
    fmb_image *m = o->m;
    FMB_TRY(fmb_vec_widen(&row->v, m->n, m->run->mem));
    for (size_t i = 0; i < face->facets; i++)
        for (size_t k = 0; k < m->n; k++) {
            fmb_vec_get(&m->facet[face->facet[i]].v, k, m->num.t);
            mpz_add(row->v.z[k], row->v.z[k], m->num.t);
        }
    return fmb_vec_reduce(&row->v, m->n, &m->num);
}

static fmb_status add_row_of_face(open_search *o, const open_face *face)
{
    fmb_image *m = o->m;
    FMB_TRY(FMB_RESERVE(m->run->mem, &m->facet, &m->facet_capacity, m->facets + 1));
    fmb_image_row *row = &m->facet[m->facets];
    *row = (fmb_image_row){.strict = true};
    FMB_TRY(FMB_ARENA_GET(&m->arena, row->v.s, m->n));
    FMB_TRY(FMB_ARENA_GET(&m->arena, row->slack, m->words));
    memset(row->v.s, 0, m->n * sizeof *row->v.s);
    m->facets++;
    memcpy(row->slack, m->everywhere, m->words * sizeof *row->slack);
    for (size_t i = 0; i < m->rays; i++)
        for (size_t k = 0; fmb_set_has(face->on, i) && k < m->words; k++)
            row->slack[k] |= m->support[i][k];
    return sum_facets(o, face, row);
}

fmb_status fmb_image_open_faces(fmb_image *m, const uint64_t *excludes, bool *empty, bool *done)
{
    open_search o = {.m = m};
    fmb_status st = start_search(&o);
    *empty = false;
    if (st == FMB_OK)
        open_facets(&o, excludes);
    for (size_t b = 0; st == FMB_OK && b < m->of->bits; b++)
        if (fmb_set_has(excludes, b))
            st = search_for_strict_row(&o, b);
    for (size_t i = 0; st == FMB_OK && i < o.faces; i++) {
        *empty |= o.face[i].facets == 0;
        if (!*empty)
            st = add_row_of_face(&o, &o.face[i]);
    }
    *done = o.steps <= MOST_STEPS;
    fmb_mem_put(m->run->mem, o.face, o.capacity, sizeof *o.face);
    return st;
}
