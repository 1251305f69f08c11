/* general_box.c: the box of the common points in doubles, in any dimension.
 *
 * An end is a linear program. The simplex method goes from the vertex of one end to that of the
 * next, in doubles; its prices y then prove the end (prove.c): no common point is farther out, and
 * one is close to it.
 */
#include "pair/general/workspace.h"

#include <math.h>

/* The allowed excess of an end, as a share of the largest coordinate: 1e-12 minus the rounding when
 * it is written, at most 4 times 2^-53 of three times that coordinate. */
#define EXCESS 0.98e-12

typedef struct boxer {
    fmb_general *g;
    const fmb_frame *p, *q;
    double size;                          /* the largest coordinate of a corner */
    double sum[FMB_GENERAL_MOST_COLUMNS]; /* of the vertices */
    int vertices;
} boxer;

/* ---- the largest coordinate ------------------------------------------------------------------ */

/* The interval [low, high] of coordinate i of the corners, at t = 0. */
static void reach_of_corners(const fmb_frame *f, int i, double *low, double *high)
{
    *low = *high = f->origin[i];
    double least = 0, most = 0;
    for (int k = 0; k < f->naxes; k++) {
        double a = f->axes[k * f->dim + i], down = fmin(a, 0), up = fmax(a, 0);
        least = f->shape == FMB_CUBOID ? least + down : fmin(least, down);
        most = f->shape == FMB_CUBOID ? most + up : fmax(most, up);
    }
    *low += least;
    *high += most;
}

/* Off by a share of about (naxes + 2) 2^-53 times 3, as both the origin and the difference of low
 * and high are at most 2 times the result; EXCESS has room for that. */
static double largest_corner(const fmb_frame *f)
{
    double most = 0;
    for (int i = 0; i < f->dim; i++) {
        double low, high, v = f->speed ? f->speed[i] : 0;
        reach_of_corners(f, i, &low, &high);
        most = fmax(most, fmax(fabs(low), fabs(high)));
        most = fmax(most, fmax(fabs(low + v), fabs(high + v)));
    }
    return most;
}

/* ---- ends ------------------------------------------------------------------------------------ */

/* No solution has a greater cost z than *end; one has no less than *end - excess. |cost_j| <= 1. */
static bool find_end_of_cost(boxer *b, const double *cost, double excess, double *end)
{
    fmb_general *g = b->g;
    double y[FMB_GENERAL_MOST_ROWS], gap;
    if (!fmb_general_maximize(g, cost, y) || !fmb_general_bound_cost(g, cost, y, end, &gap) ||
        !(gap <= excess) || !fmb_general_is_near_vertex(&g->program, g->vertex))
        return false;
    for (int j = 0; j < g->pair.columns; j++)
        b->sum[j] += g->vertex[j];
    b->vertices++;
    return true;
}

/* Bound unknown j; the ends lie in 0 ... 1. */
static bool bound_unknown(boxer *b, int j, double *out)
{
    double cost[FMB_GENERAL_MOST_COLUMNS] = {0};
    bool good = true;
    for (int side = 0; good && side < 2; side++) {
        double end;
        cost[j] = side ? 1 : -1;
        good = find_end_of_cost(b, cost, EXCESS, &end);
        out[side] = side ? fmin(end, 1) : fmax(-end, 0);
    }
    return good;
}

/* The costs of coordinate i of A's points, relative to its origin, scaled by a power of two. */
static int weigh_coordinate(const boxer *b, int i, double *cost)
{
    const fmb_frame *p = b->p;
    double most = 0;
    int e;
    for (int j = 0; j < b->g->program.columns; j++)
        cost[j] = j < p->naxes ? p->axes[j * p->dim + i] : 0;
    if (p->speed)
        cost[b->g->pair.columns - 1] = p->speed[i];
    for (int j = 0; j < b->g->program.columns; j++)
        most = fmax(most, fabs(cost[j]));
    frexp(most, &e);
    for (int j = 0; j < b->g->program.columns; j++)
        cost[j] = ldexp(cost[j], -e);
    return e;
}

static bool bound_coordinate(boxer *b, int i, double *out)
{
    double cost[FMB_GENERAL_MOST_COLUMNS], origin = b->p->origin[i];
    int e = weigh_coordinate(b, i, cost);
    bool good = true;
    for (int side = 1; good && side >= 0; side--) {
        double end, toward = side ? INFINITY : -INFINITY;
        good = find_end_of_cost(b, cost, ldexp(EXCESS * b->size, -e), &end);
        double way = nextafter(ldexp(side ? end : -end, e), toward);
        out[side] = nextafter(origin + way, toward);
        for (int j = 0; j < b->g->program.columns; j++)
            cost[j] = -cost[j];
    }
    return good && isfinite(out[0]) && isfinite(out[1]);
}

/* ---- the answer ------------------------------------------------------------------------------ */

/* The mean of the vertices. */
static void write_mean_of_vertices(const boxer *b, double *x)
{
    const fmb_frame *p = b->p;
    for (int i = 0; i < p->dim; i++) {
        x[i] = p->origin[i];
        for (int j = 0; j < p->naxes; j++)
            x[i] += b->sum[j] / b->vertices * p->axes[j * p->dim + i];
        if (p->speed)
            x[i] += b->sum[b->g->pair.columns - 1] / b->vertices * p->speed[i];
    }
}

/* Like those of fmb_pair_answers; the caller's are written only when all is known. */
typedef struct answer {
    double world[2 * FMB_GENERAL_MOST_DIM], inside[2 * FMB_GENERAL_MOST_DIM], time[2];
} answer;

static bool bound_requested_ends(boxer *b, const fmb_pair_answers *out, answer *to)
{
    bool good = true, moves = b->p->speed || b->q->speed;
    for (int i = 0; good && out->world && i < b->p->dim; i++)
        good = bound_coordinate(b, i, to->world + 2 * i);
    for (int k = 0; good && out->inside && k < b->q->naxes; k++)
        good = bound_unknown(b, b->p->naxes + k, to->inside + 2 * k);
    to->time[0] = 0;
    to->time[1] = 1;
    return good && (!out->time || !moves || bound_unknown(b, b->g->pair.columns - 1, to->time));
}

static void write_answer(const boxer *b, const answer *from, const fmb_pair_answers *out)
{
    for (int i = 0; out->world && i < 2 * b->p->dim; i++)
        out->world[i] = from->world[i];
    for (int i = 0; out->inside && i < 2 * b->q->naxes; i++)
        out->inside[i] = from->inside[i];
    for (int i = 0; out->time && i < 2; i++)
        out->time[i] = from->time[i];
    if (out->witness)
        write_mean_of_vertices(b, out->witness);
}

bool fmb_general_answer(fmb_general *g, const fmb_frame *p, const fmb_frame *q,
                        const fmb_pair_answers *out)
{
    boxer b = {.g = g, .p = p, .q = q, .vertices = 1};
    answer found;
    if (g->dim > FMB_GENERAL_MOST_DIM || !fmb_general_load(g, p, q))
        return false;
    if (fmb_general_find_vertex(g) != FMB_GENERAL_GO)
        return false;
    for (int j = 0; j < g->pair.columns; j++)
        b.sum[j] = g->vertex[j];
    b.size = fmax(largest_corner(p), largest_corner(q));
    bool good = b.size > 0x1p-900 && b.size < 0x1p900 && bound_requested_ends(&b, out, &found);
    if (good)
        write_answer(&b, &found, out);
    return good;
}
