/* primal_simplex.c: the primal method; see simplex_methods.h.
 *
 * The point follows the edge of the largest gain for its length, by Devex weights, until a row
 * stops it: of those reached soon the one with the largest rate. If the point does not move for
 * long, right sides are perturbed a little at random.
 *
 * Source: Dantzig 1955, Upper bounds, secondary constraints, and block triangularity; Harris 1973,
 * Pivot selection methods of the Devex LP code; Wolfe 1963, A technique for resolving degeneracy in
 * linear programming.
 */
#include <math.h>

#include "lp/simplex/simplex_methods.h"

/* Rows with smaller rates do not stop the point; nor do rates below ROUNDING times the largest,
 * which may be rounding errors. */
#define NO_STOP  1e-9
#define ROUNDING 1e-14
/* Right sides are perturbed, by MOVE, after this many steps plus columns without a gain. */
#define PATIENCE 50
#define MOVE     1e-6

/* The place of the edge with the largest gain; FMB_NOWHERE: none gains. */
static size_t find_steepest_edge(const fmb_simplex_state *o)
{
    double most = 0, zero = fmb_simplex_state_tolerance(o);
    size_t best = FMB_NOWHERE;
    for (size_t r = 0; r < o->n; r++) {
        double gain = o->member_role[r] == FMB_ROLE_FREE ? fabs(o->y[r]) : -o->y[r];
        if (gain <= zero || o->member_role[r] == FMB_ROLE_EQUAL ||
            gain * gain <= most * o->edge_weight[r])
            continue;
        most = gain * gain / o->edge_weight[r];
        best = r;
    }
    return best;
}

static double find_largest_rate(const fmb_simplex_state *o)
{
    double largest = 0;
    for (size_t t = 0; t < fmb_indexed_vector_count(&o->rate); t++) {
        double rate = fabs(o->rate.at[fmb_indexed_vector_key(&o->rate, t)]);
        largest = rate > largest ? rate : largest;
    }
    return largest;
}

/* The rate at which the edge, with this sign, approaches row i; <= 0 if it does not. */
static inline double find_approach(const fmb_simplex_state *o, size_t i, double sign)
{
    double rate = o->rate.at[i];
    return o->row_role[i] == FMB_ROLE_LESS    ? sign * rate
           : o->row_role[i] == FMB_ROLE_EQUAL ? fabs(rate)
                                              : 0;
}

/* The distance to row i. */
static inline double find_distance(const fmb_simplex_state *o, size_t i)
{
    return o->row_role[i] == FMB_ROLE_EQUAL ? 0 : fmax(o->slack[i], 0);
}

static size_t find_stopping_row(const fmb_simplex_state *o, double sign)
{
    double zero = fmax(NO_STOP, ROUNDING * find_largest_rate(o)),
           slip = fmb_simplex_state_tolerance(o);
    double least = INFINITY, most = 0;
    size_t best = FMB_NOWHERE, count = fmb_indexed_vector_count(&o->rate);
    for (size_t t = 0; t < count; t++) {
        size_t i = fmb_indexed_vector_key(&o->rate, t);
        double rate = find_approach(o, i, sign);
        if (rate > zero)
            least = fmin(least, (find_distance(o, i) + slip) / rate);
    }
    for (size_t t = 0; t < count && least < INFINITY; t++) {
        size_t i = fmb_indexed_vector_key(&o->rate, t);
        double rate = find_approach(o, i, sign);
        if (rate > zero && rate > most && find_distance(o, i) <= least * rate) {
            most = rate;
            best = i;
        }
    }
    return best;
}

/* Update the Devex weights of edges. */
static void update_edge_weights(fmb_simplex_state *o, size_t r)
{
    double pivot = o->entry.at[r], scale = o->edge_weight[r] / (pivot * pivot);
    for (size_t t = 0; t < fmb_indexed_vector_count(&o->entry); t++) {
        size_t k = fmb_indexed_vector_key(&o->entry, t);
        double weight = o->entry.at[k] * o->entry.at[k] * scale;
        o->edge_weight[k] = weight > o->edge_weight[k] ? weight : o->edge_weight[k];
    }
    o->edge_weight[r] = fmax(1, scale);
}

/* Relax the inequalities a little, each by its own random share. */
static fmb_status move_right_sides(fmb_simplex_state *o)
{
    o->moved = true;
    for (size_t i = 0; i < o->m; i++)
        if (!fmb_scaled_program_is_equality(o->f, i))
            o->right[i] += MOVE * fmb_simplex_state_draw(o) * (1 + fabs(o->right[i]));
    return fmb_simplex_state_refresh(o);
}

/* The row that stops the point on edge r, written in the basis, or FMB_NOWHERE. *stale: its pivot
 * is doubtful, and may not be so with a recomputed basis. If the basis was just recomputed, the row
 * is skipped: its rate is a rounding error. */
static size_t find_certain_row(fmb_simplex_state *o, size_t r, bool *stale)
{
    fmb_simplex_state_look_along(o, r);
    for (;;) {
        size_t i = find_stopping_row(o, o->y[r] > 0 ? 1 : -1);
        if (i == FMB_NOWHERE)
            return i;
        fmb_basis_inverse_write(&o->basis, i, &o->entry);
        *stale = fmb_simplex_state_is_doubtful(o, r, i);
        if (!*stale || o->basis.pivots > 0)
            return i;
        o->rate.at[i] = 0;
    }
}

/* Exactly, for brief walks. */
static void measure_all_edges(fmb_simplex_state *o)
{
    fmb_dense_inverse_measure(&o->basis.inverse, o->edge_weight);
}

/* By complementary slackness the cost of the point is y times the right sides. */
static bool is_high_enough(const fmb_simplex_state *o)
{
    double sum = 0;
    for (size_t r = 0; o->is_brief && r < o->n; r++)
        sum += o->basis.member[r] < FMB_UNIT ? o->y[r] * o->right[o->basis.member[r]] : 0;
    return o->is_brief && sum > o->enough;
}

static fmb_status take_primal_step(fmb_simplex_state *o, fmb_simplex_end *end, size_t *odd)
{
    size_t r = is_high_enough(o) ? FMB_NOWHERE : find_steepest_edge(o);
    if (r == FMB_NOWHERE) {
        *end = FMB_SIMPLEX_DONE;
        return FMB_OK;
    }
    bool stale = false;
    size_t i = find_certain_row(o, r, &stale);
    if (i == FMB_NOWHERE) {
        *odd = r;
        *end = FMB_SIMPLEX_STOPPED;
        return FMB_OK;
    }
    if (stale)
        return fmb_simplex_state_renew(o);
    o->idle = o->slack[i] > fmb_simplex_state_tolerance(o) ? 0 : o->idle + 1;
    o->slack[i] = o->row_role[i] == FMB_ROLE_EQUAL ? o->slack[i] : fmax(o->slack[i], 0);
    if (!o->is_brief)
        update_edge_weights(o, r);
    fmb_status st = fmb_simplex_state_pivot(o, r, i);
    if (o->is_brief)
        measure_all_edges(o);
    else if (st == FMB_OK && o->idle > PATIENCE + o->n && !o->moved) {
        o->idle = 0;
        st = move_right_sides(o);
    }
    return st;
}

fmb_status fmb_primal_simplex(fmb_simplex_state *o, fmb_simplex_end *end, size_t *odd)
{
    o->idle = 0;
    for (size_t r = 0; !o->is_brief && r < o->n; r++)
        o->edge_weight[r] = 1;
    return fmb_simplex_walk(o, o->most_steps, take_primal_step,
                            o->is_brief ? measure_all_edges : NULL, end, odd);
}
