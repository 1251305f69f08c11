/* last_two.c: the last two unknowns x and y, and the way back.
 *
 * Of x + s y in [low, high], over all rows, x lies between the greatest of low - s y and the least
 * of high - s y. The gap between them is a concave function of y made of lines: so its zeros, the
 * ends of y, are found by Newton's method from outside, without making any pair.
 */
#include "pair/general/workspace.h"

#include <math.h>

enum { THE_BOX = -1 }; /* in place of a row */

/* Rows with x at the last place (y at the first one, if there is a y), its coefficient 1 or 0. */
typedef struct plane {
    const fmb_general *g;
    size_t first, end;
    int x; /* its place */
} plane;

/* The gap at some y. */
typedef struct gap {
    double low, high, slope; /* of x; of the gap */
    int below, above;        /* the rows */
} gap;

/* The coefficient of y. */
static double slope_in_y(const plane *p, int row)
{
    return row >= 0 && p->x == 1 ? fmb_general_cell(p->g, (size_t)row)[p->g->dim] : 0;
}

static gap find_gap_at(const plane *p, double y)
{
    gap at = {0, 1, 0, THE_BOX, THE_BOX};
    for (size_t i = p->first; i < p->end; i++) {
        double shift = slope_in_y(p, (int)i) * y;
        double high = p->g->head[i].high - shift, low = p->g->head[i].low - shift;
        if (fmb_general_cell(p->g, i)[p->g->dim + p->x] == 0)
            continue;
        if (high < at.high) {
            at.high = high;
            at.above = (int)i;
        }
        if (low > at.low) {
            at.low = low;
            at.below = (int)i;
        }
    }
    at.slope = slope_in_y(p, at.below) - slope_in_y(p, at.above);
    return at;
}

/* ---- ends of y ------------------------------------------------------------------------------- */

/* From rows without x, and those rows. */
typedef struct ends {
    double end[2];
    int row[2];
} ends;

static ends find_ends_of_y(const plane *p)
{
    ends e = {{0, 1}, {THE_BOX, THE_BOX}};
    for (size_t i = p->first; i < p->end; i++) {
        const double *a = fmb_general_cell(p->g, i) + p->g->dim;
        const fmb_general_head *head = &p->g->head[i];
        if (a[1] != 0 || a[0] == 0)
            continue;
        double low = (a[0] > 0 ? head->low : head->high) / a[0];
        double high = (a[0] > 0 ? head->high : head->low) / a[0];
        if (low > e.end[0]) {
            e.end[0] = low;
            e.row[0] = (int)i;
        }
        if (high < e.end[1]) {
            e.end[1] = high;
            e.row[1] = (int)i;
        }
    }
    return e;
}

static void add_direction_of_row(fmb_general *g, int row, double factor)
{
    for (int i = 0; row >= 0 && i < g->dim; i++)
        g->direction[i] += factor * fmb_general_cell(g, (size_t)row)[i];
}

/* The gap is negative and does not grow from here on; before, it was below a line that is 0 here,
 * or y was at an end. The rows of both, so that y cancels. */
static fmb_general_step clash_of_gap(fmb_general *g, const gap *at, const gap *before, int end)
{
    for (int i = 0; i < g->dim; i++)
        g->direction[i] = 0;
    add_direction_of_row(g, at->above, 1);
    add_direction_of_row(g, at->below, -1);
    if (before) {
        add_direction_of_row(g, before->above, -at->slope / before->slope);
        add_direction_of_row(g, before->below, at->slope / before->slope);
    } else if (end >= 0) {
        add_direction_of_row(g, end, at->slope / fmb_general_cell(g, (size_t)end)[g->dim]);
    }
    return FMB_GENERAL_CLASH;
}

/* The end of y on that side. Each step goes to the zero of a line above the gap, so it does not go
 * too far; it stops where the gap is open, or when rounding ends the progress. */
static fmb_general_step approach_end_of_y(fmb_general *g, const plane *p, const ends *e, int side,
                                          double *y)
{
    gap before, at;
    size_t most = p->end - p->first + 2;
    *y = e->end[side];
    for (size_t step = 0; at = find_gap_at(p, *y), at.high < at.low && step < most; step++) {
        if (side ? at.slope >= 0 : at.slope <= 0)
            return clash_of_gap(g, &at, step > 0 ? &before : NULL, e->row[side]);
        before = at;
        *y += (at.low - at.high) / at.slope;
    }
    return FMB_GENERAL_GO;
}

static fmb_general_step find_last_two_unknowns(fmb_general *g, const plane *p, double *x)
{
    ends e = find_ends_of_y(p);
    double from, to;
    fmb_general_step step = approach_end_of_y(g, p, &e, 0, &from);
    if (step == FMB_GENERAL_GO)
        step = approach_end_of_y(g, p, &e, 1, &to);
    if (step == FMB_GENERAL_GO) {
        x[0] = (from + to) / 2;
        gap at = find_gap_at(p, x[0]);
        x[1] = (at.low + at.high) / 2;
    }
    return step;
}

static fmb_general_step find_last_unknown(fmb_general *g, const plane *p, double *x)
{
    gap at = find_gap_at(p, 0);
    x[0] = (at.low + at.high) / 2;
    return at.high < at.low ? clash_of_gap(g, &at, NULL, THE_BOX) : FMB_GENERAL_GO;
}

/* ---- the way back ---------------------------------------------------------------------------- */

/* The unknown at the last of n places, in the middle of what the rows before its round leave. */
static void go_back_one_round(const fmb_general *g, const fmb_general_level *level, int n,
                              double *x)
{
    double high = 1, low = 0;
    for (size_t i = level->first; i < level->first + level->rows; i++) {
        const double *a = fmb_general_cell(g, i) + g->dim;
        double sum = 0;
        if (a[n - 1] == 0)
            continue;
        for (int k = 0; k < n - 1; k++)
            sum += a[k] * x[k];
        high = fmin(high, g->head[i].high - sum);
        low = fmax(low, g->head[i].low - sum);
    }
    x[n - 1] = (low + high) / 2;
}

/* z from the free unknowns. */
static void solve_pivots(fmb_general *g, const double *x, int n)
{
    for (int k = 0; k < n; k++)
        g->z[g->unknown[k]] = x[k];
    for (int i = 0; i < g->dim; i++) {
        const double *row = fmb_general_solved(g, i);
        double sum = row[g->pair.columns];
        if (g->pair.pivot[i] < 0)
            continue;
        for (int k = 0; k < n; k++)
            sum -= row[g->unknown[k]] * x[k];
        g->z[g->pair.pivot[i]] = sum;
    }
}

fmb_general_step fmb_general_finish(fmb_general *g)
{
    double x[FMB_GENERAL_MOST_COLUMNS];
    const fmb_general_level *level = &g->level[g->removed];
    const plane p = {g, level->first, level->first + level->rows, g->n - 1};
    fmb_general_step step = FMB_GENERAL_GO;
    int n = g->n;
    for (size_t i = p.first; n > 0 && i < p.end; i++)
        fmb_general_turn(g, i, n - 1);
    if (n == 2)
        step = find_last_two_unknowns(g, &p, x);
    else if (n == 1)
        step = find_last_unknown(g, &p, x);
    while (step == FMB_GENERAL_GO && level-- > g->level) {
        go_back_one_round(g, level, ++n, x);
        double last = x[n - 1];
        int column = g->unknown[n - 1];
        x[n - 1] = x[level->place];
        x[level->place] = last;
        g->unknown[n - 1] = g->unknown[level->place];
        g->unknown[level->place] = column;
    }
    if (step == FMB_GENERAL_GO)
        solve_pivots(g, x, n);
    return step;
}
