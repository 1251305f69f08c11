/* implicit_equalities.c: see implicit_equalities.h.
 *
 * A form has an optimum over equalities if and only if it is a combination of them, and then its
 * multipliers say which.
 */
#include "lp/redundancy/implicit_equalities.h"

#include <math.h>
#include <string.h>

#include "lp/redundancy/active_set/leading_rows.h"

/* ---- equalities ------------------------------------------------------------------------------ */

/* Has row i a column that no equality before it has? Then it does not depend on them. */
static bool names_new_column(fmb_pruner *p, size_t i)
{
    const fmb_program_row *r = &p->all.row[i];
    bool news = false;
    for (size_t k = 0; k < r->size; k++) {
        news = news || !p->is_nonzero[r->column[k]];
        p->is_nonzero[r->column[k]] = true;
    }
    return news;
}

/* Add row i to the independent equalities, unless *depends: it is a combination of them. */
static fmb_status lock_row(fmb_pruner *p, size_t i, bool *depends)
{
    const fmb_program_row *r = &p->all.row[i];
    fmb_oracle_end end = FMB_ORACLE_UNBOUNDED;
    fmb_status st = FMB_OK;
    bool attained;
    if (!names_new_column(p, i)) {
        st = fmb_pruner_write_form(p, i);
        FMB_THEN(st, fmb_oracle_maximize(p->over_equal, &p->form, &end, &attained));
    }
    *depends = end == FMB_ORACLE_OPTIMUM;
    if (st != FMB_OK || *depends)
        return st;
    p->equality[p->equal.m] = i;
    st = fmb_program_add(&p->equal, r->size, r->column, NULL, r->value, FMB_EQ);
    return st == FMB_OK ? fmb_oracle_grow(p->over_equal) : st;
}

/* Like lock_row; a dependent row is removed, an independent one gets this fate. */
static fmb_status lock_or_drop_row(fmb_pruner *p, size_t i, fmb_fate fate)
{
    bool depends;
    FMB_TRY(lock_row(p, i, &depends));
    if (depends)
        return fmb_pruner_drop(p, p->over_equal, i, p->equality);
    p->fate[i] = fate;
    return FMB_OK;
}

fmb_status fmb_lock_equalities(fmb_pruner *p)
{
    for (size_t i = 0; i < p->m; i++)
        if (p->row[i].rel == FMB_EQ && p->fate[i] != FMB_FATE_REDUNDANT)
            FMB_TRY(lock_or_drop_row(p, i, FMB_FATE_KEPT));
    return FMB_OK;
}

/* ---- inequalities that are always tight ------------------------------------------------------ */

/* Is row i an inequality that may still turn out to be always tight? */
static bool is_row_open(const fmb_pruner *p, size_t i)
{
    return p->fate[i] == FMB_FATE_UNKNOWN && p->row[i].rel == FMB_LE;
}

/* Make open rows strict in the oracle, or weak again; their number. */
static size_t mark_open_rows(fmb_pruner *p, bool strict)
{
    size_t marked = 0;
    for (size_t i = 0; i < p->m; i++)
        if (is_row_open(p, i)) {
            p->all.row[i].rel = strict ? FMB_LT : FMB_LE;
            marked++;
        }
    p->all.any_strict = p->any_strict || (strict && marked > 0);
    return marked;
}

/* The conflict y gives 0 = sum_k y_k a_k and 0 = sum_k y_k b_k. Report its row at place `at`, i, as
 * an equality, since the other rows imply its reverse: -a_i = sum_{k != i} (y_k / y_i) a_k. */
static fmb_status tell_of_equality(fmb_pruner *p, const fmb_weights *y, size_t at)
{
    fmb_status st = FMB_OK;
    mpq_t t;
    if (!p->told || !p->told->equality)
        return FMB_OK;
    mpq_init(t);
    fmb_weights_clear(&p->w, p->run->mem);
    for (size_t k = 0; st == FMB_OK && k < y->size; k++) {
        mpq_div(t, y->value[k], y->value[at]);
        if (k != at)
            st = fmb_weights_add(&p->w, y->index[k], t, p->run->mem);
    }
    mpq_clear(t);
    return st == FMB_OK ? p->told->equality(p->told->self, y->index[at], &p->w) : st;
}

static fmb_status turn_row_into_equality(fmb_pruner *p, const fmb_weights *y, size_t at)
{
    size_t i = y->index[at];
    bool depends;
    fmb_pruner_leave_out(p, i);
    p->all.row[i].rel = FMB_EQ;
    fmb_pruner_take_in(p, i);
    FMB_TRY(lock_row(p, i, &depends));
    if (depends)
        return FMB_OK;
    p->fate[i] = FMB_FATE_EQUALITY;
    return tell_of_equality(p, y, at);
}

/* There is a solution, but none satisfies all open rows strictly: the open rows of the conflict, of
 * which there is at least one, are equalities. All of them are reported before dependent ones are
 * removed, as proofs name them. In the order of rows the first ones are kept. */
static fmb_status take_equalities_of_conflict(fmb_pruner *p)
{
    fmb_weights y = {0};
    fmb_status st = fmb_oracle_conflict(p->over_all, &y);
    memset(p->term, 0, p->m * sizeof *p->term);
    for (size_t k = 0; st == FMB_OK && k < y.size; k++)
        p->term[y.index[k]] = k + 1;
    for (size_t i = 0; st == FMB_OK && i < p->m; i++)
        if (p->term[i] > 0 && is_row_open(p, i))
            st = turn_row_into_equality(p, &y, p->term[i] - 1);
    for (size_t i = 0; st == FMB_OK && i < p->m; i++)
        if (p->term[i] > 0 && is_row_open(p, i))
            st = lock_or_drop_row(p, i, FMB_FATE_EQUALITY);
    fmb_weights_clear(&y, p->run->mem);
    return st;
}

/* Does a point satisfy all rows strictly? Then none is always tight. *room false: unknown. */
static fmb_status look_from_inside(fmb_pruner *p, bool *room)
{
    fmb_leading_rows t;
    *room = false;
    if (p->equal.m > 0)
        return FMB_OK;
    fmb_status st = fmb_leading_rows_open(&t, p->run->mem, p->n, p->m);
    if (st == FMB_OK)
        fmb_leading_rows_list_columns(&t, p->n, p->m, p->row);
    FMB_THEN(st, fmb_leading_rows_choose_units(&t, p->m, p->row));
    if (st == FMB_OK) {
        for (size_t i = 0; i < p->m; i++)
            if (p->fate[i] != FMB_FATE_REDUNDANT)
                fmb_leading_rows_add(&t, p->row[i].v, p->sum);
        st = fmb_leading_rows_find_inside(&t, p->run, INFINITY, room);
    }
    fmb_leading_rows_close(&t);
    return st;
}

fmb_status fmb_find_implicit_equalities(fmb_pruner *p)
{
    bool room;
    fmb_status st = look_from_inside(p, &room);
    while (st == FMB_OK && !room && mark_open_rows(p, true) > 0) {
        st = fmb_oracle_feasible(p->over_all, &room);
        mark_open_rows(p, false);
        if (st == FMB_OK && !room)
            st = take_equalities_of_conflict(p);
    }
    return st;
}
