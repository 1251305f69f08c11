/* elimination_ends.c: intervals by elimination: when all other variables of a part are gone, the
 * rows that remain are the ends.
 */
#include "elim/round/witness.h"
#include "solve/bound/job.h"
#include "solve/limit/outer.h"
#include "solve/limit/outer_ends.h"

/* sign x_var <= sign value is the row divided by |its coefficient|; an equality may be turned
 * round. */
static fmb_status claim_end_of_row(fmb_bound_job *j, const fmb_elim *e, uint32_t row)
{
    const fmb_derived *r = &e->row[row];
    fmb_weights w = {0};
    mpq_t t;
    mpq_init(t);
    mpz_set_si(mpq_numref(t), j->sign);
    fmb_vec_get(&r->v, (size_t)j->column, mpq_denref(t));
    mpq_canonicalize(t);
    fmb_status st = fmb_query_derive(j->q, e, row, t, &w);
    if (st == FMB_OK) {
        mpq_set(j->q->x[j->column], j->end->value);
        st = fmb_elim_point(e, j->end->attained ? FMB_POINT_INSIDE : FMB_POINT_CLOSURE, j->q->x);
    }
    if (st == FMB_OK)
        st = fmb_bound_claim(j, &w);
    fmb_weights_clear(&w, j->q->run.mem);
    mpq_clear(t);
    return st;
}

/* The end is in row, which names no other variable; FMB_NO_ROW: it is infinite. */
static fmb_status set_end_from_row(fmb_bound_job *j, const fmb_elim *e, uint32_t row)
{
    fmb_status st = FMB_OK;
    if (row != FMB_NO_ROW) {
        fmb_end_of_row(&e->row[row].v, e->n, j->column, j->end->value);
        j->end->attained = !e->row[row].strict;
        st = j->q->claims ? claim_end_of_row(j, e, row) : FMB_OK;
    } else if (j->q->claims) {
        mpq_set_si(j->q->x[j->column], j->sign, 1);
        st = fmb_elim_point(e, FMB_POINT_RAY, j->q->x);
        if (st == FMB_OK)
            st = fmb_bound_claim_unbounded(j);
    }
    if (st == FMB_OK)
        j->end->kind = row != FMB_NO_ROW ? FMB_END_FINITE : FMB_END_INFINITE;
    return st;
}

static fmb_status read_both_ends(fmb_bound_job *j, const fmb_elim *e, fmb_exact_side *side)
{
    fmb_status st = FMB_OK;
    for (int k = FMB_LOWER; st == FMB_OK && k <= FMB_UPPER; k++) {
        j->side = (fmb_side)k;
        j->sign = k == FMB_LOWER ? -1 : 1;
        j->end = &side[k];
        st = set_end_from_row(j, e, fmb_end_tightest_row(e, j->column, j->sign));
    }
    return st;
}

/* Into every interval of the column's variable. */
static fmb_status bound_column(fmb_query *q, const fmb_part *p, fmb_box *box, int column,
                               bool *drop)
{
    fmb_bound_job j = {.q = q, .p = p, .var = p->var[column], .column = column};
    fmb_elim e;
    for (int k = 0; k < p->n; k++)
        drop[k] = k != column;
    fmb_status st = fmb_query_load(q, p, true, &e);
    if (st == FMB_OK)
        st = fmb_elim_eliminate(&e, drop);
    for (int i = 0; st == FMB_OK && i < box->size; i++)
        if (box->var[i] == j.var)
            st = read_both_ends(&j, &e, box->side[i]);
    fmb_status saved = st == FMB_LIMIT ? fmb_outer_from_rows(q, p, &e, box) : FMB_OK;
    fmb_elim_clear(&e);
    return saved != FMB_OK ? saved : st;
}

fmb_status fmb_bound_by_elimination(fmb_query *q, int part, fmb_box *box)
{
    fmb_arena *arena = &q->v->arena;
    const fmb_part *p = &q->parts.part[part];
    bool *drop = fmb_arena_get(arena, (size_t)p->n, sizeof *drop);
    bool *asked = fmb_arena_get(arena, (size_t)p->n, sizeof *asked);
    if (!drop || !asked)
        return fmb_mem_status(arena->mem);
    fmb_status st = fmb_query_write_rows(q, part);
    fmb_arena_place place = fmb_arena_tell(arena);
    for (int j = 0; j < p->n; j++)
        asked[j] = false;
    for (int i = 0; i < box->size; i++)
        if (q->parts.of_var[box->var[i]] == part)
            asked[q->parts.place[box->var[i]]] = true;
    for (int j = 0; st == FMB_OK && j < p->n; j++) {
        st = asked[j] ? bound_column(q, p, box, j, drop) : FMB_OK;
        fmb_arena_rewind(arena, place);
    }
    return st;
}
