/* simplex_state.c: see simplex_state.h. */
#include "lp/simplex/simplex_state.h"

#include <assert.h>
#include <math.h>

#include "base/arrays.h"

/* Larger errors in rows of the basis show that it is inexact. */
#define INEXACT 1e-8

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status hold_arrays_of_members(fmb_simplex_state *o, bool get)
{
    const size_t n = o->n;
    return FMB_ARRAYS(o->f->run->mem, get, FMB_ARRAY_ZERO(o->y, n), FMB_ARRAY_ZERO(o->cost, n),
                      FMB_ARRAY(o->given, n), FMB_ARRAY(o->edge_weight, n),
                      FMB_ARRAY(o->member_role, n), FMB_ARRAY(o->falling, n));
}

static fmb_status open_members(fmb_simplex_state *o)
{
    fmb_mem *mem = o->f->run->mem;
    FMB_TRY(hold_arrays_of_members(o, true));
    memset(o->member_role, FMB_ROLE_FREE, o->n);
    FMB_TRY(fmb_indexed_vector_resize(&o->entry, mem, o->n));
    return fmb_indexed_vector_resize(&o->edge, mem, o->n);
}

fmb_status fmb_simplex_state_init(fmb_simplex_state *o, const fmb_scaled_program *f,
                                  fmb_inverse_kind kind)
{
    *o = (fmb_simplex_state){.f = f, .n = f->n};
    o->basis.f = o->columns.f = o->basis.lu.f = f;
    FMB_TRY(fmb_basis_inverse_init(&o->basis, f, kind));
    FMB_TRY(fmb_columns_init(&o->columns, f));
    FMB_TRY(open_members(o));
    return fmb_simplex_state_grow(o);
}

void fmb_simplex_state_clear(fmb_simplex_state *o)
{
    fmb_mem *mem = o->f->run->mem;
    fmb_basis_inverse_clear(&o->basis);
    fmb_columns_clear(&o->columns);
    fmb_indexed_vector_free(&o->entry, mem);
    fmb_indexed_vector_free(&o->edge, mem);
    fmb_indexed_vector_free(&o->rate, mem);
    (void)hold_arrays_of_members(o, false);
    FMB_ARRAYS_PUT(
        mem, FMB_ARRAY(o->right, o->right_room), FMB_ARRAY(o->slack, o->slack_room),
        FMB_ARRAY(o->row_weight, o->row_weight_room), FMB_ARRAY(o->row_role, o->row_role_room),
        FMB_ARRAY(o->violated, o->violated_room), FMB_ARRAY(o->is_listed, o->listed_room));
}

fmb_status fmb_simplex_state_grow(fmb_simplex_state *o)
{
    fmb_mem *mem = o->f->run->mem;
    size_t m = o->f->m;
    FMB_TRY(FMB_RESERVE(mem, &o->right, &o->right_room, m));
    FMB_TRY(FMB_RESERVE(mem, &o->slack, &o->slack_room, m));
    FMB_TRY(FMB_RESERVE(mem, &o->row_weight, &o->row_weight_room, m));
    FMB_TRY(FMB_RESERVE(mem, &o->row_role, &o->row_role_room, m));
    FMB_TRY(FMB_RESERVE(mem, &o->violated, &o->violated_room, m));
    FMB_TRY(FMB_RESERVE(mem, &o->is_listed, &o->listed_room, m));
    FMB_TRY(fmb_indexed_vector_resize(&o->rate, mem, m));
    FMB_TRY(fmb_columns_grow(&o->columns));
    for (size_t i = o->m; i < m; i++) {
        o->right[i] = o->f->right[i];
        o->slack[i] = 0;
        fmb_simplex_state_note_role(o, i);
    }
    o->m = m;
    o->feasible = false;
    return FMB_OK;
}

/* ---- the basis ------------------------------------------------------------------------------- */

/* The role of a row outside of the basis. */
void fmb_simplex_state_note_role(fmb_simplex_state *o, size_t i)
{
    o->row_role[i] = o->f->off[i]                              ? FMB_ROLE_FREE
                     : fmb_scaled_program_is_equality(o->f, i) ? FMB_ROLE_EQUAL
                                                               : FMB_ROLE_LESS;
}

/* Set the roles for the member at place r. */
static void note_member(fmb_simplex_state *o, size_t r)
{
    size_t i = o->basis.member[r];
    o->member_role[r] = FMB_ROLE_FREE;
    if (i >= FMB_UNIT)
        return;
    fmb_simplex_state_note_role(o, i);
    o->member_role[r] = o->row_role[i];
    o->row_role[i] = FMB_ROLE_FREE;
}

fmb_status fmb_simplex_state_place(fmb_simplex_state *o, const size_t *member)
{
    fmb_status st = fmb_basis_inverse_set(&o->basis, member, &o->entry);
    for (size_t i = 0; i < o->m; i++)
        fmb_simplex_state_note_role(o, i);
    for (size_t r = 0; r < o->n; r++)
        note_member(o, r);
    return st;
}

fmb_status fmb_simplex_state_reload(fmb_simplex_state *o, const size_t *member)
{
    o->m = o->columns.m = 0;
    FMB_TRY(fmb_simplex_state_grow(o));
    FMB_TRY(fmb_simplex_state_place(o, member));
    return fmb_simplex_state_refresh(o);
}

void fmb_simplex_state_price(fmb_simplex_state *o)
{
    fmb_basis_inverse_price(&o->basis, o->cost, &o->edge);
    memset(o->y, 0, o->n * sizeof *o->y);
    fmb_indexed_vector_subtract(&o->edge, -1, o->y, o->f->run->kernels);
}

void fmb_simplex_state_find_point(fmb_simplex_state *o)
{
    for (size_t r = 0; r < o->n; r++) {
        size_t i = o->basis.member[r];
        o->given[r] = i < FMB_UNIT ? o->right[i] : 0;
    }
    fmb_basis_inverse_point(&o->basis, o->given, &o->edge);
}

/* Compute the slacks from the basis; returns the largest error in its rows. */
static double find_slacks(fmb_simplex_state *o)
{
    double most = 0;
    fmb_simplex_state_find_point(o);
    fmb_columns_times(&o->columns, &o->edge, &o->rate);
    if (o->m > 0)
        memcpy(o->slack, o->right, o->m * sizeof *o->slack);
    fmb_indexed_vector_subtract(&o->rate, 1, o->slack, o->f->run->kernels);
    for (size_t r = 0; r < o->n; r++) {
        size_t i = o->basis.member[r];
        if (i >= FMB_UNIT)
            continue;
        most = fmax(most, fabs(o->slack[i]) / (1 + fabs(o->right[i])));
        o->slack[i] = 0;
    }
    return most;
}

fmb_status fmb_simplex_state_refresh(fmb_simplex_state *o)
{
    fmb_status st = FMB_OK;
    if (fmb_basis_inverse_is_stale(&o->basis))
        st = fmb_simplex_state_place(o, o->basis.member);
    if (st == FMB_OK && find_slacks(o) > INEXACT && o->basis.pivots > 0) {
        st = fmb_simplex_state_place(o, o->basis.member);
        if (st == FMB_OK)
            find_slacks(o);
    }
    if (st == FMB_OK)
        fmb_simplex_state_price(o);
    return st;
}

fmb_status fmb_simplex_state_renew(fmb_simplex_state *o)
{
    fmb_status st = fmb_simplex_state_place(o, o->basis.member);
    return st == FMB_OK ? fmb_simplex_state_refresh(o) : st;
}

/* ---- from vertex to vertex ------------------------------------------------------------------- */

void fmb_simplex_state_look_along(fmb_simplex_state *o, size_t r)
{
    fmb_basis_inverse_edge(&o->basis, r, &o->edge);
    fmb_columns_times(&o->columns, &o->edge, &o->rate);
    if (!o->columns.dense)
        fmb_indexed_vector_make_sparse(&o->rate);
}

fmb_status fmb_simplex_state_pivot(fmb_simplex_state *o, size_t r, size_t i)
{
    const fmb_kernels *k = o->f->run->kernels;
    size_t old = o->basis.member[r];
    double pivot = o->entry.at[r];
    double way = o->slack[i] / pivot, multiplier = o->y[r] / pivot;
    fmb_indexed_vector_subtract(&o->rate, way, o->slack, k);
    fmb_indexed_vector_subtract(&o->entry, multiplier, o->y, k);
    o->y[r] = multiplier;
    o->slack[i] = 0;
    fmb_status st = fmb_basis_inverse_replace(&o->basis, r, i, &o->entry);
    if (old < FMB_UNIT)
        fmb_simplex_state_note_role(o, old);
    note_member(o, r);
    o->steps++;
    return st;
}

void fmb_simplex_state_add_to_cost(fmb_simplex_state *o, size_t r, double part)
{
    int one;
    fmb_terms t = fmb_member_terms(o->f, o->basis.member[r], &one);
    for (size_t k = 0; k < t.size; k++)
        o->cost[t.column[k]] += part * t.value[k];
    o->y[r] += part;
}

/* ---- rows that are switched off -------------------------------------------------------------- */

/* The row outside of the basis nearest along the edge, either way, or FMB_NOWHERE. */
static size_t find_nearest_row(const fmb_simplex_state *o)
{
    double least = INFINITY, most = 0;
    size_t best = FMB_NOWHERE;
    for (size_t t = 0; t < fmb_indexed_vector_count(&o->rate); t++) {
        size_t i = fmb_indexed_vector_key(&o->rate, t);
        double rate = fabs(o->rate.at[i]);
        if (o->row_role[i] == FMB_ROLE_FREE || rate < 1e-9)
            continue;
        double way = fmax(o->slack[i], 0) / rate;
        if (way < least || (way == least && rate > most)) {
            least = way;
            most = rate;
            best = i;
        }
    }
    return best;
}

/* Put the unit vector with the best pivot at place r. */
static fmb_status pivot_to_unit(fmb_simplex_state *o, size_t r)
{
    size_t best = fmb_indexed_vector_key(&o->edge, 0), old = o->basis.member[r];
    assert(old < FMB_UNIT);
    for (size_t t = 1; t < fmb_indexed_vector_count(&o->edge); t++) {
        size_t j = fmb_indexed_vector_key(&o->edge, t);
        best = fabs(o->edge.at[j]) > fabs(o->edge.at[best]) ? j : best;
    }
    fmb_basis_inverse_write(&o->basis, FMB_UNIT + best, &o->entry);
    fmb_status st = fmb_basis_inverse_replace(&o->basis, r, FMB_UNIT + best, &o->entry);
    fmb_simplex_state_note_role(o, old);
    note_member(o, r);
    return st == FMB_OK ? fmb_simplex_state_refresh(o) : st;
}

fmb_status fmb_simplex_state_expel(fmb_simplex_state *o, size_t r)
{
    fmb_simplex_state_look_along(o, r);
    size_t i = find_nearest_row(o);
    if (i == FMB_NOWHERE)
        return pivot_to_unit(o, r);
    fmb_basis_inverse_write(&o->basis, i, &o->entry);
    return fmb_simplex_state_pivot(o, r, i);
}
