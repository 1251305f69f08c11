/* general_program.c: linear programs over the common points of a pair, in doubles; also guesses.
 *
 * The system of the pair, with a slack for the sum of each simplex, so that every unknown has its
 * own bounds: 0, and 1 unless it is summed. At a vertex all nonbasic unknowns are at a bound.
 */
#include "pair/general/workspace.h"

#include <math.h>

/* ---- the system ------------------------------------------------------------------------------ */

/* Load the pair, with a row c_1 + ... + slack = 1 for each simplex. */
static void load_with_slacks(const fmb_general_system *pair, fmb_general_system *s)
{
    int row[FMB_GENERAL_KINDS] = {-1, -1, -1, -1};
    for (int j = 0; j < pair->columns; j++)
        row[pair->kind[j]] = 0;
    s->rows = pair->rows;
    s->columns = pair->columns;
    for (int kind = FMB_GENERAL_OF_A; kind <= FMB_GENERAL_OF_B; kind++)
        if (row[kind] == 0) {
            s->kind[s->columns++] = (fmb_general_kind)kind;
            row[kind] = s->rows++;
        }
    for (int i = 0; i < s->rows; i++)
        s->h[i] = i < pair->rows ? pair->h[i] : 1;
    for (int j = 0; j < s->columns; j++) {
        bool is_slack = j >= pair->columns;
        fmb_general_kind kind = is_slack ? s->kind[j] : pair->kind[j];
        double *to = s->m + j * s->rows;
        for (int i = 0; i < s->rows; i++)
            to[i] = i < pair->rows ? (is_slack ? 0 : pair->m[j * pair->rows + i]) : i == row[kind];
        s->kind[j] = kind == FMB_GENERAL_UNIT ? kind : FMB_GENERAL_SUMMED;
    }
}

/* Fill the basis with columns, each in the row where its remainder is largest; at first only if
 * that is a large share of its largest entry. Slacks have rows of their own. False if the columns
 * do not span all rows: less than 2^-44 of a column is taken for 0, a guess. */
static bool fill_basis(fmb_general *g)
{
    const fmb_general_system *s = &g->program;
    fmb_basis *b = &g->basis;
    size_t filled = 0, d = (size_t)s->rows;
    fmb_basis_restart(b, d);
    for (int j = 0; j < s->columns; j++)
        (void)fmb_basis_add(b, s->m + j * s->rows,
                            s->kind[j] == FMB_GENERAL_UNIT ? FMB_RANGE_UNIT : FMB_RANGE_UP);
    for (double share = 0.25; filled < d && share > 0x1p-60; share *= 0x1p-42)
        for (size_t j = b->size; filled < d && j-- > 0;) {
            double most = 0;
            for (size_t k = 0; k < d; k++)
                most = fmax(most, fabs(b->at[k * b->capacity + j]));
            filled += !b->is_basic[j] && fmb_basis_span(b, j, share * most);
        }
    return filled == d;
}

/* Read the pivots, and z, of the vertex of the present basis. */
static void read_vertex_of_basis(fmb_general *g)
{
    fmb_general_system *s = &g->program;
    const fmb_basis *b = &g->basis;
    for (int j = 0; j < s->columns; j++) {
        s->is_pivot[j] = b->is_basic[j];
        g->vertex[j] = b->is_high[j];
    }
    for (int i = 0; i < s->rows; i++) {
        s->pivot[i] = (int)b->basic[i];
        g->vertex[s->pivot[i]] = b->value[i];
    }
    for (int i = 0; i < s->rows; i++)
        fmb_dense_inverse_edge(&b->inverse, (size_t)i, g->edges + i * s->rows);
}

/* ---- vertices -------------------------------------------------------------------------------- */

fmb_general_step fmb_general_find_vertex(fmb_general *g)
{
    fmb_guess guess;
    load_with_slacks(&g->pair, &g->program);
    if (!fill_basis(g) ||
        fmb_simplex_search(&g->basis, g->program.h, SIZE_MAX, NULL, &guess) != FMB_OK ||
        guess == FMB_GUESS_NONE)
        return FMB_GENERAL_LOST;
    for (int k = 0; k < g->dim; k++)
        g->direction[k] = g->basis.normal[k];
    read_vertex_of_basis(g);
    return guess == FMB_GUESS_INSIDE ? FMB_GENERAL_GO : FMB_GENERAL_CLASH;
}

bool fmb_general_maximize(fmb_general *g, const double *cost, double *y)
{
    bool good = fmb_simplex_maximize(&g->basis, g->program.h, cost, y);
    read_vertex_of_basis(g);
    return good;
}

/* ---- a point inside -------------------------------------------------------------------------- */

/* The unknown that is closest to a bound. */
static int find_tightest_unknown(const fmb_general_system *s, const double *z)
{
    int tightest = 0;
    for (int j = 1; j < s->columns; j++)
        if (fmin(z[j], 1 - z[j]) < fmin(z[tightest], 1 - z[tightest]))
            tightest = j;
    return tightest;
}

/* The mean of vertices, each farthest from the bound to which the mean so far is closest. It ends
 * when that bound is not close, or no vertex is away from it. */
bool fmb_general_find_inside(fmb_general *g, double *z)
{
    const fmb_general_system *s = &g->program;
    double sum[FMB_GENERAL_MOST_COLUMNS], y[FMB_GENERAL_MOST_ROWS];
    for (int j = 0; j < s->columns; j++)
        z[j] = sum[j] = g->vertex[j];
    for (int n = 2; n < 2 * s->columns; n++) {
        double cost[FMB_GENERAL_MOST_COLUMNS] = {0};
        int j = find_tightest_unknown(s, z);
        double room = fmin(z[j], 1 - z[j]);
        if (room > 1.0 / 64)
            return true;
        cost[j] = z[j] < 0.5 ? 1 : -1;
        if (!fmb_general_maximize(g, cost, y))
            return false;
        if (fabs(g->vertex[j] - z[j]) <= room / 4)
            return room > 0;
        for (int k = 0; k < s->columns; k++) {
            sum[k] += g->vertex[k];
            z[k] = sum[k] / n;
        }
    }
    return true;
}
