/* simplex.c: see simplex.h.
 *
 * The search is the dual method without costs. While the value of some basic unknown is out of its
 * range, it leaves for the end that it has passed, and an unknown comes in whose own way from its
 * end brings it back there; the largest such entry keeps the numbers good. If there is none, the
 * row of the inverse is a hyperplane with all that is possible on one side and the target on the
 * other (Farkas). Consecutive targets start from each other's bases. The primal method then goes
 * from vertex to vertex by the greatest gain. Both might cycle: they give up after a number of
 * steps.
 *
 * Source: Dantzig 1955, Upper bounds, secondary constraints, and block triangularity; Lemke 1954,
 * The dual method of solving the linear programming problem.
 */
#include "lp/simplex/simplex.h"

#include <math.h>
#include <string.h>

/* Pivots after which errors have gathered. */
#define STALE 100

/* ---- values ---------------------------------------------------------------------------------- */

/* The target less what stands high. */
static const double *subtract_high_columns(fmb_basis *b, const double *target)
{
    if (b->highs == 0)
        return target;
    memcpy(b->rest, target, b->d * sizeof *b->rest);
    for (size_t j = 0; j < b->size; j++)
        for (size_t k = 0; b->is_high[j] && k < b->d; k++)
            b->rest[k] -= b->at[k * b->capacity + j];
    return b->rest;
}

static void find_values(fmb_basis *b, const double *target)
{
    fmb_dense_inverse_write(&b->inverse, subtract_high_columns(b, target), b->value);
}

static void put_at_end(fmb_basis *b, size_t j, bool high)
{
    b->highs += (size_t)high - (size_t)b->is_high[j];
    b->is_high[j] = high;
}

/* ---- the dual method ------------------------------------------------------------------------- */

/* The place whose value is most out of its range; that of the banned column is not to be there. */
static size_t find_leaving(const fmb_basis *b, size_t banned)
{
    size_t worst = SIZE_MAX;
    double most = b->value_zero;
    for (size_t r = 0; r < b->d; r++) {
        size_t j = b->basic[r];
        double excess = -b->value[r];
        if (j != SIZE_MAX && j == banned)
            excess = fabs(b->value[r]);
        else if (j == SIZE_MAX || b->range[j] == FMB_RANGE_FREE)
            continue;
        else if (b->range[j] == FMB_RANGE_UNIT)
            excess = fmax(excess, b->value[r] - 1);
        if (excess > most) {
            most = excess;
            worst = r;
        }
    }
    return worst;
}

/* The column that best takes place r. */
static size_t find_entering(fmb_basis *b, size_t r, size_t banned)
{
    const double *row = b->edge;
    double sign = b->value[r] < 0 ? -1 : 1, most = b->entry_zero;
    size_t best = SIZE_MAX;
    fmb_dense_inverse_edge(&b->inverse, r, b->edge);
    memset(b->price, 0, b->size * sizeof *b->price);
    for (size_t k = 0; k < b->d; k++)
        if (row[k] != 0)
            b->kernels->accumulate(b->price, &b->at[k * b->capacity], b->size, row[k]);
    for (size_t j = 0; j < b->size; j++) {
        double a = sign * b->price[j];
        if (b->range[j] == FMB_RANGE_FREE || b->is_high[j])
            a = b->is_high[j] ? -a : fabs(a);
        if (a > most && j != banned && !b->is_basic[j] && b->range[j] != FMB_RANGE_ZERO) {
            most = a;
            best = j;
        }
    }
    return best;
}

static void read_normal(fmb_basis *b, size_t r)
{
    double sign = b->value[r] < 0 ? 1 : -1;
    for (size_t k = 0; k < b->d; k++)
        b->normal[k] = sign * b->inverse.at[k * b->d + r];
}

static void pivot_columns(fmb_basis *b, size_t r, size_t j)
{
    fmb_basis_write(b, j);
    fmb_basis_replace(b, r, j);
}

/* A column that is no longer to be used leaves the basis for whatever fits. */
static void expel_zero_columns(fmb_basis *b)
{
    for (size_t r = 0; r < b->d; r++) {
        if (b->basic[r] == SIZE_MAX || b->range[b->basic[r]] != FMB_RANGE_ZERO)
            continue;
        b->value[r] = 1;
        size_t j = find_entering(b, r, SIZE_MAX);
        b->value[r] = -1;
        j = j != SIZE_MAX ? j : find_entering(b, r, SIZE_MAX);
        if (j != SIZE_MAX) {
            pivot_columns(b, r, j);
        } else {
            b->is_basic[b->basic[r]] = false;
            b->basic[r] = SIZE_MAX;
            b->inverse.is_unit[r] = true;
        }
    }
}

fmb_status fmb_simplex_search(fmb_basis *b, const double *target, size_t banned, fmb_run *run,
                              fmb_guess *out)
{
    fmb_status st = FMB_OK;
    *out = FMB_GUESS_NONE;
    if (b->pivots > STALE)
        fmb_basis_invert(b);
    expel_zero_columns(b);
    for (size_t steps = 0; st == FMB_OK && steps < 8 * b->d + 32; steps++) {
        find_values(b, target);
        size_t r = find_leaving(b, banned);
        if (r == SIZE_MAX) {
            *out = FMB_GUESS_INSIDE;
            return FMB_OK;
        }
        size_t j = find_entering(b, r, banned), old = b->basic[r];
        if (j == SIZE_MAX) {
            read_normal(b, r);
            *out = FMB_GUESS_OUTSIDE;
            return FMB_OK;
        }
        pivot_columns(b, r, j);
        put_at_end(b, old, old != banned && b->value[r] > 1);
        if (run)
            fmb_run_count(run, b->d * (b->size + b->d) / 4);
        st = run ? fmb_run_poll(run) : FMB_OK;
    }
    return st;
}

/* ---- the primal method ----------------------------------------------------------------------- */

/* y: the costs of the basic columns times the inverse; price = cost - y a, what a unit of each
 * unknown brings. */
static void find_gains(fmb_basis *b, const double *cost, double *y)
{
    memset(y, 0, b->d * sizeof *y);
    for (size_t r = 0; r < b->d; r++) {
        double c = b->basic[r] == SIZE_MAX ? 0 : cost[b->basic[r]];
        for (size_t k = 0; c != 0 && k < b->d; k++)
            y[k] += c * b->inverse.at[k * b->d + r];
    }
    memcpy(b->price, cost, b->size * sizeof *b->price);
    for (size_t k = 0; k < b->d; k++)
        if (y[k] != 0)
            b->kernels->accumulate(b->price, &b->at[k * b->capacity], b->size, -y[k]);
}

/* The column that gains most when it leaves its end, or SIZE_MAX. */
static size_t find_best_gain(const fmb_basis *b)
{
    double most = b->value_zero;
    size_t best = SIZE_MAX;
    for (size_t j = 0; j < b->size; j++) {
        double gain = b->is_high[j] ? -b->price[j] : b->price[j];
        if (gain > most && !b->is_basic[j]) {
            most = gain;
            best = j;
        }
    }
    return best;
}

/* How far the value of a basic unknown may go up or down until it is at an end; to the near one if
 * it is outside, and nothing stops it on its way farther out. */
static double find_room(double value, bool is_unit, bool up, bool *high)
{
    *high = up ? value >= 0 : is_unit && value > 1;
    if (up ? *high && (!is_unit || value > 1) : value < 0)
        return INFINITY;
    return up ? *high - value : value - *high;
}

/* Move unknown j from its end until a basic one comes to an end, or j to its other one. */
static void leave_end(fmb_basis *b, size_t j)
{
    bool is_unit = b->range[j] == FMB_RANGE_UNIT, high = false, end;
    double way = is_unit ? 1 : INFINITY, weight = 0;
    size_t place = SIZE_MAX;
    fmb_basis_write(b, j);
    for (size_t r = 0; r < b->d; r++) {
        double rise = b->is_high[j] ? b->entry[r] : -b->entry[r];
        if (fabs(rise) < b->entry_zero || b->basic[r] == SIZE_MAX)
            continue;
        bool is_basic_unit = b->range[b->basic[r]] == FMB_RANGE_UNIT;
        double reach = find_room(b->value[r], is_basic_unit, rise > 0, &end) / fabs(rise);
        if (reach == INFINITY || reach > way || (reach == way && fabs(rise) < weight))
            continue;
        way = reach;
        weight = fabs(rise);
        place = r;
        high = end;
    }
    if (place != SIZE_MAX) {
        size_t old = b->basic[place];
        fmb_basis_replace(b, place, j);
        put_at_end(b, old, high);
    } else if (is_unit) {
        put_at_end(b, j, !b->is_high[j]);
    }
}

bool fmb_simplex_maximize(fmb_basis *b, const double *target, const double *cost, double *y)
{
    for (size_t steps = 0; steps < 16 * b->size; steps++) {
        find_gains(b, cost, y);
        size_t j = find_best_gain(b);
        if (j == SIZE_MAX)
            return true;
        leave_end(b, j);
        find_values(b, target);
    }
    return false;
}
