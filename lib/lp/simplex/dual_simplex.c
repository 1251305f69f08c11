/* dual_simplex.c: the dual method; see simplex_methods.h.
 *
 * The most violated row enters, and the member leaves whose multiplier would be the first to become
 * negative; a unit vector leaves before any other member. For each row that enters with a
 * multiplier of about 0, the cost is increased a little along it, at random: so each step makes
 * progress, and no vertex comes twice.
 *
 * Source: Lemke 1954, The dual method of solving the linear programming problem; Harris 1973, Pivot
 * selection methods of the Devex LP code.
 */
#include <math.h>

#include "lp/simplex/simplex_methods.h"

#define PATIENCE_OF_DUAL 200

/* Multipliers may be negative by this much; entries below this times the largest are no pivots.
 */
static double find_zero_of_multipliers(const fmb_simplex_state *o)
{
    return o->f->sharp ? 1e-12 : 1e-9;
}

/* Likewise for a unit vector, which need not leave. */
static double find_zero_of_units(const fmb_simplex_state *o)
{
    return o->f->sharp ? 1e-12 : 1e-7;
}

/* The violation of row i, outside of the basis and not off; 0 if it may be a rounding error. */
static inline double find_excess(const fmb_simplex_state *o, size_t i)
{
    double excess = o->row_role[i] == FMB_ROLE_EQUAL ? fabs(o->slack[i]) : -o->slack[i];
    double zero = fmb_simplex_state_tolerance(o);
    bool counts = excess > zero && o->row_role[i] != FMB_ROLE_FREE;
    return counts && excess > zero * fabs(o->right[i]) ? excess : 0;
}

static void list_if_violated(fmb_simplex_state *o, size_t i)
{
    if (o->is_listed[i] || find_excess(o, i) == 0)
        return;
    o->is_listed[i] = true;
    o->violated[o->violations++] = (int)i;
}

static void list_all_violated(fmb_simplex_state *o)
{
    if (o->m > 0)
        memset(o->is_listed, 0, o->m * sizeof *o->is_listed);
    o->violations = 0;
    for (size_t i = 0; i < o->m; i++)
        list_if_violated(o, i);
}

/* List newly violated rows after a step along the edge. */
static void list_newly_violated(fmb_simplex_state *o)
{
    for (size_t t = 0; t < fmb_indexed_vector_count(&o->rate); t++)
        list_if_violated(o, fmb_indexed_vector_key(&o->rate, t));
}

/* The most violated row by Devex weights; FMB_NOWHERE: all hold. Rows that hold are removed from
 * the list. */
static size_t find_violated_row(fmb_simplex_state *o)
{
    double most = 0;
    size_t best = FMB_NOWHERE, kept = 0;
    for (size_t t = 0; t < o->violations; t++) {
        size_t i = (size_t)o->violated[t];
        double excess = find_excess(o, i);
        o->is_listed[i] = excess > 0;
        o->violated[kept] = (int)i;
        kept += excess > 0;
        if (excess * excess <= most * o->row_weight[i])
            continue;
        most = excess * excess / o->row_weight[i];
        best = i;
    }
    o->violations = kept;
    return best;
}

/* The entries of a row in the basis: the largest, the largest at a unit vector; o->falling lists
 * the multipliers of inequalities that decrease when the row enters with this sign. */
typedef struct entries {
    double largest, of_unit;
    size_t unit, falling;
} entries;

static entries look_at_entries(fmb_simplex_state *o, double sign)
{
    entries e = {.unit = FMB_NOWHERE};
    for (size_t t = 0, count = fmb_indexed_vector_count(&o->entry); t < count; t++) {
        size_t r = fmb_indexed_vector_key(&o->entry, t);
        double entry = sign * o->entry.at[r], size = fabs(entry);
        e.largest = size > e.largest ? size : e.largest;
        if (o->member_role[r] == FMB_ROLE_LESS && entry > 0) {
            o->falling[e.falling++] = (int)r;
        } else if (o->member_role[r] == FMB_ROLE_FREE && size > e.of_unit) {
            e.of_unit = size;
            e.unit = r;
        }
    }
    return e;
}

/* The leaving member: of those whose multiplier soon becomes negative as the row enters with this
 * sign, the one with the largest entry. */
static size_t find_leaving_member(const fmb_simplex_state *o, size_t falling, double sign,
                                  double zero)
{
    double least = INFINITY, most = 0, slip = find_zero_of_multipliers(o);
    size_t best = FMB_NOWHERE;
    for (size_t t = 0; t < falling; t++) {
        int r = o->falling[t];
        double entry = sign * o->entry.at[r], y = o->y[r] > 0 ? o->y[r] : 0;
        if (entry > zero && y + slip < least * entry)
            least = (y + slip) / entry;
    }
    for (size_t t = 0; t < falling && least < INFINITY; t++) {
        int r = o->falling[t];
        double entry = sign * o->entry.at[r];
        if (entry > zero && entry > most && o->y[r] <= least * entry) {
            most = entry;
            best = (size_t)r;
        }
    }
    return best;
}

static size_t find_leaving_place(fmb_simplex_state *o, double sign)
{
    entries e = look_at_entries(o, sign);
    return e.of_unit > find_zero_of_units(o) * e.largest
               ? e.unit
               : find_leaving_member(o, e.falling, sign, find_zero_of_multipliers(o) * e.largest);
}

/* Update the Devex weights of rows. */
static void update_row_weights(fmb_simplex_state *o, size_t r, size_t i)
{
    double own = o->row_weight[i], pivot = o->entry.at[r];
    double scale = own / (pivot * pivot);
    size_t old = o->basis.member[r];
    for (size_t t = 0; t < fmb_indexed_vector_count(&o->rate); t++) {
        size_t k = fmb_indexed_vector_key(&o->rate, t);
        double weight = o->rate.at[k] * o->rate.at[k] * scale;
        o->row_weight[k] = weight > o->row_weight[k] ? weight : o->row_weight[k];
    }
    if (old < FMB_UNIT)
        o->row_weight[old] = fmax(1, scale);
}

static fmb_status take_dual_step(fmb_simplex_state *o, fmb_simplex_end *end, size_t *odd)
{
    size_t i = find_violated_row(o);
    if (i == FMB_NOWHERE) {
        *end = FMB_SIMPLEX_DONE;
        return FMB_OK;
    }
    double sign = o->slack[i] < 0 ? 1 : -1;
    fmb_basis_inverse_write(&o->basis, i, &o->entry);
    size_t r = find_leaving_place(o, sign);
    if (r == FMB_NOWHERE) {
        *odd = i;
        *end = FMB_SIMPLEX_STOPPED;
        return FMB_OK;
    }
    fmb_simplex_state_look_along(o, r);
    if (o->basis.pivots > 0 && fmb_simplex_state_is_doubtful(o, r, i)) {
        fmb_status st = fmb_simplex_state_renew(o);
        list_all_violated(o);
        return st;
    }
    update_row_weights(o, r, i);
    fmb_status st = fmb_simplex_state_pivot(o, r, i);
    list_newly_violated(o);
    if (st == FMB_OK && o->member_role[r] == FMB_ROLE_LESS && o->y[r] < o->nudge / 10 &&
        o->steps > PATIENCE_OF_DUAL + o->n)
        fmb_simplex_state_add_to_cost(o, r, o->nudge * fmb_simplex_state_draw(o));
    return st;
}

fmb_status fmb_dual_simplex(fmb_simplex_state *o, fmb_simplex_end *end, size_t *odd)
{
    for (size_t i = 0; i < o->m; i++)
        o->row_weight[i] = 1;
    fmb_status st = fmb_simplex_walk(o, fmb_simplex_most_pivots(o), take_dual_step,
                                     list_all_violated, end, odd);
    o->feasible = *end == FMB_SIMPLEX_DONE && !o->moved;
    return st;
}
