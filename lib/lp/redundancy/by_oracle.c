/* by_oracle.c: see by_oracle.h.
 *
 * Two oracles: one of all rows that have not gone, in which the row at hand is switched off, and
 * one of the equalities alone. A form has an optimum over equalities if and only if it is a
 * combination of them, and then its multipliers say which.
 */
#include "lp/redundancy/by_oracle.h"

#include "base/ways.h"

#include <string.h>

#include "num/rationals.h"

typedef struct pruner {
    fmb_run *run;
    size_t n, m;
    const fmb_lp_row *row;
    fmb_fate *fate;
    const fmb_verdicts *told;
    bool as_given;          /* no inequality becomes an equality */
    fmb_program all, equal; /* every row, those gone being off; the equalities that stay */
    fmb_oracle *over_all, *over_equal;
    size_t *equality; /* [m] rows of `equal` */
    bool *is_nonzero; /* [n] columns that some equality names */
    bool *slack;      /* [m] known to be positive somewhere */
    mpq_t *inner, *x; /* [n] some solution; scratch */
    mpq_t sum, term;
    fmb_weights form, w; /* scratch */
} pruner;

/* ---- life ------------------------------------------------------------------------------------ */

static void close_pruner(pruner *p)
{
    fmb_mem *mem = p->run->mem;
    fmb_oracle_free(p->over_all);
    fmb_oracle_free(p->over_equal);
    fmb_program_clear(&p->all);
    fmb_program_clear(&p->equal);
    fmb_weights_clear(&p->form, mem);
    fmb_weights_clear(&p->w, mem);
    fmb_mem_put(mem, p->equality, p->m, sizeof *p->equality);
    fmb_mem_put(mem, p->is_nonzero, p->n, sizeof *p->is_nonzero);
    fmb_mem_put(mem, p->slack, p->m, sizeof *p->slack);
    fmb_rationals_free(p->inner, p->n, mem);
    fmb_rationals_free(p->x, p->n, mem);
    mpq_clears(p->sum, p->term, NULL);
}

static fmb_status load_all_rows(pruner *p)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < p->m; i++) {
        st = fmb_program_add_dense(&p->all, p->row[i].v, p->row[i].rel);
        if (st == FMB_OK)
            p->all.row[i].off = p->fate[i] == FMB_FATE_REDUNDANT;
    }
    if (st == FMB_OK)
        st = fmb_oracle_new(p->run, &p->all, &p->over_all);
    return st == FMB_OK ? fmb_oracle_new(p->run, &p->equal, &p->over_equal) : st;
}

static fmb_status open_pruner(pruner *p)
{
    fmb_mem *mem = p->run->mem;
    fmb_program_init(&p->all, mem, (int)p->n);
    fmb_program_init(&p->equal, mem, (int)p->n);
    mpq_inits(p->sum, p->term, NULL);
    p->equality = fmb_mem_get(mem, p->m, sizeof *p->equality);
    p->is_nonzero = fmb_mem_zero(mem, p->n, sizeof *p->is_nonzero);
    p->slack = fmb_mem_zero(mem, p->m, sizeof *p->slack);
    fmb_status st = p->equality && p->is_nonzero && p->slack ? FMB_OK : fmb_mem_status(mem);
    if (st == FMB_OK)
        st = fmb_rationals_new(&p->inner, p->n, mem);
    if (st == FMB_OK)
        st = fmb_rationals_new(&p->x, p->n, mem);
    return st == FMB_OK ? load_all_rows(p) : st;
}

/* ---- forms ----------------------------------------------------------------------------------- */

/* sum = a_i.x - b_i times `sign`; without b_i for a direction. */
static int sign_of_excess(pruner *p, size_t i, mpq_t *x, bool is_direction)
{
    const fmb_program_row *r = &p->all.row[i];
    mpq_set_ui(p->sum, 0, 1);
    for (size_t k = 0; k < r->size; k++) {
        if (mpq_sgn(x[r->column[k]]) == 0)
            continue;
        fmb_vec_get_q(r->value, k, p->term);
        mpq_mul(p->term, p->term, x[r->column[k]]);
        mpq_add(p->sum, p->sum, p->term);
    }
    fmb_vec_get_q(r->value, r->size, p->term);
    if (!is_direction)
        mpq_sub(p->sum, p->sum, p->term);
    return mpq_sgn(p->sum);
}

/* Maximize sign * a_i.x. */
static fmb_status maximize_row(pruner *p, fmb_oracle *o, size_t i, int sign, fmb_oracle_end *end)
{
    const fmb_program_row *r = &p->all.row[i];
    fmb_status st = FMB_OK;
    bool attained;
    mpq_t a;
    mpq_init(a);
    fmb_weights_clear(&p->form, p->run->mem);
    for (size_t k = 0; st == FMB_OK && k < r->size; k++) {
        fmb_vec_get_q(r->value, k, a);
        if (sign < 0)
            mpq_neg(a, a);
        st = fmb_weights_add(&p->form, (uint32_t)r->column[k], a, p->run->mem);
    }
    mpq_clear(a);
    return st == FMB_OK ? fmb_oracle_maximize(o, &p->form, end, &attained) : st;
}

/* Tell of row i, with the multipliers of the last optimum; place numbers its rows, NULL: as here.
 */
static fmb_status tell_with_weights(pruner *p, const fmb_oracle *o, size_t i, const size_t *place,
                                    fmb_status (*whom)(void *, size_t, const fmb_weights *))
{
    if (!whom)
        return FMB_OK;
    fmb_weights_clear(&p->w, p->run->mem);
    fmb_status st = fmb_oracle_multipliers(o, &p->w);
    for (size_t k = 0; place && k < p->w.size; k++)
        p->w.index[k] = (uint32_t)place[p->w.index[k]];
    return st == FMB_OK ? whom(p->told->self, i, &p->w) : st;
}

static void leave_out_row(pruner *p, size_t i)
{
    p->all.row[i].off = true;
    fmb_oracle_switch(p->over_all, i, false);
}

static void take_in_row(pruner *p, size_t i)
{
    p->all.row[i].off = false;
    fmb_oracle_switch(p->over_all, i, true);
}

static fmb_status drop_row_with_weights(pruner *p, const fmb_oracle *o, size_t i,
                                        const size_t *place)
{
    p->fate[i] = FMB_FATE_REDUNDANT;
    leave_out_row(p, i);
    return tell_with_weights(p, o, i, place, p->told ? p->told->redundant : NULL);
}

/* ---- equalities ------------------------------------------------------------------------------ */

/* Does an equality have a column that no other one has so far? Then it depends on none. */
static bool names_new_column(pruner *p, size_t i)
{
    const fmb_program_row *r = &p->all.row[i];
    bool news = false;
    for (size_t k = 0; k < r->size; k++) {
        news = news || !p->is_nonzero[r->column[k]];
        p->is_nonzero[r->column[k]] = true;
    }
    return news;
}

/* Row i is an equality, and joins the others, or goes if it depends on them; *depends tells. */
static fmb_status lock_row_by_oracle(pruner *p, size_t i, bool *depends)
{
    const fmb_program_row *r = &p->all.row[i];
    fmb_oracle_end end = FMB_ORACLE_UNBOUNDED;
    fmb_status st = FMB_OK;
    if (!names_new_column(p, i))
        st = maximize_row(p, p->over_equal, i, 1, &end);
    *depends = end == FMB_ORACLE_OPTIMUM;
    if (st != FMB_OK || *depends)
        return st == FMB_OK ? drop_row_with_weights(p, p->over_equal, i, p->equality) : st;
    p->equality[p->equal.m] = i;
    st = fmb_program_add(&p->equal, r->size, r->column, NULL, r->value, FMB_EQ);
    return st == FMB_OK ? fmb_oracle_grow(p->over_equal) : st;
}

static fmb_status lock_equalities(pruner *p)
{
    fmb_status st = FMB_OK;
    bool depends;
    for (size_t i = 0; st == FMB_OK && i < p->m; i++) {
        if (p->row[i].rel != FMB_EQ || p->fate[i] == FMB_FATE_REDUNDANT)
            continue;
        st = lock_row_by_oracle(p, i, &depends);
        if (st == FMB_OK && !depends)
            p->fate[i] = FMB_FATE_KEPT;
    }
    return st;
}

static void note_slacks_at_point(pruner *p, mpq_t *x)
{
    for (size_t i = 0; i < p->m; i++)
        p->slack[i] = p->slack[i] || sign_of_excess(p, i, x, false) < 0;
}

/* The last optimum of -a_i.x was -b_i: row i is an equality. */
static fmb_status turn_row_into_equality(pruner *p, size_t i)
{
    bool depends;
    fmb_status st = tell_with_weights(p, p->over_all, i, NULL, p->told ? p->told->equality : NULL);
    leave_out_row(p, i);
    p->all.row[i].rel = FMB_EQ;
    take_in_row(p, i);
    if (st == FMB_OK)
        st = lock_row_by_oracle(p, i, &depends);
    if (st == FMB_OK && !depends)
        p->fate[i] = FMB_FATE_EQUALITY;
    return st;
}

static fmb_status find_equality_by_oracle(pruner *p, size_t i)
{
    fmb_oracle_end end;
    if (p->slack[i])
        return FMB_OK;
    fmb_status st = maximize_row(p, p->over_all, i, -1, &end);
    if (st != FMB_OK || end == FMB_ORACLE_UNBOUNDED)
        return st;
    fmb_oracle_point(p->over_all, p->x);
    if (sign_of_excess(p, i, p->x, false) == 0)
        return turn_row_into_equality(p, i);
    note_slacks_at_point(p, p->x);
    return FMB_OK;
}

/* ---- inequalities ---------------------------------------------------------------------------- */

/* The last optimum, or the ray if there was none, breaks row i: x is a point that does. */
static void find_point_beyond(pruner *p, size_t i, fmb_oracle_end end)
{
    if (end == FMB_ORACLE_OPTIMUM) {
        fmb_oracle_point(p->over_all, p->x);
        return;
    }
    mpq_t length;
    mpq_init(length);
    fmb_oracle_ray(p->over_all, p->x);
    sign_of_excess(p, i, p->inner, false);
    mpq_set_ui(length, 1, 1);
    mpq_sub(length, length, p->sum); /* slack + 1 */
    sign_of_excess(p, i, p->x, true);
    mpq_div(length, length, p->sum);
    for (size_t j = 0; j < p->n; j++) {
        mpq_mul(p->x[j], p->x[j], length);
        mpq_add(p->x[j], p->x[j], p->inner[j]);
    }
    mpq_clear(length);
}

static fmb_status test_row_by_oracle(pruner *p, size_t i)
{
    fmb_oracle_end end;
    leave_out_row(p, i);
    fmb_status st = maximize_row(p, p->over_all, i, 1, &end);
    if (st != FMB_OK)
        return st;
    if (end == FMB_ORACLE_OPTIMUM)
        fmb_oracle_point(p->over_all, p->x);
    if (end == FMB_ORACLE_OPTIMUM && sign_of_excess(p, i, p->x, false) <= 0)
        return drop_row_with_weights(p, p->over_all, i, NULL);
    p->fate[i] = FMB_FATE_KEPT;
    if (p->told && p->told->irredundant) {
        find_point_beyond(p, i, end);
        st = p->told->irredundant(p->told->self, i, p->x);
    }
    take_in_row(p, i);
    return st;
}

static fmb_status prune_in_passes(pruner *p)
{
    bool feasible = false; /* if it is not, a rule lied when that was decided */
    fmb_status st = lock_equalities(p);
    if (st == FMB_OK)
        st = fmb_oracle_feasible(p->over_all, &feasible);
    if (st != FMB_OK || !feasible)
        return st;
    fmb_oracle_point(p->over_all, p->inner);
    note_slacks_at_point(p, p->inner);
    for (size_t i = 0; st == FMB_OK && !p->as_given && i < p->m; i++)
        if (p->fate[i] == FMB_FATE_UNKNOWN)
            st = find_equality_by_oracle(p, i);
    for (size_t i = p->m; st == FMB_OK && i-- > 0;)
        if (p->fate[i] == FMB_FATE_UNKNOWN)
            st = test_row_by_oracle(p, i);
    return st;
}

static fmb_status prune(pruner p)
{
    fmb_status st = open_pruner(&p);
    if (st == FMB_OK)
        st = prune_in_passes(&p);
    close_pruner(&p);
    return st;
}

fmb_status fmb_irredundant_by_oracle(fmb_run *run, size_t n, size_t m, const fmb_lp_row *row,
                                     fmb_fate *fate, const fmb_verdicts *told)
{
    return prune((pruner){.run = run, .n = n, .m = m, .row = row, .fate = fate, .told = told});
}

fmb_status fmb_redundant_by_oracle(fmb_run *run, size_t n, size_t m, const fmb_lp_row *row,
                                   fmb_fate *fate)
{
    return prune((pruner){.run = run, .n = n, .m = m, .row = row, .fate = fate, .as_given = true});
}

/* ---- when ------------------------------------------------------------------------------------ */

/* Beyond so many variables a pivot of a dictionary costs more than a linear program that is
 * guessed, unless all coefficients are -1, 0 or 1: then its numbers hardly grow, as in networks
 * they do not at all (transport polytopes of 288 variables: 34 ms, and 375 ms by the oracle). */
#define FEW_VARIABLES 8

static size_t count_nonzero_columns(size_t n, size_t m, const fmb_lp_row *row)
{
    size_t named = 0;
    for (size_t j = 0; j < n; j++) {
        bool any = false;
        for (size_t i = 0; !any && i < m; i++)
            any = fmb_vec_sgn(row[i].v, j) != 0;
        named += any;
    }
    return named;
}

bool fmb_suits_oracle(size_t n, size_t m, const fmb_lp_row *row)
{
    bool strict = false, short_numbers = true;
    for (size_t i = 0; i < m; i++) {
        const fmb_vec *v = row[i].v;
        strict = strict || row[i].rel == FMB_LT;
        short_numbers = short_numbers && !v->z;
        for (size_t j = 0; short_numbers && j < n; j++)
            short_numbers = v->s[j] >= -1 && v->s[j] <= 1;
    }
    bool suits = !strict && !short_numbers && count_nonzero_columns(n, m, row) > FEW_VARIABLES;
    suits = suits && fmb_way(FMB_WAY_REDUCE_ORACLE);
    fmb_way_answered(FMB_WAY_REDUCE_ORACLE, suits);
    return suits;
}
