/* general_solve.c: M z = h solved for some unknowns, by Gauss and Jordan's elimination in doubles.
 *
 * Which unknowns become pivots decides how many rows the elimination makes. Measured: for two
 * cuboids it is best to take the largest entry of all, about half as many rows as with the axes of
 * one frame alone; but a simplex should lie on one side as a whole, as only then its rows stay
 * sparse. So of a cuboid and a simplex the cuboid's axes come first, of two simplices those of B.
 */
#include "pair/general_inside.h"

#include <math.h>

static void load(fmb_general *g)
{
    for (int i = 0; i < g->dim; i++) {
        double *to = fmb_general_solved(g, i);
        for (int j = 0; j < g->columns; j++)
            *to++ = g->m[j * g->dim + i];
        *to++ = g->h[i];
        for (int k = 0; k < g->dim; k++)
            *to++ = i == k;
        g->pivot[i] = -1;
    }
    for (int j = 0; j < g->columns; j++)
        g->is_pivot[j] = false;
}

/* What the entries of a column count: 1 over its largest, and more if it should come first. */
static void weigh(const fmb_general *g, double *weight)
{
    bool has[FMB_GENERAL_KINDS] = {false};
    for (int j = 0; j < g->columns; j++)
        has[g->kind[j]] = true;
    fmb_general_kind first =
        has[FMB_GENERAL_OF_A] && has[FMB_GENERAL_OF_B] ? FMB_GENERAL_OF_B : FMB_GENERAL_UNIT;
    for (int j = 0; j < g->columns; j++) {
        double most = 0;
        for (int i = 0; i < g->dim; i++)
            most = fmax(most, fabs(g->m[j * g->dim + i]));
        weight[j] = most > 0 ? (g->kind[j] == first ? 0x1p20 : 1) / most : 0;
    }
}

/* The best entry in rows and columns without a pivot. Less than 2^-44 of what its column was is
 * taken for the rounding error of 0: a guess. */
static bool choose(const fmb_general *g, const double *weight, int *row, int *column)
{
    double best = 0x1p-44;
    bool found = false;
    for (int i = 0; i < g->dim; i++) {
        const double *a = fmb_general_solved(g, i);
        for (int j = 0; g->pivot[i] < 0 && j < g->columns; j++) {
            double worth = fabs(a[j]) * weight[j];
            if (worth > best && !g->is_pivot[j]) {
                found = true;
                best = worth;
                *row = i;
                *column = j;
            }
        }
    }
    return found;
}

static void clear_column(fmb_general *g, int row, int column)
{
    int width = g->columns + 1 + g->dim;
    double *restrict p = fmb_general_solved(g, row);
    double factor = 1 / p[column];
    for (int k = 0; k < width; k++)
        p[k] *= factor;
    p[column] = 1;
    for (int i = 0; i < g->dim; i++) {
        double *restrict a = fmb_general_solved(g, i), f = a[column];
        if (i == row || f == 0)
            continue;
        for (int k = 0; k < width; k++)
            a[k] -= f * p[k];
        a[column] = 0;
    }
}

void fmb_general_solve(fmb_general *g)
{
    double weight[FMB_GENERAL_MOST_COLUMNS];
    int row = 0, column = 0;
    load(g);
    weigh(g, weight);
    for (g->rank = 0; g->rank < g->dim && choose(g, weight, &row, &column); g->rank++) {
        clear_column(g, row, column);
        g->pivot[row] = column;
        g->is_pivot[column] = true;
    }
}
