/* bounded_simplex.c: see bounded_simplex.h.
 *
 * The search is the dual method. While the value of some basic unknown is out of its range, that
 * unknown leaves for the bound that it has passed, and an unknown enters that brings it back when
 * moved from its own bound; the largest such pivot is stable. If there is none, the row of the
 * inverse is a hyperplane with all possible sums on one side and the target on the other (Farkas).
 * Consecutive targets start from each other's bases. The primal method goes from vertex to vertex
 * by the largest gain. Both might cycle: they give up after a number of steps.
 *
 * Source: Dantzig 1955, Upper bounds, secondary constraints, and block triangularity; Lemke 1954,
 * The dual method of solving the linear programming problem.
 */
#include "lp/simplex/bounded/bounded_simplex.h"

#include <math.h>
#include <string.h>

/* Pivots after which errors have accumulated. */
#define STALE 100

/* ---- values ---------------------------------------------------------------------------------- */

/* The target minus the columns at their upper bounds. */
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
    if (j == SIZE_MAX)
        return;
    b->highs += (size_t)high - (size_t)b->is_high[j];
    b->is_high[j] = high;
}

/* ---- costs ----------------------------------------------------------------------------------- */

/* Is the unknown at place r bounded? */
static inline bool is_bounded(const fmb_basis *b, size_t r)
{
    return b->basic[r] != SIZE_MAX && b->range[b->basic[r]] != FMB_RANGE_FREE;
}

static inline bool is_unit_range(const fmb_basis *b, size_t r)
{
    return b->basic[r] != SIZE_MAX && b->range[b->basic[r]] == FMB_RANGE_UNIT;
}

/* In four independent sums, for parallel execution. */
static double dot_product(const double *a, const double *c, size_t d)
{
    double sum[4] = {0};
    size_t k = 0;
    for (; k + 4 <= d; k += 4)
        for (size_t i = 0; i < 4; i++)
            sum[i] += a[k + i] * c[k + i];
    for (; k < d; k++)
        sum[0] += a[k] * c[k];
    return sum[0] + sum[1] + (sum[2] + sum[3]);
}

/* The prices of the rows, y[d]: the costs of the basic columns times the inverse. */
static void find_prices(fmb_basis *b, const double *cost, double *y)
{
    size_t d = b->d;
    for (size_t r = 0; r < d; r++)
        b->entry[r] = b->basic[r] == SIZE_MAX ? 0 : cost[b->basic[r]];
    for (size_t k = 0; k < d; k++)
        y[k] = dot_product(&b->inverse.at[k * d], b->entry, d);
}

/* gain = cost - y a. */
static void find_gains(fmb_basis *b, const double *cost, const double *y)
{
    memcpy(b->gain, cost, b->size * sizeof *b->gain);
    for (size_t k = 0; k < b->d; k++)
        if (y[k] != 0)
            b->kernels->accumulate(b->gain, &b->at[k * b->capacity], b->size, -y[k]);
}

/* ---- the dual method ------------------------------------------------------------------------- */

/* The place whose value is farthest out of its range; the banned column's must be 0. */
static size_t find_leaving(const fmb_basis *b, size_t banned)
{
    size_t worst = SIZE_MAX;
    double most = b->value_zero;
    for (size_t r = 0; r < b->d; r++) {
        double excess = -b->value[r];
        if (b->basic[r] != SIZE_MAX && b->basic[r] == banned)
            excess = fabs(b->value[r]);
        else if (!is_bounded(b, r))
            continue;
        else if (is_unit_range(b, r))
            excess = fmax(excess, b->value[r] - 1);
        if (excess > most) {
            most = excess;
            worst = r;
        }
    }
    return worst;
}

/* How much column j helps if it enters. */
static inline double find_help(const fmb_basis *b, size_t j, double sign)
{
    double a = sign * b->price[j];
    return b->is_high[j] ? -a : b->range[j] == FMB_RANGE_FREE ? fabs(a) : a;
}

/* The column that enters best at place r: the one that helps most. */
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
        double a = find_help(b, j, sign);
        if (a > most && !b->is_basic[j] && j != banned && b->range[j] != FMB_RANGE_ZERO) {
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

/* Put column j, just written, at place r, whose column leaves for a bound; updates all values. */
static void pivot_columns(fmb_basis *b, size_t r, size_t j, double end)
{
    double from = b->is_high[j], way = (b->value[r] - end) / b->entry[r];
    fmb_basis_replace(b, r, j);
    for (size_t k = 0; k < b->d; k++)
        b->value[k] -= way * b->entry[k];
    b->value[r] = from + way;
}

/* Remove columns that may not be used any more from the basis, in favour of any that fit. */
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
            fmb_basis_write(b, j);
            pivot_columns(b, r, j, 0);
        } else {
            b->is_basic[b->basic[r]] = false;
            b->basic[r] = SIZE_MAX;
            b->inverse.is_unit[r] = true;
        }
    }
}

/* Values are recomputed before a result is accepted. */
fmb_status fmb_simplex_search(fmb_basis *b, const double *target, size_t banned, fmb_run *run,
                              fmb_guess *out)
{
    fmb_status st = FMB_OK;
    bool fresh = true;
    *out = FMB_GUESS_NONE;
    if (b->pivots > STALE)
        fmb_basis_invert(b);
    expel_zero_columns(b);
    find_values(b, target);
    for (size_t steps = 0; st == FMB_OK && steps < 16 * b->d + 64; steps++) {
        size_t r = find_leaving(b, banned);
        size_t j = r == SIZE_MAX ? SIZE_MAX : find_entering(b, r, banned);
        if (run)
            fmb_run_count(run, 80 + 2 * b->size + b->d * (b->size + b->d) / 4);
        if (j == SIZE_MAX && !fresh) {
            find_values(b, target);
            fresh = true;
            continue;
        }
        if (j == SIZE_MAX) {
            *out = r != SIZE_MAX ? FMB_GUESS_OUTSIDE : FMB_GUESS_INSIDE;
            if (r != SIZE_MAX)
                read_normal(b, r);
            return FMB_OK;
        }
        size_t old = b->basic[r];
        bool high = old != banned && b->value[r] > 1;
        fmb_basis_write(b, j);
        pivot_columns(b, r, j, high);
        put_at_end(b, old, high);
        fresh = false;
        st = run ? fmb_run_poll(run) : FMB_OK;
    }
    return st;
}

/* ---- the primal method ----------------------------------------------------------------------- */

/* The column with the largest gain when it leaves its bound, or SIZE_MAX. */
static size_t find_best_gain(const fmb_basis *b)
{
    double most = b->value_zero;
    size_t best = SIZE_MAX;
    for (size_t j = 0; j < b->size; j++) {
        double gain = b->is_high[j] ? -b->gain[j] : b->gain[j];
        if (gain > most && !b->is_basic[j]) {
            most = gain;
            best = j;
        }
    }
    return best;
}

/* How far the value of a basic unknown may go up or down until it is at a bound; to the nearer
 * bound if it is outside, and unlimited on its way farther out. */
static double find_room(double value, bool is_unit, bool up, bool *high)
{
    *high = up ? value >= 0 : is_unit && value > 1;
    if (up ? *high && (!is_unit || value > 1) : value < 0)
        return INFINITY;
    return up ? *high - value : value - *high;
}

/* Update the prices for column j, just written, at place r. */
static void update_prices(fmb_basis *b, size_t r, size_t j, double *y)
{
    double way = b->gain[j] / b->entry[r];
    fmb_dense_inverse_edge(&b->inverse, r, b->edge);
    for (size_t k = 0; k < b->d; k++)
        y[k] += way * b->edge[k];
}

/* Move unknown j from its bound until a basic one reaches a bound, or j its other one. False: the
 * move is unbounded. */
static bool leave_end(fmb_basis *b, size_t j, double *y)
{
    bool is_unit = b->range[j] == FMB_RANGE_UNIT, high = false, end;
    double way = is_unit ? 1 : INFINITY, weight = 0;
    size_t place = SIZE_MAX;
    fmb_basis_write(b, j);
    for (size_t r = 0; r < b->d; r++) {
        double rise = b->is_high[j] ? b->entry[r] : -b->entry[r];
        if (fabs(rise) < b->entry_zero || b->basic[r] == SIZE_MAX)
            continue;
        double reach = find_room(b->value[r], is_unit_range(b, r), rise > 0, &end) / fabs(rise);
        if (reach == INFINITY || reach > way || (reach == way && fabs(rise) < weight))
            continue;
        way = reach;
        weight = fabs(rise);
        place = r;
        high = end;
    }
    if (place != SIZE_MAX) {
        size_t old = b->basic[place];
        update_prices(b, place, j, y);
        pivot_columns(b, place, j, high);
        put_at_end(b, old, high);
    } else if (is_unit) {
        for (size_t r = 0; r < b->d; r++)
            b->value[r] += b->is_high[j] ? b->entry[r] : -b->entry[r];
        put_at_end(b, j, !b->is_high[j]);
    }
    return place != SIZE_MAX || is_unit;
}

bool fmb_simplex_maximize(fmb_basis *b, const double *target, const double *cost, double *y)
{
    bool goes_on = true;
    size_t j = 0, steps = 0;
    find_prices(b, cost, y);
    for (; goes_on && steps <= 16 * b->size; steps++) {
        find_gains(b, cost, y);
        j = find_best_gain(b);
        if (j == SIZE_MAX)
            break;
        goes_on = leave_end(b, j, y);
    }
    if (steps > 0) {
        find_values(b, target);
        find_prices(b, cost, y);
    }
    return j == SIZE_MAX;
}
