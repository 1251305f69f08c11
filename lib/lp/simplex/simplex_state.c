/* simplex_state.c: see simplex_state.h. */
#include "lp/simplex/simplex_state.h"

#include <assert.h>
#include <math.h>

/* Rows of the basis that are off by more show that it is inexact. */
#define INEXACT 1e-8

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status reserve_for_members(fmb_stand *o)
{
    fmb_mem *mem = o->f->run->mem;
    size_t n = o->n;
    o->y = fmb_mem_zero(mem, n, sizeof *o->y);
    o->cost = fmb_mem_zero(mem, n, sizeof *o->cost);
    o->given = fmb_mem_get(mem, n, sizeof *o->given);
    o->edge_weight = fmb_mem_get(mem, n, sizeof *o->edge_weight);
    o->member_role = fmb_mem_get(mem, n, sizeof *o->member_role);
    if (!o->y || !o->cost || !o->given || !o->edge_weight || !o->member_role)
        return fmb_mem_status(mem);
    memset(o->member_role, FMB_ROLE_FREE, n);
    fmb_status st = fmb_spread_resize(&o->entry, mem, n);
    return st == FMB_OK ? fmb_spread_resize(&o->edge, mem, n) : st;
}

fmb_status fmb_stand_init(fmb_stand *o, const fmb_reals *f, bool factors)
{
    *o = (fmb_stand){.f = f, .n = f->n};
    o->corner.f = o->columns.f = o->corner.triangles.f = f;
    fmb_status st = fmb_corner_init(&o->corner, f, factors);
    if (st == FMB_OK)
        st = fmb_columns_init(&o->columns, f);
    if (st == FMB_OK)
        st = reserve_for_members(o);
    return st == FMB_OK ? fmb_stand_grow(o) : st;
}

void fmb_stand_clear(fmb_stand *o)
{
    fmb_mem *mem = o->f->run->mem;
    fmb_corner_clear(&o->corner);
    fmb_columns_clear(&o->columns);
    fmb_spread_free(&o->entry, mem);
    fmb_spread_free(&o->edge, mem);
    fmb_spread_free(&o->rate, mem);
    fmb_mem_put(mem, o->y, o->n, sizeof *o->y);
    fmb_mem_put(mem, o->cost, o->n, sizeof *o->cost);
    fmb_mem_put(mem, o->given, o->n, sizeof *o->given);
    fmb_mem_put(mem, o->edge_weight, o->n, sizeof *o->edge_weight);
    fmb_mem_put(mem, o->member_role, o->n, sizeof *o->member_role);
    fmb_mem_put(mem, o->right, o->right_room, sizeof *o->right);
    fmb_mem_put(mem, o->slack, o->slack_room, sizeof *o->slack);
    fmb_mem_put(mem, o->row_weight, o->row_weight_room, sizeof *o->row_weight);
    fmb_mem_put(mem, o->row_role, o->row_role_room, sizeof *o->row_role);
    fmb_mem_put(mem, o->violated, o->violated_room, sizeof *o->violated);
    fmb_mem_put(mem, o->is_listed, o->listed_room, sizeof *o->is_listed);
}

fmb_status fmb_stand_grow(fmb_stand *o)
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
        st = fmb_spread_resize(&o->rate, mem, m);
    if (st == FMB_OK)
        st = fmb_columns_grow(&o->columns);
    if (st != FMB_OK)
        return st;
    for (size_t i = o->m; i < m; i++) {
        o->right[i] = o->f->right[i];
        o->slack[i] = 0;
        fmb_stand_note_role(o, i);
    }
    o->m = m;
    o->feasible = false;
    return FMB_OK;
}

/* ---- the basis ------------------------------------------------------------------------------- */

/* Of a row outside of the basis. */
void fmb_stand_note_role(fmb_stand *o, size_t i)
{
    o->row_role[i] = o->f->off[i]                     ? FMB_ROLE_FREE
                     : fmb_reals_is_equality(o->f, i) ? FMB_ROLE_EQUAL
                                                      : FMB_ROLE_LESS;
}

/* The member at place r is noted as such. */
static void note_member(fmb_stand *o, size_t r)
{
    size_t i = o->corner.member[r];
    o->member_role[r] = FMB_ROLE_FREE;
    if (i >= FMB_UNIT)
        return;
    fmb_stand_note_role(o, i);
    o->member_role[r] = o->row_role[i];
    o->row_role[i] = FMB_ROLE_FREE;
}

fmb_status fmb_stand_place(fmb_stand *o, const size_t *member)
{
    fmb_status st = fmb_corner_meet(&o->corner, member, &o->entry);
    for (size_t i = 0; i < o->m; i++)
        fmb_stand_note_role(o, i);
    for (size_t r = 0; r < o->n; r++)
        note_member(o, r);
    return st;
}

void fmb_stand_find_point(fmb_stand *o)
{
    for (size_t r = 0; r < o->n; r++) {
        size_t i = o->corner.member[r];
        o->given[r] = i < FMB_UNIT ? o->right[i] : 0;
    }
    fmb_corner_point(&o->corner, o->given, &o->edge);
}

/* Slacks from the basis; how far its rows are off. */
static double find_slacks(fmb_stand *o)
{
    double most = 0;
    fmb_stand_find_point(o);
    fmb_columns_times(&o->columns, &o->edge, &o->rate);
    if (o->m > 0)
        memcpy(o->slack, o->right, o->m * sizeof *o->slack);
    fmb_spread_subtract(&o->rate, 1, o->slack, o->f->run->kernels);
    for (size_t r = 0; r < o->n; r++) {
        size_t i = o->corner.member[r];
        if (i >= FMB_UNIT)
            continue;
        most = fmax(most, fabs(o->slack[i]) / (1 + fabs(o->right[i])));
        o->slack[i] = 0;
    }
    return most;
}

fmb_status fmb_stand_refresh(fmb_stand *o)
{
    fmb_status st = FMB_OK;
    if (fmb_corner_is_stale(&o->corner))
        st = fmb_stand_place(o, o->corner.member);
    if (st == FMB_OK && find_slacks(o) > INEXACT && o->corner.exchanges > 0) {
        st = fmb_stand_place(o, o->corner.member);
        if (st == FMB_OK)
            find_slacks(o);
    }
    if (st != FMB_OK)
        return st;
    fmb_corner_price(&o->corner, o->cost, &o->edge);
    memset(o->y, 0, o->n * sizeof *o->y);
    fmb_spread_subtract(&o->edge, -1, o->y, o->f->run->kernels);
    return FMB_OK;
}

/* ---- from corner to corner ------------------------------------------------------------------- */

void fmb_stand_look_along(fmb_stand *o, size_t r)
{
    fmb_corner_edge(&o->corner, r, &o->edge);
    fmb_columns_times(&o->columns, &o->edge, &o->rate);
}

fmb_status fmb_stand_exchange(fmb_stand *o, size_t r, size_t i)
{
    const fmb_kernels *k = o->f->run->kernels;
    size_t old = o->corner.member[r];
    double pivot = o->entry.at[r];
    double way = o->slack[i] / pivot, multiplier = o->y[r] / pivot;
    fmb_spread_subtract(&o->rate, way, o->slack, k);
    fmb_spread_subtract(&o->entry, multiplier, o->y, k);
    o->y[r] = multiplier;
    o->slack[i] = 0;
    fmb_status st = fmb_corner_replace(&o->corner, r, i, &o->entry, &o->edge);
    if (old < FMB_UNIT)
        fmb_stand_note_role(o, old);
    note_member(o, r);
    o->steps++;
    return st;
}

/* ---- rows that are switched off -------------------------------------------------------------- */

/* The row outside that the way along the edge meets first, either way, or FMB_NOWHERE. */
static size_t find_nearest_row(const fmb_stand *o)
{
    double least = INFINITY, most = 0;
    size_t best = FMB_NOWHERE;
    for (size_t t = 0; t < fmb_spread_count(&o->rate); t++) {
        size_t i = fmb_spread_key(&o->rate, t);
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
static fmb_status exchange_for_unit(fmb_stand *o, size_t r)
{
    size_t best = fmb_spread_key(&o->edge, 0), old = o->corner.member[r];
    assert(old < FMB_UNIT);
    for (size_t t = 1; t < fmb_spread_count(&o->edge); t++) {
        size_t j = fmb_spread_key(&o->edge, t);
        best = fabs(o->edge.at[j]) > fabs(o->edge.at[best]) ? j : best;
    }
    fmb_corner_write(&o->corner, FMB_UNIT + best, &o->entry);
    fmb_status st = fmb_corner_replace(&o->corner, r, FMB_UNIT + best, &o->entry, &o->edge);
    fmb_stand_note_role(o, old);
    note_member(o, r);
    return st == FMB_OK ? fmb_stand_refresh(o) : st;
}

fmb_status fmb_stand_expel(fmb_stand *o, size_t r)
{
    fmb_stand_look_along(o, r);
    size_t i = find_nearest_row(o);
    if (i == FMB_NOWHERE)
        return exchange_for_unit(o, r);
    fmb_corner_write(&o->corner, i, &o->entry);
    return fmb_stand_exchange(o, r, i);
}
