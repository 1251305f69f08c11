/* general_decide.c: see general.h.
 *
 * Guess fast, prove exactly. The guess is the dual simplex method without costs, in plain doubles:
 * it ends either with a direction in which the frames should be apart; or with a vertex, and the
 * mean of some vertices is a point that should be inside both. Whatever rounding did before, the
 * proof (prove.c) needs only that direction or that point, and has an error bound.
 */
#include "pair/general/workspace.h"

#include <math.h>

/* Tolerances, only for guesses: smaller values and costs, and smaller pivots, count as rounding
 * errors of 0 in linear programs. */
#define NOTHING     0x1p-46
#define LEAST_PIVOT 0x1p-30

static void free_equations(fmb_general_system *s, size_t rows, size_t columns, fmb_mem *mem)
{
    fmb_mem_put(mem, s->m, columns * rows, sizeof *s->m);
    fmb_mem_put(mem, s->h, rows, sizeof *s->h);
}

/* Allocate a system of that size; false without memory. */
static bool open_equations(fmb_general_system *s, size_t rows, size_t columns, fmb_mem *mem)
{
    s->m = fmb_mem_get(mem, columns * rows, sizeof *s->m);
    s->h = fmb_mem_get(mem, rows, sizeof *s->h);
    return s->m && s->h;
}

/* Allocate the workspace of linear programs. */
static bool open_program(fmb_general *g, size_t rows, size_t columns, fmb_mem *mem)
{
    bool good = open_equations(&g->program, rows, columns, mem) &&
                fmb_basis_init(&g->basis, mem, g->kernels, rows) == FMB_OK &&
                fmb_basis_reserve(&g->basis, columns) == FMB_OK;
    g->basis.value_zero = NOTHING;
    g->basis.entry_zero = LEAST_PIVOT;
    return good;
}

fmb_general *fmb_general_new(int dim, fmb_simd simd, fmb_mem *mem)
{
    fmb_general *g = fmb_mem_zero(mem, 1, sizeof *g);
    if (!g)
        return NULL;
    size_t d = (size_t)dim;
    g->dim = dim;
    if (dim > FMB_GENERAL_MOST_DIM)
        return g;
    g->kernels = fmb_kernels_choose(simd);
    g->kernels = g->kernels ? g->kernels : fmb_kernels_choose(FMB_SIMD_PLAIN);
    bool good = open_equations(&g->pair, d, 2 * d + 1, mem);
    good = open_program(g, d + 2, 2 * d + 3, mem) && good;
    g->program.inverse = g->edges;
    if (good)
        return g;
    fmb_general_free(g, mem);
    return NULL;
}

void fmb_general_free(fmb_general *g, fmb_mem *mem)
{
    if (!g)
        return;
    size_t d = (size_t)g->dim;
    free_equations(&g->pair, d, 2 * d + 1, mem);
    free_equations(&g->program, d + 2, 2 * d + 3, mem);
    g->basis.mem = mem; /* the address may have changed */
    fmb_basis_clear(&g->basis);
    fmb_mem_put(mem, g, 1, sizeof *g);
}

/* ---- the pair -------------------------------------------------------------------------------- */

static void put_axes_of_frame(fmb_general *g, const fmb_frame *f, fmb_general_kind kind,
                              double sign)
{
    double *to = g->pair.m + g->pair.columns * g->dim;
    for (int j = 0; j < f->naxes * g->dim; j++)
        to[j] = sign * f->axes[j];
    for (int k = 0; k < f->naxes; k++)
        g->pair.kind[g->pair.columns++] = f->shape == FMB_SIMPLEX ? kind : FMB_GENERAL_UNIT;
}

static double largest_of_coordinate(const fmb_general *g, int i)
{
    double most = 0;
    for (int j = 0; j < g->pair.columns; j++)
        most = fmax(most, fabs(g->pair.m[j * g->dim + i]));
    return most > 0 ? most : fabs(g->pair.h[i]);
}

/* The power of two, in two factors as it may be as large as 2^1074. */
static void scale_coordinate(fmb_general *g, int i)
{
    int e;
    frexp(largest_of_coordinate(g, i), &e);
    double half = ldexp(1, -(e / 2)), rest = ldexp(1, -(e - e / 2));
    for (int j = 0; j < g->pair.columns; j++)
        g->pair.m[j * g->dim + i] = g->pair.m[j * g->dim + i] * half * rest;
    g->pair.h[i] = g->pair.h[i] * half * rest;
}

bool fmb_general_load(fmb_general *g, const fmb_frame *p, const fmb_frame *q)
{
    bool moves = p->speed || q->speed, good = true;
    g->pair.rows = g->dim;
    g->pair.columns = 0;
    put_axes_of_frame(g, p, FMB_GENERAL_OF_A, 1);
    put_axes_of_frame(g, q, FMB_GENERAL_OF_B, -1);
    double *drift = g->pair.m + g->pair.columns * g->dim;
    for (int i = 0; i < g->dim; i++)
        g->pair.h[i] = q->origin[i] - p->origin[i];
    for (int i = 0; moves && i < g->dim; i++)
        drift[i] = (p->speed ? p->speed[i] : 0) - (q->speed ? q->speed[i] : 0);
    for (int i = 0; moves && i < g->dim; i++)
        good &= isfinite(drift[i]);
    if (moves)
        g->pair.kind[g->pair.columns++] = FMB_GENERAL_UNIT;
    for (int i = 0; good && i < g->dim; i++) {
        scale_coordinate(g, i);
        good = isfinite(g->pair.h[i]);
    }
    return good;
}

/* ---- the verdict ----------------------------------------------------------------------------- */

/* If a place of the basis has no column, its edge is perpendicular to all columns, and the frames
 * lie in parallel flats: are they apart in that direction? */
static bool are_in_parallel_flats(const fmb_general *g)
{
    double edge[FMB_GENERAL_MOST_ROWS];
    for (size_t r = 0; r < g->basis.d; r++) {
        if (g->basis.basic[r] != SIZE_MAX)
            continue;
        fmb_dense_inverse_edge(&g->basis.inverse, r, edge);
        if (fmb_general_are_apart(&g->pair, edge))
            return true;
    }
    return false;
}

fmb_verdict fmb_general_decide(fmb_general *g, const fmb_frame *p, const fmb_frame *q)
{
    if (g->dim > FMB_GENERAL_MOST_DIM || !fmb_general_load(g, p, q))
        return FMB_UNKNOWN;
    fmb_general_step step = fmb_general_find_vertex(g);
    if (step == FMB_GENERAL_CLASH && fmb_general_are_apart(&g->pair, g->direction))
        return FMB_INFEASIBLE;
    if (step == FMB_GENERAL_LOST && are_in_parallel_flats(g))
        return FMB_INFEASIBLE;
    bool inside = step == FMB_GENERAL_GO && fmb_general_find_inside(g, g->z);
    return inside && fmb_general_is_near_common(&g->program, g->z) ? FMB_FEASIBLE : FMB_UNKNOWN;
}
