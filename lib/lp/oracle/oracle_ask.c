/* oracle_ask.c: the queries of an oracle: simple cases, then the closure, then strict rows; see
 * oracle.h.
 */
#include <string.h>

#include "base/ways.h"
#include "lp/oracle/oracle_state.h"

/* ---- is there a solution --------------------------------------------------------------------- */

static bool is_origin_a_solution(const fmb_program *p)
{
    for (size_t i = 0; i < p->m; i++) {
        const fmb_program_row *r = &p->row[i];
        int b = fmb_vec_sgn(r->value, r->size);
        if (!r->off && (r->rel == FMB_EQ ? b != 0 : r->rel == FMB_LT ? b <= 0 : b < 0))
            return false;
    }
    return true;
}

static void take_origin(fmb_oracle *o)
{
    for (size_t j = 0; j < o->n; j++)
        mpz_set_ui(o->point.z[j], 0);
    mpz_set_ui(o->point_den, 1);
}

/* Is the last point found, before rows changed, still a solution? Skipped if there is none.
 */
static fmb_status try_last_point(fmb_oracle *o, bool *holds)
{
    *holds = false;
    if (!o->has_point || !o->backend)
        return FMB_OK;
    return fmb_vertex_try_point(&o->v, o->point.z, o->point_den, o->price, holds);
}

void fmb_oracle_expect_tight_rows(fmb_oracle *o, bool tight)
{
    o->tight = tight;
}

/* Find a point, strictly inside of strict rows, or a conflict. */
static fmb_status search_for_point(fmb_oracle *o, bool *feasible)
{
    fmb_pivot_walk_end end;
    fmb_hint h;
    bool room = true;
    *feasible = false;
    fmb_status st = fmb_closure_guess(o, &h);
    if (st == FMB_OK && h.kind == FMB_HINT_OPTIMUM && !o->leans && fmb_way(FMB_WAY_LATTICE))
        st = fmb_oracle_try_lattice_point(o, &h, feasible);
    fmb_way_answered(FMB_WAY_LATTICE, *feasible);
    if (st != FMB_OK || *feasible)
        return st;
    st = fmb_closure_certify(o, &h, &end);
    if (st == FMB_OK && end == FMB_PIVOT_WALK_REACHED && o->p->any_strict &&
        !fmb_vertex_is_inside(&o->v))
        st = fmb_oracle_find_strict_interior(o, false, &room);
    *feasible = end == FMB_PIVOT_WALK_REACHED && room;
    return st;
}

fmb_status fmb_oracle_lean(fmb_oracle *o, const fmb_weights *cost)
{
    if (!o->lean)
        FMB_TRY(FMB_GET(o->run->mem, o->lean, o->n));
    memset(o->lean, 0, o->n * sizeof *o->lean);
    for (size_t k = 0; k < cost->size; k++)
        o->lean[cost->index[k]] = mpq_get_d(cost->value[k]);
    o->leans = true;
    return FMB_OK;
}

fmb_status fmb_oracle_feasible(fmb_oracle *o, bool *feasible)
{
    bool found = is_origin_a_solution(o->p);
    fmb_status st = FMB_OK;
    fmb_closure_begin(o);
    o->feasible = false;
    if (found)
        take_origin(o);
    else
        st = try_last_point(o, &found);
    if (st == FMB_OK && !found)
        st = search_for_point(o, &found);
    o->leans = false;
    if (st != FMB_OK)
        return st;
    o->has_point = o->has_point || found;
    o->feasible = *feasible = found;
    o->answer = found ? FMB_ANSWER_POINT : FMB_ANSWER_CONFLICT;
    return FMB_OK;
}

bool fmb_oracle_has_solution(const fmb_oracle *o)
{
    return o->feasible;
}

/* ---- maximization ---------------------------------------------------------------------------- */

/* The optimal vertex satisfies the closure of all rows: does a solution attain the optimum? Not if
 * a row with a nonzero multiplier in the proof is strict. */
static fmb_status find_whether_attained(fmb_oracle *o, bool *attained)
{
    fmb_vertex *v = &o->v;
    *attained = true;
    if (!o->p->any_strict || fmb_vertex_is_inside(v))
        return FMB_OK;
    for (size_t r = 0; r < v->n && *attained; r++)
        *attained = fmb_vertex_is_loose(v, r) || mpz_sgn(v->y.z[r]) == 0 ||
                    o->p->row[v->basis[r]].rel != FMB_LT;
    return *attained ? fmb_oracle_find_strict_interior(o, true, attained) : FMB_OK;
}

static fmb_status note_end(fmb_oracle *o, fmb_status st, fmb_pivot_walk_end end,
                           fmb_oracle_end *out)
{
    *out = end == FMB_PIVOT_WALK_RAY ? FMB_ORACLE_UNBOUNDED : FMB_ORACLE_OPTIMUM;
    if (st == FMB_OK)
        o->answer = end == FMB_PIVOT_WALK_RAY ? FMB_ANSWER_RAY : FMB_ANSWER_OPTIMUM;
    return st;
}

fmb_status fmb_oracle_approach(fmb_oracle *o, const fmb_weights *cost, fmb_oracle_end *out)
{
    fmb_pivot_walk_end end;
    fmb_run_count(o->run, 500);
    fmb_closure_begin(o);
    fmb_status st = fmb_closure_approach(o, cost, &end);
    return note_end(o, st, end, out);
}

fmb_status fmb_oracle_climb(fmb_oracle *o, fmb_oracle_end *out)
{
    fmb_pivot_walk_end end;
    fmb_status st = fmb_closure_climb(o, &end);
    return note_end(o, st, end, out);
}

fmb_status fmb_oracle_attain(fmb_oracle *o, bool *attained)
{
    return find_whether_attained(o, attained);
}

bool fmb_oracle_reached(fmb_oracle *o, mpq_t *x)
{
    bool reached = o->feasible && (!o->p->any_strict || !o->backend ||
                                   fmb_vertex_is_point_inside(&o->v, o->point.z, o->point_den));
    return reached && fmb_oracle_point(o, x) == FMB_OK;
}

fmb_status fmb_oracle_maximize(fmb_oracle *o, const fmb_weights *cost, fmb_oracle_end *out,
                               bool *attained)
{
    *attained = false;
    FMB_TRY(fmb_oracle_approach(o, cost, out));
    if (*out == FMB_ORACLE_OPTIMUM)
        FMB_TRY(fmb_oracle_climb(o, out));
    return *out == FMB_ORACLE_OPTIMUM ? fmb_oracle_attain(o, attained) : FMB_OK;
}
