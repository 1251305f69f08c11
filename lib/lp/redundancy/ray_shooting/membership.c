/* membership.c: see membership.h.
 *
 * For a new q the primal method goes from vertex to vertex, always upwards, until w.q is above 1 or
 * no edge gains. A new point may cut off the vertex: then the dual method finds a remaining one,
 * the highest in a direction for which the old one was highest.
 */
#include "lp/redundancy/ray_shooting/membership.h"

#include <math.h>
#include <string.h>

#include "base/arrays.h"

/* Smaller numbers count as rounding errors of 0: points and w are not longer than about 1. */
#define ROUNDING 1e-9
/* Least slope that is no rounding error, if edges have length 1. */
#define LEAST_SLOPE 1e-6

/* ---- life ------------------------------------------------------------------------------------ */

/* w = 0 is a vertex for any points. */
static fmb_status start_from_origin(fmb_membership *g)
{
    size_t *member = g->state.basis.old;
    for (size_t k = 0; k < g->n; k++)
        member[k] = FMB_UNIT + k;
    g->is_broken = false;
    memset(g->w, 0, g->n * sizeof *g->w);
    return fmb_simplex_state_reload(&g->state, member);
}

static fmb_status hold_vectors(fmb_membership *g, bool get)
{
    return FMB_ARRAYS(g->program.mem, get, FMB_ARRAY(g->columns, g->n), FMB_ARRAY(g->w, g->n),
                      FMB_ARRAY(g->way, g->n));
}

fmb_status fmb_membership_init(fmb_membership *g, fmb_run *run, size_t n)
{
    *g = (fmb_membership){.n = n, .scaled.run = run};
    fmb_program_init(&g->program, run->mem, (int)n);
    FMB_TRY(hold_vectors(g, true));
    for (size_t k = 0; k < n; k++)
        g->columns[k] = (int)k;
    FMB_TRY(fmb_scaled_program_init(&g->scaled, run, &g->program));
    FMB_TRY(fmb_simplex_state_init(&g->state, &g->scaled, FMB_INVERSE_EXPLICIT));
    g->state.is_brief = true;
    g->state.enough = 1 + ROUNDING;
    return start_from_origin(g);
}

void fmb_membership_clear(fmb_membership *g)
{
    if (!g->scaled.run)
        return;
    fmb_mem_put(g->program.mem, g->name, g->name_room, sizeof *g->name);
    if (g->state.f)
        fmb_simplex_state_clear(&g->state);
    fmb_scaled_program_clear(&g->scaled);
    fmb_program_clear(&g->program);
    (void)hold_vectors(g, false);
    g->scaled.run = NULL;
}

/* ---- points ---------------------------------------------------------------------------------- */

static double find_height(const fmb_membership *g, const double *q)
{
    double sum = 0;
    for (size_t k = 0; k < g->n; k++)
        sum += g->w[k] * q[k];
    return sum;
}

fmb_status fmb_membership_add(fmb_membership *g, const double *q, size_t name)
{
    fmb_simplex_state *o = &g->state;
    size_t j = g->scaled.m;
    FMB_TRY(FMB_RESERVE(g->program.mem, &g->name, &g->name_room, j + 1));
    if (g->program.m == j)
        FMB_TRY(fmb_program_add(&g->program, g->n, g->columns, NULL, NULL, FMB_LE));
    FMB_TRY(fmb_scaled_program_append(&g->scaled, q, 1));
    g->name[j] = name;
    FMB_TRY(fmb_simplex_state_grow(o));
    o->slack[j] = 1 - find_height(g, q);
    g->is_broken = g->is_broken || o->slack[j] < -ROUNDING;
    return FMB_OK;
}

/* The points of the basis come first. */
fmb_status fmb_membership_forget(fmb_membership *g)
{
    size_t left = 0, *member = g->state.basis.member;
    double *at = g->scaled.value;
    for (size_t j = 0; j < g->scaled.m; j++)
        for (size_t r = 0; r < g->n; r++)
            if (member[r] == j) {
                memmove(&at[left * g->n], &at[j * g->n], g->n * sizeof *at);
                g->name[left] = g->name[j];
                member[r] = left++;
                break;
            }
    fmb_program_shorten(&g->program, left);
    g->scaled.m = left;
    return fmb_simplex_state_reload(&g->state, member);
}

/* ---- questions ------------------------------------------------------------------------------- */

/* w = the common point of all basic hyperplanes. */
static void find_vertex(fmb_membership *g)
{
    fmb_simplex_state_find_point(&g->state);
    memcpy(g->w, g->state.edge.at, g->n * sizeof *g->w);
    memcpy(g->way, g->w, g->n * sizeof *g->way);
}

/* Go from the vertex along edge r, which no hyperplane stops, until q is outside; false if the
 * slope may be a rounding error. */
static bool goes_beyond(fmb_membership *g, const double *q, size_t r)
{
    fmb_indexed_vector *edge = &g->state.edge;
    double slope = 0, square = 0;
    fmb_basis_inverse_edge(&g->state.basis, r, edge);
    for (size_t k = 0; k < g->n; k++) {
        slope += edge->at[k] * q[k];
        square += edge->at[k] * edge->at[k];
    }
    if (fabs(slope) <= LEAST_SLOPE * sqrt(square))
        return false;
    for (size_t k = 0; k < g->n; k++)
        g->way[k] += (2 - find_height(g, q)) / slope * edge->at[k];
    return true;
}

/* The direction is the sum of all basic points with distinct factors. */
static fmb_status go_behind_points(fmb_membership *g)
{
    fmb_simplex_state *o = &g->state;
    fmb_simplex_end end;
    size_t odd;
    memset(o->cost, 0, g->n * sizeof *o->cost);
    for (size_t r = 0; r < g->n; r++)
        if (o->basis.member[r] < FMB_UNIT)
            fmb_simplex_state_add_to_cost(o, r, fmb_simplex_state_draw(o));
    o->steps = 0;
    FMB_TRY(fmb_dual_simplex(o, &end, &odd));
    g->is_broken = end != FMB_SIMPLEX_DONE;
    return fmb_simplex_state_refresh(o);
}

/* From a vertex behind all hyperplanes to the highest one for q, or one that is high enough. */
static fmb_status climb_for_point(fmb_membership *g, const double *q, fmb_side_of_hull *out)
{
    fmb_simplex_state *o = &g->state;
    fmb_simplex_end end;
    size_t odd;
    memcpy(o->cost, q, g->n * sizeof *q);
    o->steps = 0;
    o->most_steps = 16 * g->n + 64;
    FMB_TRY(fmb_primal_simplex(o, &end, &odd));
    find_vertex(g);
    if (end == FMB_SIMPLEX_STOPPED && goes_beyond(g, q, odd))
        *out = FMB_HULL_OUTSIDE;
    else if (end != FMB_SIMPLEX_ITERATION_LIMIT)
        *out = find_height(g, q) > o->enough ? FMB_HULL_OUTSIDE : FMB_HULL_INSIDE;
    fmb_run_count(g->scaled.run, o->steps * g->n * (g->n + o->m) / 4);
    return FMB_OK;
}

/* If the search is stuck, restart from the origin: errors may have accumulated. */
fmb_status fmb_membership_ask(fmb_membership *g, const double *q, bool closer,
                              fmb_side_of_hull *out)
{
    *out = FMB_HULL_NONE;
    g->scaled.sharp = closer;
    for (int tries = 0; *out == FMB_HULL_NONE && tries < 2; tries++) {
        if (tries > 0)
            FMB_TRY(start_from_origin(g));
        if (g->is_broken)
            FMB_TRY(go_behind_points(g));
        if (!g->is_broken)
            FMB_TRY(climb_for_point(g, q, out));
    }
    g->is_broken = g->is_broken || *out == FMB_HULL_NONE;
    return FMB_OK;
}
