/* membership_ask.c: see membership.h.
 *
 * Each point j allows w the half-space w.q_j <= 1; a basis is n points whose hyperplanes meet in
 * the vertex w, and the rows of its inverse, turned round, are the edges there. For a new q the
 * dual method walks from vertex to vertex, always up: along the edge that rises most for its length
 * (steepest edge: Goldfarb and Reid 1977, Forrest and Goldfarb 1992), until the next hyperplane. A
 * vertex above 1 is answer enough, and so is one from where no edge rises. A point that is added
 * may cut the vertex off: the primal method then finds one that is left, the highest in a direction
 * that the old one was highest in.
 */
#include "lp/redundancy/ray_shooting/membership_private.h"

#include <string.h>

/* Pivots after which errors have gathered. */
#define STALE 64
/* Room for hull points at first. */
#define FIRST_POINTS 64

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status reserve_hull_points(fmb_membership *g, size_t capacity);

fmb_status fmb_membership_init(fmb_membership *g, fmb_mem *mem, const fmb_kernels *kernels,
                               size_t n, double cube)
{
    *g = (fmb_membership){
        .mem = mem, .kernels = kernels, .n = n, .cube = cube, .zero = FMB_MEMBERSHIP_ROUNDING};
    g->basic = fmb_mem_get(mem, n, sizeof *g->basic);
    g->inverse = fmb_mem_get(mem, n * n, sizeof *g->inverse);
    g->length = fmb_mem_get(mem, n, sizeof *g->length);
    g->value = fmb_mem_get(mem, n, sizeof *g->value);
    g->w = fmb_mem_get(mem, n, sizeof *g->w);
    g->entry = fmb_mem_get(mem, n, sizeof *g->entry);
    g->work = fmb_mem_get(mem, 2 * n * n, sizeof *g->work);
    if (!g->basic || !g->inverse || !g->length || !g->value || !g->w || !g->entry || !g->work)
        return fmb_mem_status(mem);
    fmb_status st = reserve_hull_points(g, FIRST_POINTS);
    if (st == FMB_OK)
        fmb_membership_start_from_cube(g, NULL);
    return st;
}

static void free_hull_points(fmb_membership *g)
{
    fmb_mem_put(g->mem, g->at, g->n * g->capacity, sizeof *g->at);
    fmb_mem_put(g->mem, g->name, g->capacity, sizeof *g->name);
    fmb_mem_put(g->mem, g->reduced, g->capacity, sizeof *g->reduced);
    fmb_mem_put(g->mem, g->along, g->capacity, sizeof *g->along);
}

void fmb_membership_clear(fmb_membership *g)
{
    size_t n = g->n;
    if (!g->mem)
        return;
    free_hull_points(g);
    fmb_mem_put(g->mem, g->basic, n, sizeof *g->basic);
    fmb_mem_put(g->mem, g->inverse, n * n, sizeof *g->inverse);
    fmb_mem_put(g->mem, g->length, n, sizeof *g->length);
    fmb_mem_put(g->mem, g->value, n, sizeof *g->value);
    fmb_mem_put(g->mem, g->w, n, sizeof *g->w);
    fmb_mem_put(g->mem, g->entry, n, sizeof *g->entry);
    fmb_mem_put(g->mem, g->work, 2 * n * n, sizeof *g->work);
    g->mem = NULL;
}

/* Points lie by coordinate, so each coordinate moves. */
static fmb_status reserve_hull_points(fmb_membership *g, size_t capacity)
{
    fmb_membership old = *g;
    g->capacity = capacity;
    g->at = fmb_mem_get(g->mem, g->n * capacity, sizeof *g->at);
    g->name = fmb_mem_get(g->mem, capacity, sizeof *g->name);
    g->reduced = fmb_mem_get(g->mem, capacity, sizeof *g->reduced);
    g->along = fmb_mem_get(g->mem, capacity, sizeof *g->along);
    if (!g->at || !g->name || !g->reduced || !g->along) {
        fmb_status st = fmb_mem_status(g->mem);
        free_hull_points(g);
        *g = old;
        return st;
    }
    for (size_t k = 0; old.size > 0 && k < g->n; k++)
        memcpy(&g->at[k * capacity], &old.at[k * old.capacity], old.size * sizeof *g->at);
    if (old.size > 0) {
        memcpy(g->name, old.name, old.size * sizeof *g->name);
        memcpy(g->reduced, old.reduced, old.size * sizeof *g->reduced);
    }
    free_hull_points(&old);
    return FMB_OK;
}

/* ---- questions ------------------------------------------------------------------------------- */

fmb_status fmb_membership_add(fmb_membership *g, const double *q, size_t name)
{
    fmb_status st = FMB_OK;
    if (g->size == g->capacity)
        st = reserve_hull_points(g, 2 * g->capacity);
    if (st != FMB_OK)
        return st;
    for (size_t k = 0; k < g->n; k++)
        g->at[k * g->capacity + g->size] = q[k];
    g->name[g->size] = name;
    g->size++;
    fmb_membership_reduce_points(g, g->size - 1);
    return FMB_OK;
}

void fmb_membership_forget(fmb_membership *g)
{
    size_t left = 0;
    for (size_t j = 0; j < g->size; j++)
        g->along[j] = 0;
    for (size_t r = 0; r < g->n; r++)
        if (!fmb_membership_is_artificial(g->basic[r]))
            g->along[g->basic[r]] = 1;
    for (size_t j = 0; j < g->size; j++) {
        if (g->along[j] == 0)
            continue;
        for (size_t k = 0; k < g->n; k++)
            g->at[k * g->capacity + left] = g->at[k * g->capacity + j];
        for (size_t r = 0; r < g->n; r++)
            if (g->basic[r] == j)
                g->basic[r] = left;
        g->name[left++] = g->name[j];
    }
    g->size = left;
    fmb_membership_reduce_points(g, 0);
}

void fmb_membership_resize_cube(fmb_membership *g, double cube)
{
    g->cube = cube;
    fmb_membership_start_from_cube(g, NULL);
}

/* Once more from the cube if the search is stuck: errors may have gathered. */
fmb_status fmb_membership_ask(fmb_membership *g, const double *q, fmb_run *run,
                              fmb_side_of_hull *out)
{
    fmb_status st = FMB_OK;
    *out = FMB_HULL_NONE;
    for (int tries = 0; st == FMB_OK && *out == FMB_HULL_NONE && tries < 2; tries++) {
        bool done;
        if (tries > 0)
            fmb_membership_start_from_cube(g, q);
        else if (g->pivots > STALE)
            fmb_membership_refresh(g);
        st = fmb_membership_run_primal(g, run, &done);
        if (st == FMB_OK && done)
            st = fmb_membership_run_dual(g, q, run, out);
    }
    return st;
}
