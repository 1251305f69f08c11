/* first_basis.c: see first_basis.h.
 *
 * A column in only one row of a list of equalities is lone. Such a row is removed from the list: it
 * enters the basis in place of the bound of a lone column, if the dual method would let that member
 * leave, or stays outside. So do all rows that finally have no lone column.
 *
 * Theorem. Each row that enters is a step of the dual method, and is written in the basis as in the
 * program.
 *
 * Proof. Columns whose bounds have left are in no row of the list: each was lone. So a row of the
 * list has only columns whose bounds are members, and is the combination of those. When its own
 * lone column moves away from its bound, columns whose bounds left before follow, and no others. No
 * row of the list has any of these, so all rows of the list are as tight as initially; nor do
 * multipliers of rows that entered before change, as they are not in the combination. So the slacks
 * of the first vertex, and multipliers that are updated, are those of the method.
 *
 * The members are a triangle, in the order in which they entered.
 *
 * Source: Bixby 1992, Implementing the simplex method: The initial basis.
 */
#include "lp/simplex/first_basis.h"

#include <math.h>

#include "base/arrays.h"

/* Least pivot, where the largest entry of its row is about 1. */
#define LEAST_PIVOT 0.1
/* Multipliers may become negative by so much. */
#define SLIP 1e-9

typedef struct equality_list {
    fmb_simplex_state *o;
    size_t *member;     /* [n] by place, which is the column */
    int *count;         /* [n] rows of the list that have the column */
    size_t *sum;        /* [n] sum of the numbers of these rows: if there is one, that row */
    int *lone;          /* [n] columns found to be lone, not processed yet */
    size_t lones, rows; /* rows: number of rows that entered */
} equality_list;

static void note_if_lone(equality_list *t, int j)
{
    if (t->count[j] == 1)
        t->lone[t->lones++] = j;
}

static bool may_come_in(const fmb_simplex_state *o, size_t i)
{
    return o->row_role[i] == FMB_ROLE_EQUAL && o->f->p->row[i].size > 1;
}

static bool may_any_come_in(const fmb_simplex_state *o)
{
    bool any = false;
    for (size_t i = 0; i < o->m && !any; i++)
        any = may_come_in(o, i);
    return any;
}

static void list_rows(equality_list *t)
{
    const fmb_simplex_state *o = t->o;
    for (size_t i = 0; i < o->m; i++) {
        const int *column = fmb_scaled_program_columns(o->f, i);
        for (size_t k = 0; may_come_in(o, i) && k < o->f->p->row[i].size; k++) {
            t->count[column[k]]++;
            t->sum[column[k]] += i;
        }
    }
    for (size_t j = 0; j < o->n; j++)
        note_if_lone(t, (int)j);
}

static void drop_row(equality_list *t, size_t i)
{
    const int *column = fmb_scaled_program_columns(t->o->f, i);
    for (size_t k = 0; k < t->o->f->p->row[i].size; k++) {
        t->count[column[k]]--;
        t->sum[column[k]] -= i;
        note_if_lone(t, column[k]);
    }
}

/* ---- one step -------------------------------------------------------------------------------- */

/* Entry of row i, written in the basis, at the place of the column of its term k. */
static double find_entry(const equality_list *t, size_t i, size_t k)
{
    const fmb_scaled_program *f = t->o->f;
    size_t old = t->o->basis.member[fmb_scaled_program_columns(f, i)[k]];
    double a = f->value[f->start[i] + k];
    return old < FMB_UNIT ? a / f->value[f->start[old]] : a;
}

/* The rate at which the multiplier there decreases as row i enters with this sign, and its start;
 * one that must be 0 may leave at once. */
static double find_fall(const equality_list *t, size_t i, size_t k, double sign, double *from)
{
    const fmb_simplex_state *o = t->o;
    size_t j = (size_t)fmb_scaled_program_columns(o->f, i)[k];
    double entry = sign * find_entry(t, i, k);
    bool may_fall = o->member_role[j] == FMB_ROLE_LESS;
    *from = may_fall ? fmax(o->y[j], 0) : 0;
    return may_fall ? entry : o->member_role[j] == FMB_ROLE_FREE ? fabs(entry) : 0;
}

/* The term of row i whose column's member leaves: of those that soon become negative the one with
 * the largest coefficient, among lone columns; SIZE_MAX: there is none. */
static size_t find_leaving_term(const equality_list *t, size_t i, double sign)
{
    const fmb_scaled_program *f = t->o->f;
    double least = INFINITY, most = LEAST_PIVOT, from;
    size_t best = SIZE_MAX, size = f->p->row[i].size;
    for (size_t k = 0; k < size; k++) {
        double fall = find_fall(t, i, k, sign, &from);
        if (fall > 0)
            least = fmin(least, (from + SLIP) / fall);
    }
    for (size_t k = 0; k < size; k++) {
        double fall = find_fall(t, i, k, sign, &from), a = fabs(f->value[f->start[i] + k]);
        bool is_lone = t->count[fmb_scaled_program_columns(f, i)[k]] == 1;
        if (is_lone && fall > 0 && a > most && from <= least * fall) {
            most = a;
            best = k;
        }
    }
    return best;
}

/* Put row i in place of the member at the column of its term k. */
static void take_row(equality_list *t, size_t i, size_t k)
{
    const int *column = fmb_scaled_program_columns(t->o->f, i);
    double *y = t->o->y, multiplier = y[column[k]] / find_entry(t, i, k);
    for (size_t l = 0; l < t->o->f->p->row[i].size; l++)
        y[column[l]] -= multiplier * find_entry(t, i, l);
    t->member[column[k]] = i;
    t->rows++;
}

/* ---- all steps ------------------------------------------------------------------------------- */

/* A row that is already tight may enter with either sign. */
static void take_or_drop_row(equality_list *t, size_t i)
{
    double slack = t->o->slack[i], sign = slack < 0 ? 1 : -1;
    size_t k = find_leaving_term(t, i, sign);
    if (k == SIZE_MAX && fabs(slack) <= fmb_simplex_state_tolerance(t->o))
        k = find_leaving_term(t, i, -sign);
    if (k != SIZE_MAX)
        take_row(t, i, k);
    drop_row(t, i);
}

static void work_off_list(equality_list *t)
{
    while (t->lones > 0) {
        int j = t->lone[--t->lones];
        if (t->count[j] == 1)
            take_or_drop_row(t, t->sum[j]);
    }
}

static fmb_status find_first_basis(equality_list *t)
{
    FMB_TRY(fmb_simplex_state_refresh(t->o));
    memcpy(t->member, t->o->basis.member, t->o->n * sizeof *t->member);
    list_rows(t);
    work_off_list(t);
    fmb_run_count(t->o->f->run, 10 * t->o->f->start[t->o->m]);
    FMB_TRY(fmb_run_poll(t->o->f->run));
    return t->rows > 0 ? fmb_simplex_state_place(t->o, t->member) : FMB_OK;
}

fmb_status fmb_first_basis(fmb_simplex_state *o)
{
    fmb_mem *mem = o->f->run->mem;
    equality_list t = {.o = o, .member = o->basis.old};
    if (!may_any_come_in(o))
        return FMB_OK;
    const fmb_array arrays[] = {FMB_ARRAY_ZERO(t.count, o->n), FMB_ARRAY_ZERO(t.sum, o->n),
                                FMB_ARRAY(t.lone, o->n)};
    fmb_status st = fmb_arrays(mem, true, FMB_ALL(arrays));
    FMB_THEN(st, find_first_basis(&t));
    (void)fmb_arrays(mem, false, FMB_ALL(arrays));
    return st;
}
