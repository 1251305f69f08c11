/* closure.c: the closure of a program, with all rows <= or =: guess, certify, and if necessary
 * pivot on; see oracle.h. */
#include <math.h>
#include <string.h>

#include "base/ways.h"
#include "lp/oracle/oracle_state.h"

/* Exact pivots between two refinements of a guess, and the number of refinements. */
#define FEW_STEPS   4
#define REFINEMENTS 6
/* The same on the way to an optimum. */
#define FEW_PIVOTS  2
#define MOST_OPTIMA 40

fmb_status fmb_oracle_new(fmb_run *run, const fmb_program *p, fmb_oracle **out)
{
    fmb_mem *mem = run->mem;
    size_t n = (size_t)p->n;
    fmb_oracle *o;
    FMB_TRY(FMB_GET_ZERO(mem, o, 1));
    o->run = run;
    o->p = p;
    o->n = n;
    mpz_inits(o->cost_unit, o->point_den, NULL);
    o->hint = fmb_mem_get(mem, n, sizeof *o->hint);
    o->price = fmb_mem_get(mem, n, sizeof *o->price);
    fmb_status st = o->hint && o->price ? FMB_OK : fmb_mem_status(mem);
    o->v.run = run; /* so that it can be cleared after any error */
    o->w.v = &o->v;
    *out = o;
    FMB_THEN(st, fmb_integers_init(&o->cost, n, mem));
    FMB_THEN(st, fmb_integers_init(&o->point, n, mem));
    return st;
}

void fmb_oracle_free(fmb_oracle *o)
{
    if (!o)
        return;
    fmb_mem *mem = o->run->mem;
    fmb_backend_close(o->backend);
    if (o->v.p) {
        fmb_pivot_walk_clear(&o->w);
        fmb_vertex_clear(&o->v);
    }
    fmb_weights_clear(&o->interior_proof, mem);
    fmb_integers_clear(&o->cost, mem);
    fmb_integers_clear(&o->point, mem);
    fmb_mem_put(mem, o->hint, o->n, sizeof *o->hint);
    fmb_mem_put(mem, o->price, o->n, sizeof *o->price);
    fmb_mem_put(mem, o->lean, o->n, sizeof *o->lean);
    mpz_clears(o->cost_unit, o->point_den, NULL);
    fmb_mem_put(mem, o, 1, sizeof *o);
}

/* Make the backend and the vertex when they are needed: the origin may be a solution. */
static fmb_status need_backend(fmb_oracle *o)
{
    if (o->backend)
        return FMB_OK;
    FMB_TRY(fmb_vertex_init(&o->v, o->run, o->p));
    FMB_TRY(fmb_pivot_walk_init(&o->w, &o->v));
    return fmb_backend_open(o->run, o->p, &o->backend);
}

void fmb_closure_begin(fmb_oracle *o)
{
    o->answer = FMB_ANSWER_NONE;
    o->has_interior_proof = false;
    o->run->stats.lps++;
    fmb_run_emit(
        o->run,
        (fmb_event){.kind = FMB_EVENT_LP, .var = -1, .rows_in = o->p->m, .rows_out = o->p->m});
}

/* ---- is there a solution --------------------------------------------------------------------- */

static fmb_status take_vertex(fmb_oracle *o)
{
    for (size_t j = 0; j < o->n; j++)
        mpz_set(o->point.z[j], o->v.x.z[j]);
    mpz_set(o->point_den, o->v.den);
    return fmb_integers_settle(&o->point, o->run->mem);
}

/* Repeat the backend's search from the current basis, by iterative refinement: right sides are the
 * slacks at the exact vertex, times `scale`. */
static fmb_status refine_guess(fmb_oracle *o, double scale, fmb_hint *h)
{
    fmb_vertex *v = &o->v;
    double *right;
    FMB_TRY(FMB_GET(o->run->mem, right, v->m));
    for (size_t i = 0; i < v->m; i++)
        right[i] = fmb_vertex_holds(v, i) ? 0 : scale * fmb_vertex_slack(v, i);
    fmb_backend_place(o->backend, v->basis);
    fmb_backend_shift(o->backend, right);
    fmb_status st = fmb_backend_search(o->backend, NULL, h);
    fmb_backend_shift(o->backend, NULL);
    fmb_mem_put(o->run->mem, right, v->m, sizeof *right);
    return st;
}

/* Does the current basis contradict row h->odd? With long numbers its prices are computed only when
 * they are read; and doubles search again with the tightest tolerances first, since with long
 * numbers the answer may depend on the last digits. */
static fmb_status try_conflict(fmb_oracle *o, fmb_hint *h, fmb_pivot_walk_end *end)
{
    bool sure = false;
    bool is_long = fmb_refined_farkas_is_worth_it(&o->v) && fmb_way(FMB_WAY_REFINED_FARKAS);
    if (is_long)
        FMB_TRY(fmb_refined_farkas(&o->v, h->odd, &o->w.sign, &sure));
    if (is_long && !sure) {
        fmb_backend_sharpen(o->backend);
        FMB_TRY(fmb_backend_search(o->backend, NULL, h));
        FMB_TRY(fmb_vertex_set(&o->v, o->hint));
        if (h->kind == FMB_HINT_INFEASIBLE)
            FMB_TRY(fmb_refined_farkas(&o->v, h->odd, &o->w.sign, &sure));
    }
    if (h->kind != FMB_HINT_INFEASIBLE)
        return FMB_OK;
    fmb_way_answered(FMB_WAY_REFINED_FARKAS, sure);
    if (!sure)
        return fmb_pivot_walk_try_conflict(&o->w, h->odd, end);
    o->w.odd = h->odd;
    o->w.is_priced = false;
    *end = FMB_PIVOT_WALK_CONFLICT;
    return FMB_OK;
}

/* From the current basis: a few exact pivots, then a refined guess, and so on; finally as many
 * pivots as necessary. */
static fmb_status reach_feasible(fmb_oracle *o, fmb_pivot_walk_end *end)
{
    fmb_hint h = {.basis = o->hint};
    FMB_TRY(fmb_pivot_walk_to_feasible(&o->w, FEW_STEPS, end));
    double scale = 0x1p20;
    for (int k = 0; *end == FMB_PIVOT_WALK_ITERATION_LIMIT && k < REFINEMENTS; k++) {
        FMB_TRY(refine_guess(o, scale, &h));
        FMB_TRY(fmb_vertex_set(&o->v, o->hint));
        if (h.kind == FMB_HINT_INFEASIBLE)
            FMB_TRY(try_conflict(o, &h, end));
        if (*end == FMB_PIVOT_WALK_ITERATION_LIMIT)
            FMB_TRY(fmb_pivot_walk_to_feasible(&o->w, FEW_STEPS, end));
        scale *= 0x1p10;
    }
    if (*end == FMB_PIVOT_WALK_ITERATION_LIMIT)
        FMB_TRY(fmb_pivot_walk_to_feasible(&o->w, 0, end));
    return FMB_OK;
}

fmb_status fmb_closure_guess(fmb_oracle *o, fmb_hint *h)
{
    *h = (fmb_hint){.basis = o->hint};
    FMB_TRY(need_backend(o));
    return fmb_backend_search(o->backend, o->leans ? o->lean : NULL, h);
}

/* Certify the guess for the closure of the rows: a vertex or a conflict. */
fmb_status fmb_closure_certify(fmb_oracle *o, fmb_hint *h, fmb_pivot_walk_end *end)
{
    *end = FMB_PIVOT_WALK_ITERATION_LIMIT;
    FMB_TRY(fmb_vertex_set(&o->v, o->hint));
    if (h->kind == FMB_HINT_INFEASIBLE)
        FMB_TRY(try_conflict(o, h, end));
    if (*end == FMB_PIVOT_WALK_ITERATION_LIMIT)
        FMB_TRY(reach_feasible(o, end));
    return *end == FMB_PIVOT_WALK_REACHED ? take_vertex(o) : FMB_OK;
}

/* ---- maximization ---------------------------------------------------------------------------- */

static double divide_cost(const fmb_oracle *o, size_t j)
{
    long e = 0;
    double x = mpz_get_d_2exp(&e, o->cost.z[j]);
    return e - o->cost_bits < -1000 ? 0 : ldexp(x, (int)e - o->cost_bits);
}

/* cost as integers, with their common denominator. */
static fmb_status take_cost(fmb_oracle *o, const fmb_weights *cost)
{
    o->cost_bits = 0;
    mpz_set_ui(o->cost_unit, 1);
    for (size_t j = 0; j < o->n; j++) {
        mpz_set_ui(o->cost.z[j], 0);
        o->price[j] = 0;
    }
    for (size_t k = 0; k < cost->size; k++)
        mpz_lcm(o->cost_unit, o->cost_unit, mpq_denref(cost->value[k]));
    for (size_t k = 0; k < cost->size; k++) {
        mpz_ptr at = o->cost.z[cost->index[k]];
        mpz_divexact(at, o->cost_unit, mpq_denref(cost->value[k]));
        mpz_mul(at, at, mpq_numref(cost->value[k]));
        int bits = (int)mpz_sizeinbase(at, 2);
        o->cost_bits = bits > o->cost_bits ? bits : o->cost_bits;
    }
    for (size_t k = 0; k < cost->size; k++)
        o->price[cost->index[k]] = divide_cost(o, cost->index[k]);
    return fmb_integers_settle(&o->cost, o->run->mem);
}

/* The price of place r, of the cost and of the row as they are in doubles. */
static double price_in_doubles(const fmb_oracle *o, size_t r)
{
    const fmb_vertex *v = &o->v;
    int shift = fmb_vertex_is_unit(v, r) ? 0 : v->p->row[v->basis[r]].shift;
    return fmb_vertex_rough_price(v, r, shift - o->cost_bits);
}

/* The same, times the largest coefficient of its row. */
static double weigh_place(const fmb_oracle *o, size_t r)
{
    const fmb_vertex *v = &o->v;
    double largest = 0, price = price_in_doubles(o, r);
    if (fmb_vertex_is_unit(v, r))
        return price;
    for (size_t k = 0; k < v->p->row[v->basis[r]].size; k++)
        largest = fmax(largest, fabs(fmb_program_double(v->p, v->basis[r], k)));
    return price * largest;
}

static void add_place_to_price(fmb_oracle *o, size_t r, double part)
{
    const fmb_vertex *v = &o->v;
    const fmb_program_row *row = &v->p->row[v->basis[r]];
    if (fmb_vertex_is_unit(v, r))
        o->price[v->basis[r] - v->m] += part;
    else
        for (size_t k = 0; k < row->size; k++)
            o->price[row->column[k]] += part * fmb_program_double(v->p, v->basis[r], k);
}

/* Repeat the backend's maximization from the current basis, whose prices are known, by iterative
 * refinement: the largest price that is not allowed is scaled to 1, and allowed ones to at most 1.
 * Any larger difference between them exceeds the precision of doubles. */
static fmb_status refine_optimum(fmb_oracle *o, fmb_hint *h)
{
    fmb_vertex *v = &o->v;
    double most = 0;
    memset(o->price, 0, o->n * sizeof *o->price);
    for (size_t r = 0; r < v->n; r++)
        if (!fmb_pivot_walk_is_price_allowed(v, r, 1))
            most = fmax(most, fabs(weigh_place(o, r)));
    for (size_t r = 0; r < v->n; r++) {
        double weight = weigh_place(o, r);
        if (weight != 0)
            add_place_to_price(o, r, price_in_doubles(o, r) / fmax(most, fabs(weight)));
    }
    fmb_backend_place(o->backend, v->basis);
    FMB_TRY(fmb_backend_maximize(o->backend, o->price, h));
    return fmb_vertex_set(v, o->hint);
}

/* If exact pivots were made, let the backend continue from their last basis. */
static void let_backend_follow(fmb_oracle *o, uint64_t pivots, fmb_pivot_walk_end end)
{
    if (end == FMB_PIVOT_WALK_REACHED && o->run->stats.pivots != pivots)
        fmb_backend_place(o->backend, o->v.basis);
}

/* Make the current vertex, which satisfies all rows, the point if its cost.x is larger: if a limit
 * ends the climb, it is the best point reached. */
static fmb_status keep_better_vertex(fmb_oracle *o)
{
    mpz_t here, there;
    mpz_inits(here, there, NULL);
    for (size_t j = 0; j < o->n; j++) {
        mpz_addmul(here, o->cost.z[j], o->v.x.z[j]);
        mpz_addmul(there, o->cost.z[j], o->point.z[j]);
    }
    mpz_mul(here, here, o->point_den);
    mpz_mul(there, there, o->v.den);
    bool better = mpz_cmp(here, there) > 0;
    mpz_clears(here, there, NULL);
    return better ? take_vertex(o) : FMB_OK;
}

/* From a guess to the optimum, exactly. */
static fmb_status climb_with_refinements(fmb_oracle *o, fmb_pivot_walk_end *end)
{
    fmb_hint h = {.basis = o->hint};
    fmb_pivot_walk_end there;
    uint64_t pivots = o->run->stats.pivots;
    FMB_TRY(fmb_pivot_walk_to_optimum(&o->w, FEW_PIVOTS, o->cost.z, end));
    for (int k = 0; *end == FMB_PIVOT_WALK_ITERATION_LIMIT && k <= MOST_OPTIMA; k++) {
        FMB_TRY(keep_better_vertex(o));
        FMB_TRY(refine_optimum(o, &h));
        FMB_TRY(reach_feasible(o, &there));
        FMB_TRY(fmb_pivot_walk_to_optimum(&o->w, k < MOST_OPTIMA ? FEW_PIVOTS : 0, o->cost.z, end));
    }
    let_backend_follow(o, pivots, *end);
    return FMB_OK;
}

/* The backend's guess of the optimum. */
static fmb_status guess_optimum(fmb_oracle *o, const fmb_weights *cost, fmb_hint *h)
{
    *h = (fmb_hint){.basis = o->hint};
    FMB_TRY(need_backend(o));
    FMB_TRY(take_cost(o, cost));
    return fmb_backend_maximize(o->backend, o->price, h);
}

static fmb_status certify_approach(fmb_oracle *o, const fmb_hint *h, fmb_pivot_walk_end *end)
{
    uint64_t pivots = o->run->stats.pivots;
    *end = FMB_PIVOT_WALK_ITERATION_LIMIT;
    FMB_TRY(fmb_vertex_set(&o->v, o->hint));
    if (h->kind == FMB_HINT_UNBOUNDED)
        FMB_TRY(fmb_pivot_walk_try_ray(&o->w, h->odd, o->cost.z, end));
    if (*end == FMB_PIVOT_WALK_ITERATION_LIMIT)
        FMB_TRY(reach_feasible(o, end));
    let_backend_follow(o, pivots, *end);
    return *end == FMB_PIVOT_WALK_REACHED ? take_vertex(o) : FMB_OK;
}

fmb_status fmb_closure_approach(fmb_oracle *o, const fmb_weights *cost, fmb_pivot_walk_end *end)
{
    fmb_hint h;
    FMB_TRY(guess_optimum(o, cost, &h));
    return certify_approach(o, &h, end);
}

fmb_status fmb_closure_climb(fmb_oracle *o, fmb_pivot_walk_end *end)
{
    FMB_TRY(climb_with_refinements(o, end));
    return *end == FMB_PIVOT_WALK_REACHED ? take_vertex(o) : FMB_OK;
}

/* ---- a program that changes ------------------------------------------------------------------ */

fmb_status fmb_oracle_grow(fmb_oracle *o)
{
    o->feasible = false;
    if (!o->backend)
        return FMB_OK;
    FMB_TRY(fmb_vertex_grow(&o->v));
    return fmb_backend_grow(o->backend);
}

void fmb_oracle_switch(fmb_oracle *o, size_t i, bool on)
{
    o->feasible = false;
    if (!o->backend)
        return;
    o->v.feasible = false;
    fmb_backend_switch(o->backend, i, on);
}

void fmb_oracle_shift(fmb_oracle *o)
{
    o->feasible = false;
    if (!o->backend)
        return;
    o->v.solved = o->v.feasible = false;
    fmb_backend_shift(o->backend, NULL);
}

void fmb_oracle_shift_row(fmb_oracle *o, size_t i)
{
    o->feasible = false;
    if (!o->backend)
        return;
    o->v.solved = o->v.solved && !fmb_vertex_holds(&o->v, i);
    o->v.feasible = false;
    fmb_backend_shift_row(o->backend, i);
}
