/* membership_walk.c: from vertex to vertex, by the dual and by the primal method; see
 * membership_private.h. */
#include "lp/redundancy/ray_shooting/membership_private.h"

#include <math.h>

/* Pivots are larger than this, where edges have length 1. */
#define LEAST_PIVOT 1e-8

/* ---- the dual method: up along edges --------------------------------------------------------- */

/* The place whose edge rises most for its length. */
static size_t find_steepest_rise(const fmb_membership *g)
{
    size_t best = SIZE_MAX;
    double most = 0;
    for (size_t r = 0; r < g->n; r++) {
        double v = g->basis.value[r];
        if (v < -g->zero && v * v > most * g->length[r]) {
            most = v * v / g->length[r];
            best = r;
        }
    }
    return best;
}

/* The hyperplane, of points and of the cube, that an edge meets first; of those that are met nearly
 * at once, the one that is met most squarely. */
typedef struct first_artificial {
    size_t artificial;
    double gap, along;
} first_artificial;

static double cube_gap(const fmb_membership *g, size_t j)
{
    return 1 - g->w[fmb_membership_artificial_axis(j)] * fmb_membership_artificial_coordinate(g, j);
}

static double cube_along(const fmb_membership *g, size_t r, size_t j)
{
    return g->basis.inverse.at[fmb_membership_artificial_axis(j) * g->n + r] *
           fmb_membership_artificial_coordinate(g, j);
}

/* How far the edge goes if hyperplanes may be passed by as little as rounding errors: rates of
 * approach are counted from `least` on. */
static double find_longest_step(const fmb_membership *g, size_t r, double least)
{
    double step = INFINITY;
    for (size_t j = 0; j < g->basis.size; j++)
        if (g->basis.price[j] < -least &&
            g->reduced[j] + FMB_MEMBERSHIP_ROUNDING < step * -g->basis.price[j])
            step = (g->reduced[j] + FMB_MEMBERSHIP_ROUNDING) / -g->basis.price[j];
    for (size_t j = FMB_MEMBERSHIP_ARTIFICIALS; j < FMB_MEMBERSHIP_ARTIFICIALS + 2 * g->n; j++) {
        double along = cube_along(g, r, j);
        if (along < -least / g->cube && cube_gap(g, j) + FMB_MEMBERSHIP_ROUNDING < step * -along)
            step = (cube_gap(g, j) + FMB_MEMBERSHIP_ROUNDING) / -along;
    }
    return step;
}

static first_artificial find_first_artificial(const fmb_membership *g, size_t r)
{
    double least = LEAST_PIVOT * sqrt(g->length[r]), step = find_longest_step(g, r, least);
    first_artificial f = {SIZE_MAX, 0, -least};
    for (size_t j = 0; j < g->basis.size; j++)
        if (g->basis.price[j] < f.along && g->reduced[j] <= step * -g->basis.price[j])
            f = (first_artificial){j, g->reduced[j], g->basis.price[j]};
    for (size_t j = FMB_MEMBERSHIP_ARTIFICIALS;
         f.artificial == SIZE_MAX && j < FMB_MEMBERSHIP_ARTIFICIALS + 2 * g->n; j++)
        if (cube_along(g, r, j) < -least / g->cube && cube_gap(g, j) <= step * -cube_along(g, r, j))
            f = (first_artificial){j, cube_gap(g, j), cube_along(g, r, j)};
    f.gap = f.gap > 0 ? f.gap : 0;
    return f;
}

static double sum_of_values(const fmb_membership *g)
{
    double sum = 0;
    for (size_t r = 0; r < g->n; r++)
        sum += g->basis.value[r];
    return sum;
}

fmb_status fmb_membership_run_dual(fmb_membership *g, const double *q, fmb_run *run,
                                   fmb_side_of_hull *out)
{
    fmb_status st = FMB_OK;
    *out = FMB_HULL_NONE;
    fmb_membership_find_values(g, q);
    for (size_t steps = 0; st == FMB_OK && steps < 64 + 16 * g->n; steps++) {
        if (sum_of_values(g) > 1 + FMB_MEMBERSHIP_ROUNDING) {
            *out = FMB_HULL_OUTSIDE;
            return FMB_OK;
        }
        size_t r = find_steepest_rise(g);
        if (r == SIZE_MAX) {
            *out = FMB_HULL_INSIDE;
            return FMB_OK;
        }
        fmb_membership_price(g, r);
        first_artificial f = find_first_artificial(g, r);
        if (f.artificial == SIZE_MAX)
            return FMB_OK;
        fmb_membership_write(g, f.artificial);
        fmb_membership_pivot(g, r, f.artificial, f.gap);
        st = run ? fmb_run_poll(run) : FMB_OK;
    }
    return st;
}

/* ---- the primal method: back behind new hyperplanes ------------------------------------------ */

/* The hyperplane, of points and of the cube, that w is farthest beyond. */
static size_t find_most_broken_artificial(const fmb_membership *g, double *gap)
{
    size_t best = SIZE_MAX;
    *gap = -FMB_MEMBERSHIP_ROUNDING;
    for (size_t j = 0; j < g->basis.size; j++)
        if (g->reduced[j] < *gap) {
            *gap = g->reduced[j];
            best = j;
        }
    for (size_t j = FMB_MEMBERSHIP_ARTIFICIALS; j < FMB_MEMBERSHIP_ARTIFICIALS + 2 * g->n; j++)
        if (cube_gap(g, j) < *gap) {
            *gap = cube_gap(g, j);
            best = j;
        }
    return best;
}

/* The basic point that comes down to 0 first when j, just written, goes up. */
static size_t find_leaving_point(const fmb_membership *g, size_t j)
{
    size_t best = SIZE_MAX;
    double room = INFINITY,
           least = fmb_membership_is_artificial(j) ? LEAST_PIVOT / g->cube : LEAST_PIVOT;
    for (size_t r = 0; r < g->n; r++)
        if (g->basis.entry[r] > least * sqrt(g->length[r]) &&
            g->basis.value[r] < room * g->basis.entry[r]) {
            room = g->basis.value[r] / g->basis.entry[r];
            best = r;
        }
    return best;
}

/* A target that w is the highest vertex for: a sum of all basic points, no two of them alike. */
static void aim_at_vertex(fmb_membership *g)
{
    uint32_t h = 1;
    for (size_t r = 0; r < g->n; r++) {
        h = h * 1664525u + 1013904223u;
        g->basis.value[r] = 1 + (double)(h >> 8) / (1 << 24);
    }
}

fmb_status fmb_membership_run_primal(fmb_membership *g, fmb_run *run, bool *done)
{
    fmb_status st = FMB_OK;
    aim_at_vertex(g);
    *done = false;
    for (size_t steps = 0; st == FMB_OK && steps < 64 + 16 * g->n; steps++) {
        double gap;
        size_t j = find_most_broken_artificial(g, &gap);
        *done = j == SIZE_MAX;
        if (*done)
            return FMB_OK;
        fmb_membership_write(g, j);
        size_t r = find_leaving_point(g, j);
        if (r == SIZE_MAX)
            return FMB_OK;
        fmb_membership_price(g, r);
        fmb_membership_pivot(g, r, j, gap);
        st = run ? fmb_run_poll(run) : FMB_OK;
    }
    return st;
}
