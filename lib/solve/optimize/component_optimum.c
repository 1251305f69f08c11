/* component_optimum.c: see component_optimum.h. */
#include "solve/optimize/component_optimum.h"

#include "elim/round/witness.h"
#include "num/rationals.h"
#include "solve/limit/outer.h"
#include "solve/limit/outer_ends.h"

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_component_optimum_init(fmb_component_optimum *k, fmb_query *q)
{
    *k = (fmb_component_optimum){.room = 1};
    mpq_init(k->value);
    for (int c = 0; c < q->parts.count; c++)
        if ((size_t)q->parts.part[c].n + 1 > k->room)
            k->room = (size_t)q->parts.part[c].n + 1;
    return fmb_rationals_new(&k->x, k->room, q->run.mem);
}

void fmb_component_optimum_clear(fmb_component_optimum *k, fmb_query *q)
{
    fmb_weights_clear(&k->w, q->run.mem);
    fmb_rationals_free(k->x, k->room, q->run.mem);
    mpq_clear(k->value);
}

static void forget_optimum(fmb_component_optimum *k, fmb_query *q)
{
    k->kind = FMB_END_UNKNOWN;
    k->attained = k->clash = k->reached = false;
    fmb_weights_clear(&k->w, q->run.mem);
}

/* Drop the weight of the row z = goal, which is no row of the part. */
static void drop_weight_of_goal_row(fmb_component_optimum *k, const fmb_part *with_objective)
{
    size_t kept = 0;
    for (size_t i = 0; i < k->w.size; i++) {
        if (k->w.index[i] == with_objective->m - 1)
            continue;
        k->w.index[kept] = k->w.index[i];
        mpq_swap(k->w.value[kept++], k->w.value[i]);
    }
    for (; k->w.size > kept; k->w.size--)
        mpq_clear(k->w.value[k->w.size - 1]);
}

/* ---- by the oracle --------------------------------------------------------------------------- */

/* The goal over the columns of a part. */
static fmb_status weigh_columns(fmb_query *q, const fmb_goal *g, const fmb_part *p,
                                fmb_weights *cost)
{
    for (int j = 0; j < p->n; j++)
        if (mpq_sgn(g->coef[p->var[j]]) != 0)
            FMB_TRY(fmb_weights_add(cost, (uint32_t)j, g->coef[p->var[j]], q->run.mem));
    return FMB_OK;
}

fmb_status fmb_component_optimum_lean(fmb_query *q, const fmb_goal *g, int part)
{
    fmb_oracle *o;
    fmb_weights cost = {0};
    fmb_status st = fmb_query_oracle(q, part, &o);
    FMB_THEN(st, weigh_columns(q, g, &q->parts.part[part], &cost));
    FMB_THEN(st, fmb_oracle_lean(o, &cost));
    fmb_weights_clear(&cost, q->run.mem);
    return st;
}

static fmb_status read_optimum_of_oracle(fmb_query *q, const fmb_part *p, const fmb_oracle *o,
                                         fmb_component_optimum *k)
{
    k->kind = FMB_END_FINITE;
    fmb_status st = fmb_oracle_value(o, k->value);
    for (int j = 0; j < p->n; j++) /* the first solution is often optimal */
        mpq_set(k->x[j], q->point[p->var[j]]);
    FMB_THEN(st, fmb_oracle_point(o, k->x));
    if (st == FMB_OK && q->claims)
        st = fmb_oracle_multipliers(o, &k->w);
    return st == FMB_OK && q->claims ? fmb_query_take_oracle_weights(q, p, &k->w) : st;
}

fmb_status fmb_component_optimum_by_oracle(fmb_query *q, const fmb_goal *g, int part,
                                           fmb_component_optimum *k)
{
    const fmb_part *p = &q->parts.part[part];
    fmb_oracle *o = NULL;
    fmb_oracle_end end = FMB_ORACLE_OPTIMUM;
    fmb_weights cost = {0};
    forget_optimum(k, q);
    fmb_status st = fmb_query_feasible_oracle(q, part, &o);
    FMB_THEN(st, weigh_columns(q, g, p, &cost));
    FMB_THEN(st, fmb_oracle_maximize(o, &cost, &end, &k->attained));
    k->reached = st == FMB_LIMIT && o && fmb_oracle_reached(o, k->x);
    fmb_weights_clear(&cost, q->run.mem);
    if (st == FMB_OK && end == FMB_ORACLE_UNBOUNDED) {
        k->kind = FMB_END_INFINITE;
        return fmb_oracle_ray(o, k->x);
    }
    return st == FMB_OK ? read_optimum_of_oracle(q, p, o, k) : st;
}

/* ---- by elimination -------------------------------------------------------------------------- */

/* Take z <= value from that row of the store, divided by its coefficient. */
static fmb_status take_optimum_from_row(fmb_query *q, const fmb_elim *e, uint32_t row,
                                        fmb_component_optimum *k)
{
    const fmb_derived *r = &e->row[row];
    mpq_t t;
    mpq_init(t);
    mpz_set_ui(mpq_numref(t), 1);
    fmb_vec_get(&r->v, (size_t)e->n - 1, mpq_denref(t));
    mpq_canonicalize(t);
    fmb_end_of_row(&r->v, e->n, e->n - 1, k->value);
    fmb_status st = fmb_query_derive(q, e, row, t, &k->w);
    mpq_clear(t);
    return st;
}

/* Only z remains, and `row` bounds it; FMB_NO_ROW: no row does. */
static fmb_status read_optimum_of_store(fmb_query *q, const fmb_elim *e, uint32_t row,
                                        fmb_component_optimum *k)
{
    mpq_ptr z = k->x[e->n - 1];
    if (row == FMB_NO_ROW) {
        mpq_set_ui(z, 1, 1);
        k->kind = FMB_END_INFINITE;
        return fmb_elim_point(e, FMB_POINT_RAY, k->x);
    }
    FMB_TRY(take_optimum_from_row(q, e, row, k));
    k->kind = FMB_END_FINITE;
    k->attained = !e->row[row].strict;
    mpq_set(z, k->value);
    return fmb_elim_point(e, k->attained ? FMB_POINT_INSIDE : FMB_POINT_CLOSURE, k->x);
}

/* Bound z by propagation of ends over the rows of e. */
static fmb_status find_outer_optimum(fmb_query *q, const fmb_part *p, fmb_elim *e,
                                     fmb_component_optimum *k)
{
    fmb_ends f;
    fmb_status st = fmb_ends_open(&f, e);
    FMB_THEN(st, fmb_ends_find(&f));
    if (st == FMB_OK && e->clash != FMB_NO_ROW) {
        st = fmb_query_claim_clash(q, p, e);
        k->clash = st == FMB_OK;
    } else if (st == FMB_OK && f.row[FMB_UPPER][e->n - 1] != FMB_NO_ROW) {
        st = take_optimum_from_row(q, e, f.row[FMB_UPPER][e->n - 1], k);
        if (st == FMB_OK)
            k->kind = FMB_END_OUTER;
    }
    fmb_ends_clear(&f);
    return st == FMB_LIMIT ? FMB_OK : st;
}

/* The most rows of an interrupted elimination that are used: with more, derivations are long. */
#define MOST_ROWS_AT_LIMIT ((size_t)1 << 15)

static fmb_status eliminate_all_but_goal(fmb_query *q, const fmb_part *p, fmb_elim *e,
                                         fmb_component_optimum *k)
{
    bool *drop;
    FMB_TRY(FMB_ARENA_GET(&q->v->arena, drop, (size_t)p->n));
    for (int j = 0; j < p->n; j++)
        drop[j] = j < p->n - 1;
    fmb_status st = fmb_elim_eliminate(e, drop);
    if (st == FMB_OK)
        return read_optimum_of_store(q, e, fmb_end_tightest_row(e, p->n - 1, 1), k);
    fmb_status saved =
        st == FMB_LIMIT && e->rows <= MOST_ROWS_AT_LIMIT ? find_outer_optimum(q, p, e, k) : FMB_OK;
    return saved != FMB_OK ? saved : st;
}

/* Find the optimum in a store of the part with the additional objective column z. */
static fmb_status find_in_store(fmb_query *q, const fmb_goal *g, int part, fmb_component_optimum *k,
                                fmb_status find(fmb_query *, const fmb_part *, fmb_elim *,
                                                fmb_component_optimum *))
{
    fmb_objective_column w = {0};
    fmb_elim e = {.run = &q->run};
    fmb_arena_place place = fmb_arena_tell(&q->v->arena);
    fmb_status st = fmb_objective_column_init(&w, q, part, g);
    if (st == FMB_OK) {
        st = fmb_query_load(q, &w.p, true, &e);
        FMB_THEN(st, find(q, &w.p, &e, k));
        fmb_elim_clear(&e);
    }
    drop_weight_of_goal_row(k, &w.p);
    fmb_objective_column_clear(&w);
    fmb_arena_rewind(&q->v->arena, place);
    return st;
}

fmb_status fmb_component_optimum_by_elimination(fmb_query *q, const fmb_goal *g, int part,
                                                fmb_component_optimum *k)
{
    forget_optimum(k, q);
    return find_in_store(q, g, part, k, eliminate_all_but_goal);
}

fmb_status fmb_component_optimum_at_limit(fmb_query *q, const fmb_goal *g, int part,
                                          fmb_component_optimum *k)
{
    forget_optimum(k, q);
    if (!fmb_outer_is_cheap(&q->parts.part[part]))
        return FMB_OK;
    fmb_status st = find_in_store(q, g, part, k, find_outer_optimum);
    return st == FMB_LIMIT ? FMB_OK : st;
}
