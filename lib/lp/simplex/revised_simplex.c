/* revised_simplex.c: the revised simplex method behind a backend; see backend_methods.h.
 *
 * It goes from vertex to vertex of the rows themselves: a search by the dual method, with a
 * cost that nobody asked for; then by the primal method to where the cost is greatest. Where that
 * moved right sides away, the dual method mends what it broke.
 */
#include <math.h>

#include "lp/simplex/backend_methods.h"
#include "lp/simplex/simplex_methods.h"

/* Bounds that are farther from 0 are no place to begin. */
#define FAR_BOUND 1e6
/* Times that right sides are moved before a search gives up. */
#define ROUNDS 3
/* What multipliers of about 0 become, without a cost and where the largest cost is about 1. */
#define NUDGE         1e-2
#define NUDGE_OF_COST 1e-4
/* The same where the primal method did not come to an end from the first vertex, and after how many
 * steps besides the number of columns it is taken not to. */
#define NEXT_NUDGE         1e-3
#define PATIENCE_OF_PRIMAL 1000

/* ---- questions ------------------------------------------------------------------------------- */

static void hand_out_members(const fmb_simplex_state *o, fmb_hint *h)
{
    for (size_t r = 0; r < o->n; r++) {
        size_t i = o->basis.member[r];
        h->basis[r] = i < FMB_UNIT ? i : o->m + (i - FMB_UNIT);
    }
}

static void restore_right_sides(fmb_simplex_state *o)
{
    if (o->m > 0)
        memcpy(o->right, o->f->right, o->m * sizeof *o->right);
    o->moved = false;
}

/* From multipliers that are those of an optimum to where the basis is primal feasible. */
static fmb_status search_on(fmb_simplex_state *o, fmb_hint *h)
{
    fmb_simplex_end end = FMB_SIMPLEX_ITERATION_LIMIT;
    fmb_status st = fmb_dual_simplex(o, &end, &h->odd);
    h->kind = end == FMB_SIMPLEX_STOPPED ? FMB_HINT_INFEASIBLE
              : end == FMB_SIMPLEX_DONE  ? FMB_HINT_OPTIMUM
                                         : FMB_HINT_NONE;
    return st;
}

/* Begin where bounds of columns meet: of each the one that lean.x prefers, or the one nearer to 0.
 */
static fmb_status start_at_bounds(fmb_simplex_state *o, const double *lean)
{
    double *bound = o->given;
    size_t *member = o->basis.old;
    for (size_t j = 0; j < o->n; j++) {
        member[j] = FMB_UNIT + j;
        bound[j] = FAR_BOUND;
    }
    for (size_t i = 0; i < o->m; i++) {
        if (o->f->p->row[i].size != 1 || o->f->off[i])
            continue;
        size_t j = (size_t)fmb_scaled_program_columns(o->f, i)[0];
        double a = o->f->value[o->f->start[i]], b = fabs(o->f->right[i] / a);
        bool preferred = lean && lean[j] * a > 0 && b < FAR_BOUND;
        if (b < bound[j] || preferred) {
            bound[j] = preferred ? 0 : b;
            member[j] = i;
        }
    }
    return fmb_simplex_state_place(o, member);
}

/* The cost is `lean`, but for what makes multipliers here negative: so much is added along their
 * rows that they are 0, as those of unit vectors become. All of inequalities are made a little
 * larger besides, each by a share of its own, so that few are equal on the way. */
static fmb_status lean_cost(fmb_simplex_state *o, const double *lean)
{
    memcpy(o->cost, lean, o->n * sizeof *o->cost);
    fmb_status st = fmb_simplex_state_refresh(o);
    for (size_t r = 0; st == FMB_OK && r < o->n; r++) {
        double y = o->y[r], share = o->nudge * fmb_simplex_state_draw(o);
        if (o->member_role[r] == FMB_ROLE_FREE)
            fmb_simplex_state_add_to_cost(o, r, -y);
        else if (o->member_role[r] == FMB_ROLE_LESS)
            fmb_simplex_state_add_to_cost(o, r, y < 0 ? share - y : share * (1 + 10 * y));
    }
    return st;
}

static fmb_status search_with_nudge(fmb_simplex_state *o, const double *lean, double nudge,
                                    fmb_hint *h)
{
    fmb_status st = FMB_OK;
    if (!o->placed)
        st = start_at_bounds(o, lean);
    o->placed = true;
    o->steps = 0;
    o->nudge = nudge;
    memset(o->cost, 0, o->n * sizeof *o->cost);
    if (st == FMB_OK && lean)
        st = lean_cost(o, lean);
    if (st == FMB_OK)
        st = search_on(o, h);
    hand_out_members(o, h);
    return st;
}

static fmb_status search_own(void *self, const double *lean, fmb_hint *h)
{
    return search_with_nudge(self, lean, lean ? NUDGE_OF_COST : NUDGE, h);
}

/* From a vertex that is primal feasible. */
static fmb_status climb_to_optimum(fmb_simplex_state *o, const double *cost, fmb_hint *h)
{
    fmb_simplex_end end = FMB_SIMPLEX_ITERATION_LIMIT;
    fmb_status st = FMB_OK;
    for (int round = 0; st == FMB_OK && o->feasible && round < ROUNDS; round++) {
        memcpy(o->cost, cost, o->n * sizeof *o->cost);
        st = fmb_primal_simplex(o, &end, &h->odd);
        h->kind = end == FMB_SIMPLEX_DONE      ? FMB_HINT_OPTIMUM
                  : end == FMB_SIMPLEX_STOPPED ? FMB_HINT_UNBOUNDED
                                               : FMB_HINT_NONE;
        if (!o->moved)
            return st;
        h->kind = FMB_HINT_NONE;
        restore_right_sides(o);
        o->feasible = false;
        if (st == FMB_OK)
            st = search_on(o, h);
        if (o->feasible)
            h->kind = FMB_HINT_NONE;
    }
    return st;
}

/* From the bounds again, leaning to the cost with other shares: another vertex, and another way. */
static fmb_status begin_again(fmb_simplex_state *o, const double *cost, fmb_hint *h)
{
    o->placed = false;
    restore_right_sides(o);
    o->most_steps = fmb_simplex_most_pivots(o);
    fmb_status st = search_with_nudge(o, cost, NEXT_NUDGE, h);
    h->kind = FMB_HINT_NONE;
    o->steps = 0;
    return st == FMB_OK && o->feasible ? climb_to_optimum(o, cost, h) : st;
}

static fmb_status maximize_own(void *self, const double *cost, fmb_hint *h)
{
    fmb_simplex_state *o = self;
    fmb_status st = FMB_OK;
    h->kind = FMB_HINT_NONE;
    o->steps = 0;
    if (!o->feasible)
        st = search_own(o, NULL, h);
    o->most_steps = o->steps + PATIENCE_OF_PRIMAL + o->n;
    if (st == FMB_OK && o->feasible)
        st = climb_to_optimum(o, cost, h);
    if (st == FMB_OK && h->kind == FMB_HINT_NONE && o->steps > o->most_steps)
        st = begin_again(o, cost, h);
    hand_out_members(o, h);
    return st;
}

static void point_of_own(void *self, double *x)
{
    fmb_simplex_state *o = self;
    fmb_simplex_state_find_point(o);
    memcpy(x, o->edge.at, o->n * sizeof *x);
}

/* ---- changes --------------------------------------------------------------------------------- */

/* The place of row i in the basis, or FMB_NOWHERE. */
static size_t find_member(const fmb_simplex_state *o, size_t i)
{
    for (size_t r = 0; r < o->n; r++)
        if (o->basis.member[r] == i)
            return r;
    return FMB_NOWHERE;
}

/* A row that is left out leaves the basis, whose members may change places before. */
static fmb_status switch_own(void *self, size_t i)
{
    fmb_simplex_state *o = self;
    bool off = o->f->off[i], leaves = off && find_member(o, i) != FMB_NOWHERE;
    fmb_status st = leaves ? fmb_simplex_state_refresh(o) : FMB_OK;
    size_t r = leaves ? find_member(o, i) : FMB_NOWHERE;
    o->feasible = o->feasible && off;
    if (st == FMB_OK && r != FMB_NOWHERE)
        return fmb_simplex_state_expel(o, r);
    fmb_simplex_state_note_role(o, i);
    return st;
}

static fmb_status place_own(void *self, const size_t *basis)
{
    fmb_simplex_state *o = self;
    for (size_t r = 0; r < o->n; r++)
        o->basis.member[r] = basis[r] < o->m ? basis[r] : FMB_UNIT + (basis[r] - o->m);
    o->feasible = false;
    o->placed = true;
    return fmb_simplex_state_place(o, o->basis.member);
}

static void shift_own(void *self)
{
    fmb_simplex_state *o = self;
    restore_right_sides(o);
    o->feasible = false;
}

/* Where the row is not in the basis, the point stays. */
static void shift_row_of_own(void *self, size_t i)
{
    fmb_simplex_state *o = self;
    double by = o->f->right[i] - o->right[i];
    if (o->moved || !o->placed || find_member(o, i) != FMB_NOWHERE) {
        shift_own(self);
        return;
    }
    o->right[i] += by;
    o->slack[i] += by;
    o->feasible = o->feasible && by >= 0;
}

static fmb_status grow_own(void *self)
{
    return fmb_simplex_state_grow(self);
}

/* ---- life ------------------------------------------------------------------------------------ */

static void close_own(void *self)
{
    fmb_simplex_state *o = self;
    fmb_mem *mem = o->f->run->mem;
    fmb_simplex_state_clear(o);
    fmb_mem_put(mem, o, 1, sizeof *o);
}

static fmb_status open_state(const fmb_scaled_program *f, bool factors, void **out)
{
    fmb_simplex_state *o = fmb_mem_get(f->run->mem, 1, sizeof *o);
    if (!o)
        return fmb_mem_status(f->run->mem);
    fmb_status st = fmb_simplex_state_init(o, f, factors);
    if (st == FMB_OK)
        *out = o;
    else
        close_own(o);
    return st;
}

static fmb_status open_own(const fmb_scaled_program *f, void **out)
{
    return open_state(f, false, out);
}

static fmb_status open_own_factors(const fmb_scaled_program *f, void **out)
{
    return open_state(f, true, out);
}

const fmb_backend_methods fmb_backend_revised_simplex = {
    open_own,   close_own, search_own, maximize_own,     grow_own,
    switch_own, place_own, shift_own,  shift_row_of_own, point_of_own};
const fmb_backend_methods fmb_backend_revised_simplex_lu = {
    open_own_factors, close_own, search_own, maximize_own,     grow_own,
    switch_own,       place_own, shift_own,  shift_row_of_own, point_of_own};
