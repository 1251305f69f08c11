/* vertex_walk.c: see vertex_walk.h.
 *
 * Source: Dantzig 1955, Upper bounds, secondary constraints, and block triangularity.
 */
#include "pair/exact_box/vertex_walk.h"

#include <string.h>

/* Tolerances, only for guesses: a gain below this share of its terms counts as rounding error; an
 * entry below this share of the largest of its column is no pivot; a distance below this is 0. */
#define NO_GAIN     0x1p-44
#define NO_PIVOT    0x1p-36
#define NO_DISTANCE 0x1p-40

enum { MOST_STEPS = 128 };

static int group_of(const fmb_exact_box_walk *w, int unknown)
{
    return w->program->group[unknown];
}

/* The upper end of the place of an unknown. */
static double end_of(const fmb_exact_box_walk *w, int unknown)
{
    return w->program->near_end[fmb_exact_box_end_of(w->program, unknown)];
}

/* ---- the first basis ------------------------------------------------------------------------- */

static void put_row_of_world(fmb_exact_box_walk *w, int row)
{
    const fmb_exact_box_program *s = w->program;
    w->basic[row] = s->artificial + row;
    w->value[row] = s->h.near[row];
    for (int j = 0; j < s->columns; j++) {
        w->entry[row][j] = s->m[j].near[row];
        w->world[row][j] = j < s->first_of_b ? w->entry[row][j] : 0;
    }
    if (s->time >= 0)
        w->world[row][s->time] = s->speed[0].near[row];
}

static void put_row_of_simplex(fmb_exact_box_walk *w, int k)
{
    int row = w->rows++;
    w->basic[row] = w->program->slack + k;
    w->value[row] = w->program->near_end[k];
    for (int j = 0; j < w->columns; j++)
        w->entry[row][j] = group_of(w, j) == k;
}

static void put_first_basis(fmb_exact_box_walk *w, const fmb_exact_box_program *s)
{
    memset(w, 0, sizeof *w);
    w->program = s;
    w->rows = s->dim;
    w->columns = s->is_simplex[0] || s->is_simplex[1] ? s->artificial : s->columns;
    w->width = (w->columns + 1) / 2 * 2;
    for (int row = 0; row < s->dim; row++)
        put_row_of_world(w, row);
    for (int k = 0; k < 2; k++)
        if (s->is_simplex[k])
            put_row_of_simplex(w, k);
    for (int row = 0; row < w->rows; row++)
        w->basis.place[w->basic[row]] = FMB_EXACT_BOX_BASIC;
}

/* ---- steps ----------------------------------------------------------------------------------- */

/* The entering unknown with the best reduced cost, or -1. weight_r is the cost of the basic unknown
 * of row r. */
static int find_entering(const fmb_exact_box_walk *w, const double *cost, const double *weight)
{
    double gain[FMB_WALK_COLUMNS], size[FMB_WALK_COLUMNS], most = 0;
    int best = -1;
    for (int j = 0; j < w->width; j++) {
        gain[j] = cost[j];
        size[j] = fabs(cost[j]);
    }
    for (int r = 0; r < w->rows; r++) {
        if (weight[r] == 0)
            continue;
        for (int j = 0; j < w->width; j++) {
            double part = weight[r] * w->entry[r][j];
            gain[j] -= part;
            size[j] += fabs(part);
        }
    }
    for (int j = 0; j < w->columns; j++) {
        double up = w->basis.place[j] == FMB_EXACT_BOX_HIGH ? -gain[j] : gain[j];
        if (up > most && up > NO_GAIN * size[j] && w->basis.place[j] != FMB_EXACT_BOX_BASIC) {
            most = up;
            best = j;
        }
    }
    return best;
}

/* The distance by which the basic unknown of row r may increase (or decrease) to an end. */
static double find_room(const fmb_exact_box_walk *w, int r, bool up, bool *high)
{
    int group = group_of(w, w->basic[r]);
    double value = w->value[r];
    *high = up && group == FMB_EXACT_BOX_UNIT;
    if (group == FMB_EXACT_BOX_ZERO && fabs(value) > NO_DISTANCE)
        return up == (value < 0) ? fabs(value) : INFINITY;
    if (group == FMB_EXACT_BOX_ZERO)
        return 0;
    if (up && group != FMB_EXACT_BOX_UNIT)
        return INFINITY;
    value = up ? end_of(w, w->basic[r]) - value : value;
    return value > 0 ? value : 0;
}

/* Pivot: unknown j becomes basic in row r. */
static void pivot(fmb_exact_box_walk *w, int r, int j)
{
    double *row = w->entry[r], inverse = 1 / row[j];
    for (int k = 0; k < w->width; k++)
        row[k] *= inverse;
    row[j] = 1;
    for (int i = 0; i < w->rows; i++) {
        double factor = w->entry[i][j];
        if (i == r || factor == 0)
            continue;
        for (int k = 0; k < w->width; k++)
            w->entry[i][k] -= factor * row[k];
        w->entry[i][j] = 0;
    }
}

/* Unknown j enters: it moves until a basic unknown reaches an end, or j its other end. */
static void leave_end(fmb_exact_box_walk *w, int j)
{
    double sign = w->basis.place[j] == FMB_EXACT_BOX_HIGH ? -1 : 1, largest = 0;
    double way = group_of(w, j) == FMB_EXACT_BOX_UNIT ? end_of(w, j) : INFINITY, weight = 0;
    int leaving = -1;
    bool high = false, end;
    for (int r = 0; r < w->rows; r++)
        largest = fabs(w->entry[r][j]) > largest ? fabs(w->entry[r][j]) : largest;
    for (int r = 0; r < w->rows; r++) {
        double fall = sign * w->entry[r][j], speed = fabs(fall);
        if (speed <= NO_PIVOT * largest)
            continue;
        double reach = find_room(w, r, fall < 0, &end) / speed;
        if (reach > way || (reach == way && speed < weight) || reach == INFINITY)
            continue;
        way = reach;
        weight = speed;
        leaving = r;
        high = end;
    }
    if (way == INFINITY)
        return;
    for (int r = 0; r < w->rows; r++)
        w->value[r] -= sign * way * w->entry[r][j];
    if (leaving < 0) {
        w->basis.place[j] = sign > 0 ? FMB_EXACT_BOX_HIGH : FMB_EXACT_BOX_LOW;
        return;
    }
    w->basis.place[w->basic[leaving]] = high ? FMB_EXACT_BOX_HIGH : FMB_EXACT_BOX_LOW;
    w->basis.place[j] = FMB_EXACT_BOX_BASIC;
    w->basic[leaving] = j;
    w->value[leaving] = sign > 0 ? way : end_of(w, j) - way;
    pivot(w, leaving, j);
}

/* ---- walks ----------------------------------------------------------------------------------- */

/* Weights that minimize the artificial unknowns that are not 0. */
static bool weigh_artificial_unknowns(const fmb_exact_box_walk *w, double *weight)
{
    bool any = false;
    for (int r = 0; r < w->rows; r++) {
        bool is_off = w->basic[r] >= w->program->artificial && fabs(w->value[r]) > NO_DISTANCE;
        weight[r] = !is_off ? 0 : w->value[r] > 0 ? -1 : 1;
        any |= is_off;
    }
    return any;
}

static void note_weights(fmb_exact_box_walk *w, const double *weight)
{
    for (int r = 0; r < w->rows; r++) {
        int row = w->basic[r] - w->program->artificial;
        if (row >= 0)
            w->weight[row] = weight[r];
    }
}

bool fmb_exact_box_walk_start(fmb_exact_box_walk *w, const fmb_exact_box_program *s)
{
    static const double nothing[FMB_WALK_COLUMNS] = {0};
    double weight[FMB_WALK_ROWS];
    put_first_basis(w, s);
    for (int steps = 0; weigh_artificial_unknowns(w, weight); steps++) {
        int j = find_entering(w, nothing, weight);
        if (j < 0 || steps > MOST_STEPS) {
            note_weights(w, weight);
            return false;
        }
        leave_end(w, j);
    }
    return true;
}

bool fmb_exact_box_walk_to(fmb_exact_box_walk *w, const fmb_exact_box_goal *goal)
{
    double cost[FMB_WALK_COLUMNS] = {0}, weight[FMB_WALK_ROWS];
    for (int j = 0; j < w->width; j++) {
        double c = goal->is_world ? w->world[goal->number][j] : j == goal->number;
        cost[j] = goal->greatest ? c : -c;
    }
    for (int steps = 0; steps < MOST_STEPS; steps++) {
        for (int r = 0; r < w->rows; r++)
            weight[r] = w->basic[r] < w->width ? cost[w->basic[r]] : 0;
        int j = find_entering(w, cost, weight);
        if (j < 0)
            return true;
        leave_end(w, j);
    }
    return false;
}
