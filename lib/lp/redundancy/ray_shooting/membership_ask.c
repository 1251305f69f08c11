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

/* Pivots after which errors have gathered. */
#define STALE 64
/* Room for points at first. */
#define FIRST_POINTS 64

fmb_status fmb_membership_init(fmb_membership *g, fmb_mem *mem, const fmb_kernels *kernels,
                               size_t n, double cube)
{
    *g = (fmb_membership){.n = n, .cube = cube, .zero = FMB_MEMBERSHIP_ROUNDING};
    fmb_status st = fmb_basis_init(&g->basis, mem, kernels, n);
    if (st == FMB_OK)
        st = fmb_basis_reserve(&g->basis, FIRST_POINTS);
    if (st == FMB_OK)
        st = fmb_mem_reserve(mem, (void **)&g->reduced, &g->reduced_room, FIRST_POINTS,
                             sizeof *g->reduced);
    g->length = fmb_mem_get(mem, n, sizeof *g->length);
    g->w = fmb_mem_get(mem, n, sizeof *g->w);
    if (st == FMB_OK && (!g->length || !g->w))
        st = fmb_mem_status(mem);
    if (st == FMB_OK)
        fmb_membership_start_from_cube(g, NULL);
    return st;
}

void fmb_membership_clear(fmb_membership *g)
{
    fmb_mem *mem = g->basis.mem;
    if (!mem)
        return;
    fmb_mem_put(mem, g->name, g->name_room, sizeof *g->name);
    fmb_mem_put(mem, g->reduced, g->reduced_room, sizeof *g->reduced);
    fmb_mem_put(mem, g->length, g->n, sizeof *g->length);
    fmb_mem_put(mem, g->w, g->n, sizeof *g->w);
    fmb_basis_clear(&g->basis);
    g->basis.mem = NULL;
}

/* ---- questions ------------------------------------------------------------------------------- */

fmb_status fmb_membership_add(fmb_membership *g, const double *q, size_t name)
{
    fmb_mem *mem = g->basis.mem;
    size_t j = g->basis.size;
    fmb_status st = fmb_mem_reserve(mem, (void **)&g->name, &g->name_room, j + 1, sizeof *g->name);
    if (st == FMB_OK)
        st =
            fmb_mem_reserve(mem, (void **)&g->reduced, &g->reduced_room, j + 1, sizeof *g->reduced);
    if (st == FMB_OK)
        st = fmb_basis_add(&g->basis, q, FMB_RANGE_UP);
    if (st != FMB_OK)
        return st;
    g->name[j] = name;
    fmb_membership_reduce_points(g, j);
    return FMB_OK;
}

void fmb_membership_forget(fmb_membership *g)
{
    size_t left = 0;
    for (size_t j = 0; j < g->basis.size; j++)
        g->basis.price[j] = 0;
    for (size_t r = 0; r < g->n; r++)
        if (!fmb_membership_is_artificial(g->basis.basic[r]))
            g->basis.price[g->basis.basic[r]] = 1;
    for (size_t j = 0; j < g->basis.size; j++) {
        if (g->basis.price[j] == 0)
            continue;
        for (size_t k = 0; k < g->n; k++)
            g->basis.at[k * g->basis.capacity + left] = g->basis.at[k * g->basis.capacity + j];
        for (size_t r = 0; r < g->n; r++)
            if (g->basis.basic[r] == j)
                g->basis.basic[r] = left;
        g->name[left++] = g->name[j];
    }
    g->basis.size = left;
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
        else if (g->basis.pivots > STALE)
            fmb_membership_refresh(g);
        st = fmb_membership_run_primal(g, run, &done);
        if (st == FMB_OK && done)
            st = fmb_membership_run_dual(g, q, run, out);
    }
    return st;
}
