/* pivots.c: M z = h solved for some unknowns, by Gauss and Jordan's elimination in doubles.
 * A pivot is the largest entry of all, each counted in shares of its column's largest. That
 * simplices come on one side as a whole, or axes of one frame, gains nothing.
 */
#include "pair/general/workspace.h"

#include <math.h>

static void load_table(fmb_general *g)
{
    fmb_general_system *s = &g->pair;
    s->stride = s->columns + 1 + s->rows;
    s->inverse = g->solved + s->columns + 1;
    for (int i = 0; i < s->rows; i++) {
        double *to = fmb_general_solved(g, i);
        for (int j = 0; j < s->columns; j++)
            *to++ = s->m[j * s->rows + i];
        *to++ = s->h[i];
        for (int k = 0; k < s->rows; k++)
            *to++ = i == k;
        s->pivot[i] = -1;
    }
    for (int j = 0; j < s->columns; j++)
        s->is_pivot[j] = false;
}

/* What the entries of a column count: 1 over its largest. */
static void weigh_columns(const fmb_general_system *s, double *weight)
{
    for (int j = 0; j < s->columns; j++) {
        double most = 0;
        for (int i = 0; i < s->rows; i++)
            most = fmax(most, fabs(s->m[j * s->rows + i]));
        weight[j] = most > 0 ? 1 / most : 0;
    }
}

/* The best entry in rows and columns without a pivot. Less than 2^-44 of what its column was is
 * taken for the rounding error of 0: a guess. */
static bool choose_largest_entry(const fmb_general *g, const double *weight, int *row, int *column)
{
    const fmb_general_system *s = &g->pair;
    double best = 0x1p-44;
    bool found = false;
    for (int i = 0; i < s->rows; i++) {
        const double *a = fmb_general_solved(g, i);
        for (int j = 0; s->pivot[i] < 0 && j < s->columns; j++) {
            double worth = fabs(a[j]) * weight[j];
            if (worth > best && !s->is_pivot[j]) {
                found = true;
                best = worth;
                *row = i;
                *column = j;
            }
        }
    }
    return found;
}

/* Make that column the pivot of that row. */
static void pivot_table_on(fmb_general *g, int row, int column)
{
    fmb_general_system *s = &g->pair;
    double *restrict p = fmb_general_solved(g, row);
    double factor = 1 / p[column];
    for (int k = 0; k < s->stride; k++)
        p[k] *= factor;
    p[column] = 1;
    for (int i = 0; i < s->rows; i++) {
        double *restrict a = fmb_general_solved(g, i), f = a[column];
        if (i == row || f == 0)
            continue;
        for (int k = 0; k < s->stride; k++)
            a[k] -= f * p[k];
        a[column] = 0;
    }
    s->pivot[row] = column;
    s->is_pivot[column] = true;
}

void fmb_general_solve(fmb_general *g)
{
    fmb_general_system *s = &g->pair;
    double weight[FMB_GENERAL_MOST_COLUMNS];
    int row = 0, column = 0;
    load_table(g);
    weigh_columns(s, weight);
    for (s->rank = 0; s->rank < s->rows && choose_largest_entry(g, weight, &row, &column);
         s->rank++)
        pivot_table_on(g, row, column);
}
