/* simplex_state.c: see simplex_state.h. */
#include "lp/simplex/simplex_state.h"

#include <assert.h>
#include <math.h>

/* Rows of the basis that are off by more show that it is inexact. */
#define INEXACT 1e-8

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status reserve_for_members(fmb_simplex_state *o)
{
    fmb_mem *mem = o->f->run->mem;
    size_t n = o->n;
    o->y = fmb_mem_zero(mem, n, sizeof *o->y);
    o->cost = fmb_mem_zero(mem, n, sizeof *o->cost);
    o->given = fmb_mem_get(mem, n, sizeof *o->given);
    o->edge_weight = fmb_mem_get(mem, n, sizeof *o->edge_weight);
    o->member_role = fmb_mem_get(mem, n, sizeof *o->member_role);
    o->falling = fmb_mem_get(mem, n, sizeof *o->falling);
    if (!o->y || !o->cost || !o->given || !o->edge_weight || !o->member_role || !o->falling)
        return fmb_mem_status(mem);
    memset(o->member_role, FMB_ROLE_FREE, n);
    fmb_status st = fmb_indexed_vector_resize(&o->entry, mem, n);
    return st == FMB_OK ? fmb_indexed_vector_resize(&o->edge, mem, n) : st;
}

fmb_status fmb_simplex_state_init(fmb_simplex_state *o, const fmb_scaled_program *f, bool factors)
{
    *o = (fmb_simplex_state){.f = f, .n = f->n};
    o->basis.f = o->columns.f = o->basis.lu.f = f;
    fmb_status st = fmb_basis_inverse_init(&o->basis, f, factors);
    if (st == FMB_OK)
        st = fmb_columns_init(&o->columns, f);
    if (st == FMB_OK)
        st = reserve_for_members(o);
    return st == FMB_OK ? fmb_simplex_state_grow(o) : st;
}

void fmb_simplex_state_clear(fmb_simplex_state *o)
{
    fmb_mem *mem = o->f->run->mem;
    fmb_basis_inverse_clear(&o->basis);
    fmb_columns_clear(&o->columns);
    fmb_indexed_vector_free(&o->entry, mem);
    fmb_indexed_vector_free(&o->edge, mem);
    fmb_indexed_vector_free(&o->rate, mem);
    fmb_mem_put(mem, o->y, o->n, sizeof *o->y);
    fmb_mem_put(mem, o->cost, o->n, sizeof *o->cost);
    fmb_mem_put(mem, o->given, o->n, sizeof *o->given);
    fmb_mem_put(mem, o->edge_weight, o->n, sizeof *o->edge_weight);
    fmb_mem_put(mem, o->member_role, o->n, sizeof *o->member_role);
    fmb_mem_put(mem, o->falling, o->n, sizeof *o->falling);
    fmb_mem_put(mem, o->right, o->right_room, sizeof *o->right);
    fmb_mem_put(mem, o->slack, o->slack_room, sizeof *o->slack);
    fmb_mem_put(mem, o->row_weight, o->row_weight_room, sizeof *o->row_weight);
    fmb_mem_put(mem, o->row_role, o->row_role_room, sizeof *o->row_role);
    fmb_mem_put(mem, o->violated, o->violated_room, sizeof *o->violated);
    fmb_mem_put(mem, o->is_listed, o->listed_room, sizeof *o->is_listed);
}

fmb_status fmb_simplex_state_grow(fmb_simplex_state *o)
{
    fmb_mem *mem = o->f->run->mem;
    size_t m = o->f->m;
    fmb_status st = fmb_mem_reserve(mem, (void **)&o->right, &o->right_room, m, sizeof *o->right);
    if (st == FMB_OK)
        st = fmb_mem_reserve(mem, (void **)&o->slack, &o->slack_room, m, sizeof *o->slack);
    if (st == FMB_OK)
        st = fmb_mem_reserve(mem, (void **)&o->row_weight, &o->row_weight_room, m,
                             sizeof *o->row_weight);
    if (st == FMB_OK)
        st = fmb_mem_reserve(mem, (void **)&o->row_role, &o->row_role_room, m, sizeof *o->row_role);
    if (st == FMB_OK)
        st = fmb_mem_reserve(mem, (void **)&o->violated, &o->violated_room, m, sizeof *o->violated);
    if (st == FMB_OK)
        st = fmb_mem_reserve(mem, (void **)&o->is_listed, &o->listed_room, m, sizeof *o->is_listed);
    if (st == FMB_OK)
        st = fmb_indexed_vector_resize(&o->rate, mem, m);
    if (st == FMB_OK)
        st = fmb_columns_grow(&o->columns);
    if (st != FMB_OK)
        return st;
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

/* Of a row outside of the basis. */
void fmb_simplex_state_note_role(fmb_simplex_state *o, size_t i)
{
    o->row_role[i] = o->f->off[i]                              ? FMB_ROLE_FREE
                     : fmb_scaled_program_is_equality(o->f, i) ? FMB_ROLE_EQUAL
                                                               : FMB_ROLE_LESS;
}

/* The member at place r is noted as such. */
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

void fmb_simplex_state_find_point(fmb_simplex_state *o)
{
    for (size_t r = 0; r < o->n; r++) {
        size_t i = o->basis.member[r];
        o->given[r] = i < FMB_UNIT ? o->right[i] : 0;
    }
    fmb_basis_inverse_point(&o->basis, o->given, &o->edge);
}

/* Slacks from the basis; how far its rows are off. */
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
    if (st != FMB_OK)
        return st;
    fmb_basis_inverse_price(&o->basis, o->cost, &o->edge);
    memset(o->y, 0, o->n * sizeof *o->y);
    fmb_indexed_vector_subtract(&o->edge, -1, o->y, o->f->run->kernels);
    return FMB_OK;
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
    fmb_status st = fmb_basis_inverse_replace(&o->basis, r, i, &o->entry, &o->edge);
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

/* The row outside that the way along the edge meets first, either way, or FMB_NOWHERE. */
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

/* The unit vector that best takes place r. */
static fmb_status pivot_to_unit(fmb_simplex_state *o, size_t r)
{
    size_t best = fmb_indexed_vector_key(&o->edge, 0), old = o->basis.member[r];
    assert(old < FMB_UNIT);
    for (size_t t = 1; t < fmb_indexed_vector_count(&o->edge); t++) {
        size_t j = fmb_indexed_vector_key(&o->edge, t);
        best = fabs(o->edge.at[j]) > fabs(o->edge.at[best]) ? j : best;
    }
    fmb_basis_inverse_write(&o->basis, FMB_UNIT + best, &o->entry);
    fmb_status st = fmb_basis_inverse_replace(&o->basis, r, FMB_UNIT + best, &o->entry, &o->edge);
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
