/* halving.c: intervals by elimination, by divide and conquer over sets of variables.
 *
 * When all other variables of a part have been eliminated, the remaining rows are the ends. Given a
 * set of variables to bound, one half is eliminated and the other half bounded recursively; then
 * the state before is restored, and the halves swap roles. So D variables cost about D log D
 * eliminations, not D (D - 1), and the first ones, which all share, are done once.
 */
#include <string.h>

#include "elim/round/mark.h"
#include "elim/round/witness.h"
#include "solve/bound/job.h"
#include "solve/bound/plane.h"
#include "solve/limit/outer.h"
#include "solve/limit/outer_ends.h"

/* ---- by elimination -------------------------------------------------------------------------- */

/* sign x_var <= sign value is the row divided by |its coefficient|; an equality may be negated. */
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
    FMB_THEN(st, fmb_bound_claim(j, &w));
    fmb_weights_clear(&w, j->q->run.mem);
    mpq_clear(t);
    return st;
}

/* The end is given by row, which names no other variable; FMB_NO_ROW: it is infinite. */
static fmb_status set_end_from_row(fmb_bound_job *j, const fmb_elim *e, uint32_t row)
{
    if (row != FMB_NO_ROW) {
        fmb_end_of_row(&e->row[row].v, e->n, j->column, j->end->value);
        j->end->attained = !e->row[row].strict;
        FMB_TRY(j->q->claims ? claim_end_of_row(j, e, row) : FMB_OK);
    } else if (j->q->claims) {
        mpq_set_si(j->q->x[j->column], j->sign, 1);
        FMB_TRY(fmb_elim_point(e, FMB_POINT_RAY, j->q->x));
        FMB_TRY(fmb_bound_claim_unbounded(j));
    }
    j->end->kind = row != FMB_NO_ROW ? FMB_END_FINITE : FMB_END_INFINITE;
    return FMB_OK;
}

/* Both ends of a variable. plane: one other variable remains; NULL: none does. */
static fmb_status read_both_ends(fmb_bound_job *j, fmb_elim *e, fmb_plane *plane,
                                 fmb_exact_side *side)
{
    for (int k = FMB_LOWER; k <= FMB_UPPER; k++) {
        uint32_t row;
        j->side = (fmb_side)k;
        j->sign = k == FMB_LOWER ? -1 : 1;
        j->end = &side[k];
        if (plane)
            FMB_TRY(fmb_plane_extreme(plane, j->sign, &row));
        else
            row = fmb_end_tightest_row(e, j->column, j->sign);
        FMB_TRY(set_end_from_row(j, e, row));
    }
    return FMB_OK;
}

/* ---- divide and conquer ---------------------------------------------------------------------- */

/* The recursion on one part. */
typedef struct split {
    fmb_query *q;
    const fmb_part *p;
    fmb_box *box;
    fmb_elim e;
    bool *drop;  /* [n] scratch */
    size_t *tie; /* [n] scratch */
    bool marks;  /* the elimination can be restored from a mark */
} split;

static fmb_status eliminate_columns(split *d, const int *column, int columns)
{
    for (int j = 0; j < d->p->n; j++)
        d->drop[j] = false;
    for (int i = 0; i < columns; i++)
        d->drop[column[i]] = true;
    return fmb_elim_eliminate(&d->e, d->drop);
}

/* Copy the ends of a column into every interval of its variable. */
static fmb_status read_ends_of_column(split *d, int column, fmb_plane *plane)
{
    fmb_bound_job j = {.q = d->q, .p = d->p, .var = d->p->var[column], .column = column};
    for (int i = 0; i < d->box->size; i++)
        if (d->box->var[i] == j.var)
            FMB_TRY(read_both_ends(&j, &d->e, plane, d->box->side[i]));
    return FMB_OK;
}

/* Bound x, where only x and y remain. *done false: that needs an elimination of y. */
static fmb_status read_ends_in_plane(split *d, int x, int y, bool *done)
{
    fmb_plane plane;
    fmb_status st = fmb_plane_open(&plane, &d->e, x, y, done);
    if (st != FMB_OK || !*done)
        return st;
    st = read_ends_of_column(d, x, &plane);
    fmb_plane_close(&plane);
    return st;
}

/* Add to each column's tie the number of rows that it shares with column c. */
static void add_shared_rows(split *d, int c)
{
    const fmb_elim *e = &d->e;
    for (size_t i = 0; i < e->live.size; i++) {
        const fmb_vec *v = &e->row[e->live.row[i]].v;
        for (size_t j = 0; fmb_vec_sgn(v, (size_t)c) != 0 && j < (size_t)e->n; j++)
            d->tie[j] += j != (size_t)c && fmb_vec_sgn(v, j) != 0;
    }
}

/* Order the columns before halving. So that variables of the same rows end up in the same half, the
 * column least tied to others comes first, then always the one most tied to its predecessors. */
static void order_by_shared_rows(split *d, int *column, int columns)
{
    memset(d->tie, 0, (size_t)d->p->n * sizeof *d->tie);
    for (int i = 0; i < columns; i++)
        add_shared_rows(d, column[i]);
    for (int i = 0; i < columns; i++) {
        int best = i;
        for (int k = i + 1; k < columns; k++) {
            size_t a = d->tie[column[k]], b = d->tie[column[best]];
            if (i == 0 ? a < b : a > b)
                best = k;
        }
        int c = column[best];
        column[best] = column[i];
        column[i] = c;
        if (i == 0)
            memset(d->tie, 0, (size_t)d->p->n * sizeof *d->tie);
        add_shared_rows(d, c);
    }
}

static fmb_status bound_remaining_columns(split *d, int *column, int columns);

/* Eliminate the n columns others[] and bound column[0..columns). */
static fmb_status bound_first_half(split *d, int *column, int columns, const int *others, int n)
{
    bool done = false;
    if (columns == 1) {
        FMB_TRY(eliminate_columns(d, others, n - 1));
        FMB_TRY(read_ends_in_plane(d, column[0], others[n - 1], &done));
        if (done)
            return FMB_OK;
        others += n - 1;
        n = 1;
    }
    FMB_TRY(eliminate_columns(d, others, n));
    return bound_remaining_columns(d, column, columns);
}

/* Bound column[0..columns), which are all remaining columns. */
static fmb_status bound_remaining_columns(split *d, int *column, int columns)
{
    fmb_mark mark;
    int half = columns / 2;
    if (columns == 1)
        return read_ends_of_column(d, column[0], NULL);
    order_by_shared_rows(d, column, columns);
    FMB_TRY(fmb_mark_set(&mark, &d->e));
    FMB_TRY(bound_first_half(d, column, half, column + half, columns - half));
    fmb_mark_return(&mark, &d->e);
    return bound_first_half(d, column + half, columns - half, column, half);
}

/* For rules whose state a mark cannot restore: bound each column from the start. */
static fmb_status bound_each_from_start(split *d, int *column, int columns)
{
    for (int i = 0; i < columns; i++) {
        for (int j = 0; j < d->p->n; j++)
            d->drop[j] = j != column[i];
        if (i > 0) {
            fmb_elim_clear(&d->e);
            FMB_TRY(fmb_query_load(d->q, d->p, true, &d->e));
        }
        FMB_TRY(fmb_elim_eliminate(&d->e, d->drop));
        FMB_TRY(read_ends_of_column(d, column[i], NULL));
    }
    return FMB_OK;
}

/* Put the columns of the box's variables first; returns their number. */
static int sort_columns_asked(const split *d, int *column)
{
    int asked = 0, others = d->p->n;
    for (int j = 0; j < d->p->n; j++)
        d->drop[j] = false;
    for (int i = 0; i < d->box->size; i++)
        if (d->q->parts.of_var[d->box->var[i]] == d->q->parts.of_var[d->p->var[0]])
            d->drop[d->q->parts.place[d->box->var[i]]] = true;
    for (int j = 0; j < d->p->n; j++)
        column[d->drop[j] ? asked++ : --others] = j;
    return asked;
}

fmb_status fmb_bound_by_elimination(fmb_query *q, int part, fmb_box *box)
{
    fmb_arena *arena = &q->v->arena;
    split d = {.q = q, .p = &q->parts.part[part], .box = box, .e.run = &q->run};
    size_t n = (size_t)d.p->n;
    int *column;
    FMB_TRY(FMB_ARENA_GET(arena, column, n));
    FMB_TRY(FMB_ARENA_GET(arena, d.drop, n));
    FMB_TRY(FMB_ARENA_GET(arena, d.tie, n));
    int asked = sort_columns_asked(&d, column);
    if (asked == 0)
        return FMB_OK;
    fmb_status st = fmb_query_load(q, d.p, true, &d.e);
    if (st == FMB_OK && !fmb_mark_possible(&d.e)) {
        st = bound_each_from_start(&d, column, asked);
    } else {
        FMB_THEN(st, eliminate_columns(&d, column + asked, d.p->n - asked));
        FMB_THEN(st, bound_remaining_columns(&d, column, asked));
    }
    fmb_status saved = st == FMB_LIMIT ? fmb_outer_from_rows(q, d.p, &d.e, box) : FMB_OK;
    fmb_elim_clear(&d.e);
    return saved != FMB_OK ? saved : st;
}
