/* membership.c: see membership.h.
 *
 * The least sum of z >= 0 with sum_j z_j q_j = q is a program in columns (simplex.h), and w are its
 * prices: each point j restricts w to the half-space w.q_j <= 1, and a basis is n points whose
 * hyperplanes meet in the vertex w. For a new q the dual method goes from vertex to vertex, always
 * upwards, until the sum is above 1 or no value is negative. A new point may cut off the vertex:
 * then the primal method finds a remaining one, the highest in a direction for which the old one
 * was highest.
 */
#include "lp/redundancy/ray_shooting/membership.h"

#include <math.h>
#include <string.h>

/* Smaller numbers count as rounding errors of 0: points and w are not longer than about 1. */
#define ROUNDING 1e-9
/* Least pivot, if edges have length 1. */
#define LEAST_PIVOT 1e-8
/* Least slope that is no rounding error, likewise. */
#define LEAST_SLOPE 1e-6
/* Initial capacity for points. */
#define FIRST_POINTS 64

/* ---- life ------------------------------------------------------------------------------------ */

/* Start from the corner of the cube on the side of q, or from any (q NULL). */
static void start_from_cube(fmb_membership *g, const double *q)
{
    for (size_t k = 0; k < g->n; k++)
        g->basis.is_mirrored[k] = q && q[k] < 0;
    g->basis.unit_cost = -g->cube;
    fmb_basis_empty(&g->basis);
    fmb_simplex_measure(&g->basis);
    g->is_broken = true;
}

fmb_status fmb_membership_init(fmb_membership *g, fmb_mem *mem, const fmb_kernels *kernels,
                               size_t n, double cube)
{
    *g = (fmb_membership){.n = n, .cube = cube, .zero = ROUNDING};
    fmb_status st = fmb_basis_init(&g->basis, mem, kernels, n);
    g->basis.entry_zero = LEAST_PIVOT;
    g->basis.has_cost = true;
    g->basis.enough = -1 - ROUNDING;
    g->w = fmb_mem_get(mem, n, sizeof *g->w);
    g->way = fmb_mem_get(mem, n, sizeof *g->way);
    if (st == FMB_OK && (!g->w || !g->way))
        st = fmb_mem_status(mem);
    FMB_THEN(st, fmb_basis_reserve(&g->basis, FIRST_POINTS));
    if (st == FMB_OK)
        start_from_cube(g, NULL);
    return st;
}

void fmb_membership_clear(fmb_membership *g)
{
    fmb_mem *mem = g->basis.mem;
    if (!mem)
        return;
    fmb_mem_put(mem, g->name, g->name_room, sizeof *g->name);
    fmb_mem_put(mem, g->w, g->n, sizeof *g->w);
    fmb_mem_put(mem, g->way, g->n, sizeof *g->way);
    fmb_basis_clear(&g->basis);
    g->basis.mem = NULL;
}

void fmb_membership_resize_cube(fmb_membership *g, double cube)
{
    g->cube = cube;
    start_from_cube(g, NULL);
}

/* ---- points ---------------------------------------------------------------------------------- */

/* w = the common point of all basic hyperplanes, w.q_j = 1. */
static void find_vertex(fmb_membership *g)
{
    fmb_simplex_find_prices(&g->basis, g->basis.cost, g->w);
    for (size_t k = 0; k < g->n; k++)
        g->way[k] = g->w[k] = -g->w[k];
}

/* Go from the vertex along the edge that no hyperplane stops, until q is outside; false if the
 * slope may be a rounding error. */
static bool goes_beyond(fmb_membership *g, const double *q)
{
    const double *normal = g->basis.normal;
    double slope = 0, height = 0, square = 0;
    for (size_t k = 0; k < g->n; k++) {
        slope -= normal[k] * q[k];
        square += normal[k] * normal[k];
        height += g->w[k] * q[k];
    }
    for (size_t k = 0; k < g->n; k++)
        g->way[k] -= (2 - height) / slope * normal[k];
    return slope > LEAST_SLOPE * sqrt(square);
}

fmb_status fmb_membership_add(fmb_membership *g, const double *q, size_t name)
{
    fmb_basis *b = &g->basis;
    size_t j = b->size;
    FMB_TRY(FMB_RESERVE(b->mem, &g->name, &g->name_room, j + 1));
    FMB_TRY(fmb_basis_add(b, q, FMB_RANGE_UP));
    g->name[j] = name;
    b->cost[j] = b->gain[j] = -1;
    for (size_t k = 0; k < g->n; k++)
        b->gain[j] += g->w[k] * q[k];
    g->is_broken = g->is_broken || b->gain[j] > ROUNDING;
    return FMB_OK;
}

static void move_column(fmb_membership *g, size_t from, size_t to)
{
    fmb_basis *b = &g->basis;
    for (size_t k = 0; k < g->n; k++)
        b->at[k * b->capacity + to] = b->at[k * b->capacity + from];
    for (size_t r = 0; r < g->n; r++)
        if (b->basic[r] == from)
            b->basic[r] = to;
    b->is_basic[to] = b->is_basic[from];
    b->cost[to] = b->cost[from];
    b->gain[to] = b->gain[from];
    g->name[to] = g->name[from];
}

void fmb_membership_forget(fmb_membership *g)
{
    size_t left = 0;
    for (size_t j = 0; j < g->basis.size; j++)
        if (g->basis.is_basic[j])
            move_column(g, j, left++);
    g->basis.size = left;
}

/* ---- questions ------------------------------------------------------------------------------- */

/* Choose a target for which the vertex is highest, a sum of all basic points with distinct factors,
 * and go from there to a vertex behind all hyperplanes. False: the search was stuck. */
static bool go_behind_points(fmb_membership *g)
{
    fmb_basis *b = &g->basis;
    uint32_t h = 1;
    memset(g->way, 0, g->n * sizeof *g->way);
    for (size_t r = 0; r < g->n; r++) {
        h = h * 1664525u + 1013904223u;
        b->value[r] = 1 + (double)(h >> 8) / (1 << 24);
        if (b->basic[r] == SIZE_MAX)
            g->way[r] += b->is_mirrored[r] ? -b->value[r] : b->value[r];
        for (size_t k = 0; b->basic[r] != SIZE_MAX && k < g->n; k++)
            g->way[k] += b->value[r] * b->at[k * b->capacity + b->basic[r]];
    }
    b->value_zero = ROUNDING;
    bool done = fmb_simplex_maximize(b, g->way, b->cost, g->w);
    fmb_simplex_measure(b);
    g->is_broken = !done;
    return done;
}

/* If the search is stuck, restart from the cube: errors may have accumulated. */
fmb_status fmb_membership_ask(fmb_membership *g, const double *q, fmb_run *run,
                              fmb_side_of_hull *out)
{
    fmb_status st = FMB_OK;
    fmb_guess guess = FMB_GUESS_NONE;
    *out = FMB_HULL_NONE;
    for (int tries = 0; st == FMB_OK && *out == FMB_HULL_NONE && tries < 2; tries++) {
        if (tries > 0)
            start_from_cube(g, q);
        if (g->is_broken && !go_behind_points(g))
            continue;
        g->basis.value_zero = g->zero;
        st = fmb_simplex_search(&g->basis, q, SIZE_MAX, run, &guess);
        if (guess != FMB_GUESS_NONE)
            find_vertex(g);
        if (guess == FMB_GUESS_EXPENSIVE || (guess == FMB_GUESS_OUTSIDE && goes_beyond(g, q)))
            *out = FMB_HULL_OUTSIDE;
        else if (guess == FMB_GUESS_INSIDE)
            *out = FMB_HULL_INSIDE;
    }
    g->is_broken = g->is_broken || guess == FMB_GUESS_NONE;
    return st;
}
