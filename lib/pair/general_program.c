/* general_program.c: linear programs over the common points of a pair, in doubles: guesses too.
 *
 * The system of the pair, with a slack for the sum of each simplex, so that every unknown has ends
 * of its own: 0, and 1 unless it is summed. A vertex has all unknowns but the pivots at an end.
 * This is the simplex method with bounds (Dantzig 1955), on the table that Gauss and Jordan's
 * elimination left.
 */
#include "pair/general_inside.h"

#include <math.h>

/* Less than this is taken for the rounding error of 0, in values and costs: a guess. */
#define NOTHING 0x1p-46

/* ---- the system ------------------------------------------------------------------------------ */

/* The pair; for each simplex a row c_1 + ... + slack = 1. */
static void load(const fmb_general_system *pair, fmb_general_system *s)
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

/* z of the vertex. Rows have 0 in the columns of other rows' pivots. */
static void place(fmb_general *g)
{
    const fmb_general_system *s = &g->program;
    for (int j = 0; j < s->columns; j++)
        g->vertex[j] = g->is_high[j] && !s->is_pivot[j];
    for (int i = 0; i < s->rows; i++) {
        const double *row = fmb_general_solved(s, i);
        double value = row[s->columns];
        for (int j = 0; j < s->columns; j++)
            value -= row[j] * (g->is_high[j] && !s->is_pivot[j]);
        g->vertex[s->pivot[i]] = value;
    }
}

/* ---- one step -------------------------------------------------------------------------------- */

/* y: the costs of the pivots times R; gain: cost - y M, what a unit of each unknown brings. */
static void price(const fmb_general_system *s, const double *cost, double *gain, double *y)
{
    for (int j = 0; j < s->columns; j++)
        gain[j] = cost[j];
    for (int k = 0; k < s->rows; k++)
        y[k] = 0;
    for (int i = 0; i < s->rows; i++) {
        const double *row = fmb_general_solved(s, i), *inverse = fmb_general_inverse(s, i);
        double c = cost[s->pivot[i]];
        if (c == 0)
            continue;
        for (int j = 0; j < s->columns; j++)
            gain[j] -= c * row[j];
        for (int k = 0; k < s->rows; k++)
            y[k] += c * inverse[k];
    }
}

/* The column that brings most when it leaves its end, or -1. */
static int find_gain(const fmb_general *g, const double *gain)
{
    const fmb_general_system *s = &g->program;
    double most = NOTHING;
    int best = -1;
    for (int j = 0; j < s->columns; j++) {
        double more = g->is_high[j] ? -gain[j] : gain[j];
        if (!s->is_pivot[j] && more > most) {
            most = more;
            best = j;
        }
    }
    return best;
}

/* How far the value of a pivot may go up or down until it is at an end; to the near one if it is
 * outside, and nothing stops it on its way farther out. */
static double find_room(double value, bool is_unit, bool up, bool *high)
{
    *high = up ? value >= 0 : is_unit && value > 1;
    if (up ? *high && (!is_unit || value > 1) : value < 0)
        return INFINITY;
    return up ? *high - value : value - *high;
}

/* Move unknown j from its end until a pivot comes to one, or j to its other end. */
static void move(fmb_general *g, int j)
{
    fmb_general_system *s = &g->program;
    double way = s->kind[j] == FMB_GENERAL_UNIT ? 1 : INFINITY, weight = 0;
    int row = -1;
    bool high = false, end;
    for (int i = 0; i < s->rows; i++) {
        double t = fmb_general_solved(s, i)[j], rise = g->is_high[j] ? t : -t;
        bool is_unit = s->kind[s->pivot[i]] == FMB_GENERAL_UNIT;
        double reach = find_room(g->vertex[s->pivot[i]], is_unit, rise > 0, &end) / fabs(rise);
        if (fabs(rise) < 0x1p-30 || reach == INFINITY || reach > way ||
            (reach == way && fabs(rise) < weight))
            continue;
        way = reach;
        weight = fabs(rise);
        row = i;
        high = end;
    }
    if (row < 0 && s->kind[j] == FMB_GENERAL_UNIT) {
        g->is_high[j] = !g->is_high[j];
    } else if (row >= 0) {
        g->is_high[s->pivot[row]] = high;
        fmb_general_pivot(s, row, j);
    }
    place(g);
}

/* ---- vertices -------------------------------------------------------------------------------- */

/* 1 for pivots that should grow, -1 for those that should shrink; how many there are. */
static int find_outside(const fmb_general *g, double *cost)
{
    const fmb_general_system *s = &g->program;
    int outside = 0;
    for (int j = 0; j < s->columns; j++) {
        bool is_unit = s->kind[j] == FMB_GENERAL_UNIT;
        cost[j] = (g->vertex[j] < -NOTHING) - (is_unit && g->vertex[j] > 1 + NOTHING);
        outside += cost[j] != 0;
    }
    return outside;
}

/* As long as pivots are outside their places, less so in sum with each step. */
fmb_general_step fmb_general_find_vertex(fmb_general *g)
{
    fmb_general_system *s = &g->program;
    double cost[FMB_GENERAL_MOST_COLUMNS], gain[FMB_GENERAL_MOST_COLUMNS];
    double y[FMB_GENERAL_MOST_ROWS];
    load(&g->pair, s);
    fmb_general_solve(s);
    if (s->rank < s->rows)
        return FMB_GENERAL_LOST;
    for (int j = 0; j < s->columns; j++)
        g->is_high[j] = false;
    place(g);
    for (int tries = 0; tries < 16 * s->columns; tries++) {
        if (find_outside(g, cost) == 0)
            return FMB_GENERAL_GO;
        price(s, cost, gain, y);
        int j = find_gain(g, gain);
        if (j < 0) {
            for (int k = 0; k < g->dim; k++)
                g->direction[k] = y[k];
            return FMB_GENERAL_CLASH;
        }
        move(g, j);
    }
    return FMB_GENERAL_LOST;
}

bool fmb_general_maximize(fmb_general *g, const double *cost, double *y)
{
    fmb_general_system *s = &g->program;
    double gain[FMB_GENERAL_MOST_COLUMNS];
    for (int tries = 0; tries < 16 * s->columns; tries++) {
        price(s, cost, gain, y);
        int j = find_gain(g, gain);
        if (j < 0)
            return true;
        move(g, j);
    }
    return false;
}

/* ---- a point inside -------------------------------------------------------------------------- */

/* The unknown that is closest to an end. */
static int find_tightest(const fmb_general_system *s, const double *z)
{
    int tightest = 0;
    for (int j = 1; j < s->columns; j++)
        if (fmin(z[j], 1 - z[j]) < fmin(z[tightest], 1 - z[tightest]))
            tightest = j;
    return tightest;
}

/* The mean of vertices, each the farthest from the end that the mean of those before is closest to.
 * It stops when that is not close, or where nothing leads away from it. */
bool fmb_general_find_inside(fmb_general *g, double *z)
{
    const fmb_general_system *s = &g->program;
    double sum[FMB_GENERAL_MOST_COLUMNS], y[FMB_GENERAL_MOST_ROWS];
    for (int j = 0; j < s->columns; j++)
        z[j] = sum[j] = g->vertex[j];
    for (int n = 2; n < 2 * s->columns; n++) {
        double cost[FMB_GENERAL_MOST_COLUMNS] = {0};
        int j = find_tightest(s, z);
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
