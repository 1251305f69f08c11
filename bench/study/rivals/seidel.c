/* seidel.c: see seidel.h.
 *
 * A program maximizes w.x for x in the unit box subject to rows a x <= b. Without rows, the optimum
 * is a corner of the box. Say x is the optimum over the rows so far and the next row, a x <= b,
 * cuts it off. Then an optimum over all of them, if any, has a x = b: the segment from any optimum
 * to x satisfies the rows so far, crosses the plane, and loses no objective. On the plane, the
 * variable k with the largest |a_k| is (b - the rest) / a_k, put into all rows and w; its own
 * bounds 0 <= x_k <= 1 become two rows more. With one variable left, rows are ends of an interval.
 *
 * Rows are scaled to a largest coefficient of 1. Many planes may pass through an optimum (a corner
 * of the unit simplex is one of the box, too), so a row that is violated by rounding alone must not
 * count as cutting: hence the tolerance.
 */
#include "study/rivals/seidel.h"

#include <math.h>
#include <string.h>

#include "study/draw/draft.h"

static const double tolerance = 0x1p-48; /* a few roundings of a row's largest coefficient */

enum {
    MOST_N = STUDY_ROWS_MOST_COLUMNS - 1,
    MOST_ROWS = STUDY_ROWS_MOST + 2 * MOST_N /* two more for each substituted variable */
};

typedef struct program {
    int n, m;
    double w[MOST_N];
    double a[MOST_ROWS][MOST_N + 1];
} program;

static int draw(uint64_t *random, int below)
{
    return (int)((study_splitmix.get(random) >> 32) * (uint64_t)below >> 32);
}

/* Ends of x in 0 ... 1; false if there is no such x. */
static bool solve_one(const program *g, double *x)
{
    double low = 0, high = 1;
    for (int i = 0; i < g->m; i++) {
        double a = g->a[i][0], b = g->a[i][1];
        if (a > tolerance)
            high = fmin(high, b / a);
        else if (a < -tolerance)
            low = fmax(low, b / a);
        else if (b < -tolerance)
            return false;
    }
    *x = g->w[0] > 0 ? high : low;
    return low <= high + tolerance;
}

/* A row without variable k, which is (plane[n] - the rest of plane) / plane[k]. */
static void substitute(const double *row, const double *plane, int n, int k, double *to)
{
    double times = row[k] / plane[k];
    for (int j = 0, at = 0; j <= n; j++)
        if (j != k)
            to[at++] = row[j] - times * plane[j];
}

static void put_own_bounds(const double *plane, int n, int k, program *to)
{
    double *low = to->a[to->m++], *high = to->a[to->m++];
    for (int j = 0, at = 0; j < n; j++)
        if (j != k) {
            low[at] = plane[j] / plane[k];
            high[at++] = -plane[j] / plane[k];
        }
    low[n - 1] = plane[n] / plane[k];
    high[n - 1] = 1 - plane[n] / plane[k];
}

/* Rows 0 ... count - 1 of g on the plane of row `count`. */
static void restrict_to(const program *g, int count, int k, program *to)
{
    const double *plane = g->a[count];
    double w[MOST_N + 1], rest[MOST_N + 1];
    memcpy(w, g->w, (size_t)g->n * sizeof *w);
    w[g->n] = 0;
    substitute(w, plane, g->n, k, rest);
    to->n = g->n - 1;
    to->m = count;
    memcpy(to->w, rest, (size_t)to->n * sizeof *rest);
    for (int i = 0; i < count; i++)
        substitute(g->a[i], plane, g->n, k, to->a[i]);
    put_own_bounds(plane, g->n, k, to);
}

static int largest(const double *row, int n)
{
    int k = 0;
    for (int j = 1; j < n; j++)
        if (fabs(row[j]) > fabs(row[k]))
            k = j;
    return k;
}

static double dot(const double *row, const double *x, int n)
{
    double sum = 0;
    for (int j = 0; j < n; j++)
        sum += row[j] * x[j];
    return sum;
}

static void shuffle(program *g, uint64_t *random)
{
    double kept[MOST_N + 1];
    size_t bytes = (size_t)(g->n + 1) * sizeof *kept;
    for (int i = g->m - 1; i > 0; i--) {
        int other = draw(random, i + 1);
        memcpy(kept, g->a[i], bytes);
        memcpy(g->a[i], g->a[other], bytes);
        memcpy(g->a[other], kept, bytes);
    }
}

/* The optimum; false if there is none. */
static bool solve(program *g, uint64_t *random, double *x)
{
    if (g->n == 1)
        return solve_one(g, x);
    shuffle(g, random);
    for (int j = 0; j < g->n; j++)
        x[j] = g->w[j] > 0;
    for (int i = 0; i < g->m; i++) {
        const double *row = g->a[i];
        if (dot(row, x, g->n) <= row[g->n] + tolerance)
            continue;
        int k = largest(row, g->n);
        program below;
        double y[MOST_N];
        if (fabs(row[k]) <= tolerance)
            return false;
        restrict_to(g, i, k, &below);
        if (!solve(&below, random, y))
            return false;
        for (int j = 0, at = 0; j < g->n; j++)
            if (j != k)
                x[j] = y[at++];
        x[k] = 0;
        x[k] = (row[g->n] - dot(row, x, g->n)) / row[k];
    }
    return true;
}

/* Add a row, scaled, unless all of the unit box satisfies it. */
static void put_row(program *g, const double *row)
{
    double *to = g->a[g->m], greatest = 0, most = fabs(row[largest(row, g->n)]);
    for (int j = 0; j < g->n; j++)
        greatest += fmax(row[j], 0);
    if (greatest <= row[g->n])
        return;
    g->m++;
    for (int j = 0; j <= g->n; j++)
        to[j] = most > 0 ? row[j] / most : row[j];
}

bool study_seidel_feasible(const study_rows *s, uint64_t *random)
{
    program g;
    double x[MOST_N];
    g.n = s->n;
    g.m = 0;
    for (int i = 0; i < s->m; i++)
        put_row(&g, s->a[i]);
    for (int j = 0; j < s->n; j++)
        g.w[j] = 1;
    return solve(&g, random, x);
}

fmb_verdict study_seidel_decide(const fmb_frame *p, const fmb_frame *q, uint64_t *random)
{
    study_rows s;
    if (!study_rows_make(p, q, 0, &s))
        return FMB_UNKNOWN;
    return study_seidel_feasible(&s, random) ? FMB_FEASIBLE : FMB_INFEASIBLE;
}
