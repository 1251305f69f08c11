/* backend.c: the revised simplex method; see backend.h.
 *
 * It goes from vertex to vertex of the rows themselves: a search by the dual method, with an
 * auxiliary cost; then to the largest cost by the primal method. If that perturbed right sides, the
 * dual method restores feasibility.
 */
#include "lp/simplex/backend.h"

#include <math.h>

#include "lp/simplex/first_basis.h"
#include "lp/simplex/simplex_methods.h"

/* Bounds farther from 0 are no starting points. */
#define FAR_BOUND 1e6
/* Most rounds with perturbed right sides before a maximization gives up. */
#define ROUNDS 3
/* Values given to multipliers of about 0: without a cost, and if the largest cost is about 1. */
#define NUDGE         1e-2
#define NUDGE_OF_COST 1e-4

struct fmb_backend {
    fmb_scaled_program scaled;
    fmb_simplex_state state; /* of `scaled` */
    double *cost;            /* [n] scaled as the columns are */
    fmb_status late;         /* the status of a function without one */
    bool behind;             /* there are rows that the state lacks */
};

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

/* From a dual feasible basis, walk to a primal feasible one. */
static fmb_status search_on(fmb_simplex_state *o, fmb_hint *h)
{
    fmb_simplex_end end = FMB_SIMPLEX_ITERATION_LIMIT;
    fmb_status st = fmb_dual_simplex(o, &end, &h->odd);
    h->kind = end == FMB_SIMPLEX_STOPPED ? FMB_HINT_INFEASIBLE
              : end == FMB_SIMPLEX_DONE  ? FMB_HINT_OPTIMUM
                                         : FMB_HINT_NONE;
    return st;
}

/* Start where bounds of columns meet: of each the one that lean.x prefers, or the one nearer to 0.
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

/* The cost is `lean`, changed along the members with negative multipliers until these are 0, like
 * those of unit vectors. Multipliers of all inequalities are then increased a little, each by its
 * own random share, so that few are equal later. */
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

static fmb_status search(fmb_simplex_state *o, const double *lean, fmb_hint *h)
{
    bool first = !o->placed;
    fmb_status st = first ? start_at_bounds(o, lean) : FMB_OK;
    o->placed = true;
    o->steps = 0;
    o->nudge = lean ? NUDGE_OF_COST : NUDGE;
    memset(o->cost, 0, o->n * sizeof *o->cost);
    if (st == FMB_OK && lean)
        st = lean_cost(o, lean);
    if (st == FMB_OK && first)
        st = fmb_first_basis(o);
    FMB_THEN(st, search_on(o, h));
    hand_out_members(o, h);
    return st;
}

/* Walk from a primal feasible vertex to the optimum. */
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
        FMB_THEN(st, search_on(o, h));
        if (o->feasible)
            h->kind = FMB_HINT_NONE;
    }
    return st;
}

static fmb_status maximize(fmb_simplex_state *o, const double *cost, fmb_hint *h)
{
    fmb_status st = FMB_OK;
    h->kind = FMB_HINT_NONE;
    o->steps = 0;
    if (!o->feasible)
        st = search(o, NULL, h);
    o->most_steps = o->steps + fmb_simplex_most_pivots(o);
    if (st == FMB_OK && o->feasible)
        st = climb_to_optimum(o, cost, h);
    hand_out_members(o, h);
    return st;
}

/* From the end of a search, walk to the largest cost, or as far as twice the steps of the search
 * lead: then no other vertex has to be solved for. */
static fmb_status go_on_from_search(fmb_simplex_state *o, const double *cost, fmb_hint *h)
{
    o->most_steps = 3 * o->steps;
    fmb_status st = climb_to_optimum(o, cost, h);
    h->kind = o->feasible ? FMB_HINT_OPTIMUM : FMB_HINT_NONE;
    hand_out_members(o, h);
    return st;
}

/* Return a late status, and copy new rows. */
static fmb_status catch_up(fmb_backend *d, fmb_hint *h)
{
    fmb_status st = d->late == FMB_OK ? fmb_backend_grow(d) : d->late;
    d->late = FMB_OK;
    h->kind = FMB_HINT_NONE;
    return st;
}

fmb_status fmb_backend_search(fmb_backend *d, const double *lean, fmb_hint *h)
{
    bool leans = lean && fmb_scaled_program_scale_cost(&d->scaled, lean, d->cost);
    fmb_status st = catch_up(d, h);
    FMB_THEN(st, search(&d->state, leans ? d->cost : NULL, h));
    return st == FMB_OK && leans && d->state.feasible ? go_on_from_search(&d->state, d->cost, h)
                                                      : st;
}

fmb_status fmb_backend_maximize(fmb_backend *d, const double *cost, fmb_hint *h)
{
    bool is_finite = fmb_scaled_program_scale_cost(&d->scaled, cost, d->cost);
    fmb_status st = is_finite ? catch_up(d, h) : fmb_backend_search(d, NULL, h);
    if (st == FMB_OK && is_finite)
        return maximize(&d->state, d->cost, h);
    h->kind = FMB_HINT_NONE;
    return st;
}

bool fmb_backend_point(fmb_backend *d, int fine, mpz_t *x, mpz_t den)
{
    const int *exponent = d->scaled.column_exponent;
    const double *scaled = d->state.edge.at;
    int places = 0, unit = d->scaled.unit;
    fmb_simplex_state_find_point(&d->state);
    for (size_t j = 0; j < d->scaled.n; j++) {
        int own = fine + exponent[j] - unit;
        places = own > places ? own : places;
        if (!isfinite(ldexp(scaled[j], fine)))
            return false;
    }
    for (size_t j = 0; j < d->scaled.n; j++) {
        mpz_set_d(x[j], nearbyint(ldexp(scaled[j], fine)));
        mpz_mul_2exp(x[j], x[j], (mp_bitcnt_t)(places - fine - exponent[j] + unit));
    }
    mpz_set_ui(den, 0);
    mpz_setbit(den, (mp_bitcnt_t)places);
    return true;
}

/* ---- changes --------------------------------------------------------------------------------- */

fmb_status fmb_backend_grow(fmb_backend *d)
{
    d->behind = d->behind || d->scaled.m < d->scaled.p->m;
    fmb_status st = d->behind ? fmb_scaled_program_grow(&d->scaled) : FMB_OK;
    if (st == FMB_OK && d->behind)
        st = fmb_simplex_state_grow(&d->state);
    d->behind = st != FMB_OK;
    return st;
}

static void note_status(fmb_backend *d, fmb_status st)
{
    d->late = d->late == FMB_OK ? st : d->late;
}

/* The place of row i in the basis, or FMB_NOWHERE. */
static size_t find_member(const fmb_simplex_state *o, size_t i)
{
    for (size_t r = 0; r < o->n; r++)
        if (o->basis.member[r] == i)
            return r;
    return FMB_NOWHERE;
}

/* A row that is switched off leaves the basis, whose members may change places before. */
void fmb_backend_switch(fmb_backend *d, size_t i, bool on)
{
    fmb_simplex_state *o = &d->state;
    if (d->scaled.off[i] != on)
        return;
    d->scaled.off[i] = !on;
    bool leaves = !on && find_member(o, i) != FMB_NOWHERE;
    fmb_status st = leaves ? fmb_simplex_state_refresh(o) : FMB_OK;
    size_t r = leaves ? find_member(o, i) : FMB_NOWHERE;
    o->feasible = o->feasible && !on;
    if (st == FMB_OK && r != FMB_NOWHERE)
        st = fmb_simplex_state_expel(o, r);
    else
        fmb_simplex_state_note_role(o, i);
    note_status(d, st);
}

void fmb_backend_place(fmb_backend *d, const size_t *basis)
{
    fmb_simplex_state *o = &d->state;
    fmb_status st = fmb_backend_grow(d);
    for (size_t r = 0; st == FMB_OK && r < o->n; r++)
        o->basis.member[r] = basis[r] < o->m ? basis[r] : FMB_UNIT + (basis[r] - o->m);
    o->feasible = false;
    o->placed = true;
    note_status(d, st == FMB_OK ? fmb_simplex_state_place(o, o->basis.member) : st);
}

static void take_right_sides(fmb_simplex_state *o)
{
    restore_right_sides(o);
    o->feasible = false;
}

void fmb_backend_shift(fmb_backend *d, const double *right)
{
    fmb_scaled_program_shift(&d->scaled, right);
    take_right_sides(&d->state);
}

void fmb_backend_sizes(const fmb_backend *d, int *exponent)
{
    const fmb_scaled_program *f = &d->scaled;
    bool scaled = fmb_scaled_program_has_scaled_columns(f);
    for (size_t i = 0; i < f->m; i++)
        exponent[i] = scaled ? f->exponent[i] : 0;
}

void fmb_backend_move_in(fmb_backend *d, double by)
{
    fmb_scaled_program_move_in(&d->scaled, by);
    take_right_sides(&d->state);
}

/* If the row is not in the basis, the point does not change. */
void fmb_backend_shift_row(fmb_backend *d, size_t i)
{
    fmb_simplex_state *o = &d->state;
    fmb_scaled_program_shift_row(&d->scaled, i);
    if (o->moved || !o->placed || find_member(o, i) != FMB_NOWHERE) {
        take_right_sides(o);
        return;
    }
    double by = d->scaled.right[i] - o->right[i];
    o->right[i] += by;
    o->slack[i] += by;
    o->feasible = o->feasible && by >= 0;
}

void fmb_backend_sharpen(fmb_backend *d)
{
    d->scaled.sharp = true;
}

/* ---- life ------------------------------------------------------------------------------------ */

void fmb_backend_close(fmb_backend *d)
{
    if (!d)
        return;
    fmb_mem *mem = d->scaled.run->mem;
    if (d->state.f)
        fmb_simplex_state_clear(&d->state);
    fmb_mem_put(mem, d->cost, d->scaled.n, sizeof *d->cost);
    fmb_scaled_program_clear(&d->scaled);
    fmb_mem_put(mem, d, 1, sizeof *d);
}

fmb_status fmb_backend_open_with(fmb_run *run, const fmb_program *p, bool factors,
                                 fmb_backend **out)
{
    *out = NULL;
    fmb_backend *d;
    FMB_TRY(FMB_GET_ZERO(run->mem, d, 1));
    fmb_status st = fmb_scaled_program_init(&d->scaled, run, p);
    d->cost = fmb_mem_get(run->mem, d->scaled.n, sizeof *d->cost);
    if (st == FMB_OK && !d->cost)
        st = fmb_mem_status(run->mem);
    FMB_THEN(st, fmb_simplex_state_init(&d->state, &d->scaled,
                                        factors ? FMB_INVERSE_FACTORS : FMB_INVERSE_BY_SIZE));
    if (st == FMB_OK)
        *out = d;
    else
        fmb_backend_close(d);
    return st;
}

fmb_status fmb_backend_open(fmb_run *run, const fmb_program *p, fmb_backend **out)
{
    return fmb_backend_open_with(run, p, false, out);
}
