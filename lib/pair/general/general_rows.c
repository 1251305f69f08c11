/* general_rows.c: rows of an elimination in doubles, and the box around the unknowns. */
#include "pair/general/workspace.h"

#include <math.h>

/* ---- the box --------------------------------------------------------------------------------- */

/* Least and greatest a x, x the unknowns at the first n places. */
static void measure_over_cube(const double *a, int n, double *least, double *most)
{
    double low = 0, high = 0;
    for (int k = 0; k < n; k++) {
        low += a[k] < 0 ? a[k] : 0;
        high += a[k] > 0 ? a[k] : 0;
    }
    *least = low;
    *most = high;
}

/* In a simplex, all goes to the one unknown that gives most. */
static void measure_over_places(const fmb_general *g, const double *a, int n, double *least,
                                double *most)
{
    double low[FMB_GENERAL_KINDS] = {0}, high[FMB_GENERAL_KINDS] = {0};
    for (int k = 0; k < n; k++) {
        fmb_general_kind kind = g->pair.kind[g->unknown[k]];
        double down = a[k] < 0 ? a[k] : 0, up = a[k] > 0 ? a[k] : 0;
        if (kind == FMB_GENERAL_UNIT) {
            low[kind] += down;
            high[kind] += up;
        } else {
            low[kind] = down < low[kind] ? down : low[kind];
            high[kind] = up > high[kind] ? up : high[kind];
        }
    }
    *least = low[0] + low[1] + low[2];
    *most = high[0] + high[1] + high[2];
}

/* An end that holds strictly in all of the box goes (see rule/box.c for why it may); one that holds
 * nowhere is a clash. */
fmb_general_step fmb_general_settle(fmb_general *g, int n)
{
    fmb_general_head *head = &g->head[g->rows];
    const double *v = fmb_general_cell(g, g->rows), *a = v + g->dim;
    double least, most;
    if (g->all_unit)
        measure_over_cube(a, n, &least, &most);
    else
        measure_over_places(g, a, n, &least, &most);
    if (head->high < least || head->low > most) {
        for (int i = 0; i < g->dim; i++)
            g->direction[i] = v[i];
        return FMB_GENERAL_CLASH;
    }
    if (head->high > most)
        head->high = INFINITY;
    if (head->low < least)
        head->low = -INFINITY;
    g->rows += head->high < INFINITY || head->low > -INFINITY;
    return FMB_GENERAL_GO;
}

/* ---- one row --------------------------------------------------------------------------------- */

void fmb_general_turn(fmb_general *g, size_t i, int place)
{
    double *cell = fmb_general_cell(g, i), *a = cell + g->dim, lead = a[place];
    fmb_general_head *head = &g->head[i], old = *head;
    a[place] = a[g->n - 1];
    a[g->n - 1] = lead;
    if (lead == 0)
        return;
    double f = 1 / lead;
    for (int k = 0; k < g->dim + g->n - 1; k++)
        cell[k] *= f;
    a[g->n - 1] = 1;
    *head = lead > 0 ? (fmb_general_head){old.low * f, old.high * f, old.plus, old.minus}
                     : (fmb_general_head){old.high * f, old.low * f, old.minus, old.plus};
}

/* ---- the rows of the pair -------------------------------------------------------------------- */

/* The place of a pivot: 0 <= r - T x <= 1, or no upper end. */
static fmb_general_step put_row_of_pivot(fmb_general *g, int i)
{
    const double *row = fmb_general_solved(g, i), *inverse = fmb_general_inverse(&g->pair, i);
    double *to = fmb_general_cell(g, g->rows), r = row[g->pair.columns];
    bool is_unit = g->pair.kind[g->pair.pivot[i]] == FMB_GENERAL_UNIT;
    for (int k = 0; k < g->dim; k++)
        *to++ = inverse[k];
    for (int k = 0; k < g->n; k++)
        *to++ = row[g->unknown[k]];
    g->head[g->rows] = (fmb_general_head){
        .low = is_unit ? r - 1 : -INFINITY, .high = r, .plus = (uint64_t)1 << g->pair.pivot[i]};
    return fmb_general_settle(g, g->n);
}

/* to -= row i of the solved table; what is left of the right side */
static double subtract_row_of_pivot(const fmb_general *g, int i, double *to)
{
    const double *row = fmb_general_solved(g, i), *inverse = fmb_general_inverse(&g->pair, i);
    for (int k = 0; k < g->dim; k++)
        to[k] -= inverse[k];
    for (int k = 0; k < g->n; k++)
        to[g->dim + k] -= row[g->unknown[k]];
    return row[g->pair.columns];
}

/* The sum of a simplex: of its free unknowns, or of all of them if any is a pivot. */
static fmb_general_step put_row_of_sum(fmb_general *g, fmb_general_kind kind, bool all)
{
    double *to = fmb_general_cell(g, g->rows), high = 1;
    bool says = false;
    for (int k = 0; k < g->dim; k++)
        to[k] = 0;
    for (int k = 0; k < g->n; k++) {
        to[g->dim + k] = g->pair.kind[g->unknown[k]] == kind;
        says |= !all && to[g->dim + k] > 0;
    }
    for (int i = 0; all && i < g->dim; i++)
        if (g->pair.pivot[i] >= 0 && g->pair.kind[g->pair.pivot[i]] == kind) {
            high -= subtract_row_of_pivot(g, i, to);
            says = true;
        }
    if (!says)
        return FMB_GENERAL_GO;
    int bit = g->pair.columns + 2 * ((int)kind - 1) + all;
    g->head[g->rows] =
        (fmb_general_head){.low = -INFINITY, .high = high, .plus = (uint64_t)1 << bit};
    return fmb_general_settle(g, g->n);
}

fmb_general_step fmb_general_start(fmb_general *g)
{
    fmb_general_step step = FMB_GENERAL_GO;
    g->n = g->removed = 0;
    g->rows = g->pairs = 0;
    g->all_unit = true;
    for (int j = 0; j < g->pair.columns; j++)
        if (!g->pair.is_pivot[j]) {
            g->unknown[g->n++] = j;
            g->all_unit &= g->pair.kind[j] == FMB_GENERAL_UNIT;
        }
    for (int i = 0; step == FMB_GENERAL_GO && i < g->dim; i++)
        if (g->pair.pivot[i] >= 0)
            step = put_row_of_pivot(g, i);
    for (int kind = FMB_GENERAL_OF_A; kind <= FMB_GENERAL_OF_B; kind++)
        for (int all = 0; step == FMB_GENERAL_GO && all < 2; all++)
            step = put_row_of_sum(g, (fmb_general_kind)kind, all);
    g->level[0] = (fmb_general_level){.first = 0, .rows = g->rows};
    return step;
}
