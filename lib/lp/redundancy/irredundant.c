/* irredundant.c: see irredundant.h.
 *
 * Two oracles: one of all rows that have not gone, and one of the equalities alone. A form has an
 * optimum over equalities if and only if it is a combination of them, and then its multipliers say
 * which.
 *
 * Theorem. Of rows with a solution z, the others imply a.x <= b if and only if a.x <= b holds where
 * they do and a.x <= b + e, for any e > 0. For if y satisfies the others and a.y > b, so do the
 * points between z and y, and among these are some with b < a.x <= b + e. (They satisfy strict rows
 * strictly, too, if z does, even where y is of the closure.) So a row is tested with its right side
 * larger, where a.x has an optimum; there the row is not tight, so it has no part in the proof.
 */
#include "lp/redundancy/irredundant.h"

#include <math.h>
#include <string.h>

#include "base/arrays.h"
#include "lp/oracle/oracle.h"
#include "lp/redundancy/active_set/leading_rows.h"
#include "num/integers.h"
#include "num/rationals.h"

struct fmb_pruner {
    fmb_run *run;
    size_t n, m;
    const fmb_lp_row *row;
    fmb_fate *fate;
    const fmb_verdicts *told;
    bool as_given; /* no inequality becomes an equality */
    bool pauses;   /* may stop where a slice of the run is over */
    size_t left;   /* rows not yet looked at: the first ones */
    bool any_strict;
    bool *feasible;
    fmb_program all, equal; /* every row, those gone being off; the equalities that stay */
    fmb_oracle *over_all, *over_equal;
    size_t *equality;   /* [m] rows of `equal` */
    size_t *term;       /* [m] scratch: 1 + which term of a conflict a row is, or 0 */
    bool *is_nonzero;   /* [n] columns that some equality names */
    fmb_integers point; /* [n], over den: what the oracle said last */
    mpz_t den, sum;
    mpq_t *inner, *x;    /* [n] a solution; scratch: a point that is told */
    fmb_weights form, w; /* scratch */
};

/* ---- life ------------------------------------------------------------------------------------ */

static void close_pruner(fmb_pruner *p)
{
    fmb_mem *mem = p->run->mem;
    fmb_oracle_free(p->over_all);
    fmb_oracle_free(p->over_equal);
    fmb_program_clear(&p->all);
    fmb_program_clear(&p->equal);
    fmb_weights_clear(&p->form, mem);
    fmb_weights_clear(&p->w, mem);
    FMB_ARRAYS_PUT(mem, FMB_ARRAY(p->equality, p->m), FMB_ARRAY(p->term, p->m),
                   FMB_ARRAY(p->is_nonzero, p->n));
    fmb_integers_clear(&p->point, mem);
    fmb_rationals_free(p->inner, p->n, mem);
    fmb_rationals_free(p->x, p->n, mem);
    mpz_clears(p->den, p->sum, NULL);
}

static fmb_status load_all_rows(fmb_pruner *p)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < p->m; i++) {
        st = fmb_program_add_dense(&p->all, p->row[i].v, p->row[i].rel);
        if (st == FMB_OK)
            p->all.row[i].off = p->fate[i] == FMB_FATE_REDUNDANT;
    }
    p->any_strict = p->all.any_strict;
    FMB_THEN(st, fmb_oracle_new(p->run, &p->all, &p->over_all));
    return st == FMB_OK ? fmb_oracle_new(p->run, &p->equal, &p->over_equal) : st;
}

static fmb_status open_pruner(fmb_pruner *p)
{
    fmb_mem *mem = p->run->mem;
    fmb_program_init(&p->all, mem, (int)p->n);
    fmb_program_init(&p->equal, mem, (int)p->n);
    mpz_inits(p->den, p->sum, NULL);
    FMB_TRY(FMB_ARRAYS(mem, true, FMB_ARRAY(p->equality, p->m), FMB_ARRAY(p->term, p->m),
                       FMB_ARRAY_ZERO(p->is_nonzero, p->n)));
    FMB_TRY(fmb_integers_init(&p->point, p->n, mem));
    FMB_TRY(fmb_rationals_new(&p->inner, p->n, mem));
    FMB_TRY(fmb_rationals_new(&p->x, p->n, mem));
    return load_all_rows(p);
}

/* ---- forms ----------------------------------------------------------------------------------- */

/* Sign of a_i.x - b_i where the oracle stands. */
static int sign_of_excess(fmb_pruner *p, size_t i)
{
    fmb_oracle_point_integers(p->over_all, p->point.z, p->den);
    fmb_vec_get(p->row[i].v, p->n, p->sum);
    mpz_mul(p->sum, p->sum, p->den);
    mpz_neg(p->sum, p->sum);
    fmb_program_add_product(&p->all, i, p->point.z, p->sum);
    return mpz_sgn(p->sum);
}

static fmb_status write_form(fmb_pruner *p, size_t i)
{
    const fmb_program_row *r = &p->all.row[i];
    fmb_status st = FMB_OK;
    mpq_t a;
    mpq_init(a);
    fmb_weights_clear(&p->form, p->run->mem);
    for (size_t k = 0; st == FMB_OK && k < r->size; k++) {
        fmb_vec_get_q(r->value, k, a);
        st = fmb_weights_add(&p->form, (uint32_t)r->column[k], a, p->run->mem);
    }
    mpq_clear(a);
    return st;
}

/* How large can a_i.x - b_i be, which is bounded? Where it is positive, the first point seen is
 * enough. */
static fmb_status push_row(fmb_pruner *p, size_t i, int *excess)
{
    fmb_oracle_end end;
    fmb_status st = write_form(p, i);
    FMB_THEN(st, fmb_oracle_approach(p->over_all, &p->form, &end));
    *excess = st == FMB_OK ? sign_of_excess(p, i) : 0;
    if (st != FMB_OK || *excess > 0)
        return st;
    st = fmb_oracle_climb(p->over_all, &end);
    *excess = st == FMB_OK ? sign_of_excess(p, i) : 0;
    return st;
}

/* Tell of row i, with the multipliers of the last optimum; place numbers its rows, NULL: as here.
 */
static fmb_status tell_with_weights(fmb_pruner *p, const fmb_oracle *o, size_t i,
                                    const size_t *place,
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

static void leave_out_row(fmb_pruner *p, size_t i)
{
    p->all.row[i].off = true;
    fmb_oracle_switch(p->over_all, i, false);
}

static void take_in_row(fmb_pruner *p, size_t i)
{
    p->all.row[i].off = false;
    fmb_oracle_switch(p->over_all, i, true);
}

static fmb_status drop_row_with_weights(fmb_pruner *p, const fmb_oracle *o, size_t i,
                                        const size_t *place)
{
    p->fate[i] = FMB_FATE_REDUNDANT;
    leave_out_row(p, i);
    return tell_with_weights(p, o, i, place, p->told ? p->told->redundant : NULL);
}

/* ---- equalities ------------------------------------------------------------------------------ */

/* Does an equality have a column that no other one has so far? Then it depends on none. */
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

/* Row i is an equality, and joins the others, unless it depends on them; *depends tells. */
static fmb_status lock_row(fmb_pruner *p, size_t i, bool *depends)
{
    const fmb_program_row *r = &p->all.row[i];
    fmb_oracle_end end = FMB_ORACLE_UNBOUNDED;
    fmb_status st = FMB_OK;
    bool attained;
    if (!names_new_column(p, i)) {
        st = write_form(p, i);
        FMB_THEN(st, fmb_oracle_maximize(p->over_equal, &p->form, &end, &attained));
    }
    *depends = end == FMB_ORACLE_OPTIMUM;
    if (st != FMB_OK || *depends)
        return st;
    p->equality[p->equal.m] = i;
    st = fmb_program_add(&p->equal, r->size, r->column, NULL, r->value, FMB_EQ);
    return st == FMB_OK ? fmb_oracle_grow(p->over_equal) : st;
}

/* The same, and it goes if it depends on them; else that becomes of it. */
static fmb_status lock_or_drop_row(fmb_pruner *p, size_t i, fmb_fate fate)
{
    bool depends;
    FMB_TRY(lock_row(p, i, &depends));
    if (depends)
        return drop_row_with_weights(p, p->over_equal, i, p->equality);
    p->fate[i] = fate;
    return FMB_OK;
}

static fmb_status lock_equalities(fmb_pruner *p)
{
    for (size_t i = 0; i < p->m; i++)
        if (p->row[i].rel == FMB_EQ && p->fate[i] != FMB_FATE_REDUNDANT)
            FMB_TRY(lock_or_drop_row(p, i, FMB_FATE_KEPT));
    return FMB_OK;
}

/* May row i always be tight, as far as is known? */
static bool is_row_open(const fmb_pruner *p, size_t i)
{
    return p->fate[i] == FMB_FATE_UNKNOWN && p->row[i].rel == FMB_LE;
}

/* Open rows are taken for strict ones, or not any more. */
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

/* A conflict, 0 = sum_k y_k a_k with the same of right sides, as the reverse of a row that it
 * names: -a_i = sum (y_k / y_i) a_k over the others. */
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
    leave_out_row(p, i);
    p->all.row[i].rel = FMB_EQ;
    take_in_row(p, i);
    FMB_TRY(lock_row(p, i, &depends));
    if (depends)
        return FMB_OK;
    p->fate[i] = FMB_FATE_EQUALITY;
    return tell_of_equality(p, y, at);
}

/* There is a solution, but none that satisfies open rows strictly: those of the conflict are
 * equalities, and some are there. They go, if they do, once all proofs that name them are told. The
 * first ones stay, in whatever order the conflict has them. */
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

/* Rows that some ray from inside hits stay. Nobody is told of a point that breaks such a row. */
static fmb_status keep_rows_that_are_seen(fmb_pruner *p, fmb_leading_rows *t)
{
    bool *hit;
    if (p->told && p->told->irredundant)
        return FMB_OK;
    FMB_TRY(FMB_GET(p->run->mem, hit, p->m));
    fmb_status st = fmb_leading_rows_shoot(t, hit);
    for (size_t i = 0, k = 0; st == FMB_OK && i < p->m; i++) {
        if (p->fate[i] == FMB_FATE_REDUNDANT)
            continue;
        p->fate[i] = hit[k++] ? FMB_FATE_KEPT : p->fate[i];
    }
    fmb_mem_put(p->run->mem, hit, p->m, sizeof *hit);
    return st;
}

/* Is some point strictly inside all rows? Then none is always tight. *room false: not known. */
static fmb_status look_from_inside(fmb_pruner *p, bool *room)
{
    fmb_leading_rows t;
    *room = false;
    if (p->equal.m > 0)
        return FMB_OK;
    fmb_status st = fmb_leading_rows_open(&t, p->run->mem, p->n, p->m);
    if (st == FMB_OK) {
        fmb_leading_rows_measure(&t, p->n, p->m, p->row);
        for (size_t i = 0; i < p->m; i++)
            if (p->fate[i] != FMB_FATE_REDUNDANT)
                fmb_leading_rows_add(&t, p->row[i].v, p->sum);
        st = fmb_leading_rows_find_inside(&t, p->run, INFINITY, room);
    }
    if (st == FMB_OK && *room)
        st = keep_rows_that_are_seen(p, &t);
    fmb_leading_rows_close(&t);
    return st;
}

/* All rows that are always tight. */
static fmb_status find_implicit_equalities(fmb_pruner *p)
{
    bool room = false;
    fmb_status st = FMB_OK;
    while (st == FMB_OK && !room && mark_open_rows(p, true) > 0) {
        st = fmb_oracle_feasible(p->over_all, &room);
        mark_open_rows(p, false);
        if (st == FMB_OK && !room)
            st = take_equalities_of_conflict(p);
    }
    return st;
}

/* ---- inequalities ---------------------------------------------------------------------------- */

/* Of so many bits are its coefficients. */
static size_t most_bits_of_coefficients(const fmb_pruner *p, size_t i)
{
    size_t most = 0;
    for (size_t j = 0; j < p->n; j++) {
        size_t bits = fmb_vec_entry_bits(p->row[i].v, j);
        most = bits > most ? bits : most;
    }
    return most;
}

/* A right side moves by a power of two, which is so many bits shorter than coefficients, or by 1:
 * doubles, in which the oracle guesses, take it for the same if it moves by much less. */
#define BITS_BELOW 20

/* The right side of row i becomes as it was, or larger. */
static fmb_status move_right_side(fmb_pruner *p, size_t i, bool larger)
{
    size_t bits = most_bits_of_coefficients(p, i);
    mpz_set_ui(p->sum, larger);
    mpz_mul_2exp(p->sum, p->sum, bits > BITS_BELOW ? bits - BITS_BELOW : 0);
    fmb_vec_get(p->row[i].v, p->n, p->den);
    mpz_add(p->sum, p->sum, p->den);
    fmb_status st = fmb_program_set_right(&p->all, i, p->sum);
    fmb_oracle_shift_row(p->over_all, i);
    return st;
}

/* out = a_i.x - b_i. */
static void measure_excess(const fmb_pruner *p, size_t i, mpq_t *x, mpq_t out)
{
    const fmb_program_row *r = &p->all.row[i];
    mpq_t t;
    mpq_init(t);
    fmb_vec_get_q(p->row[i].v, p->n, out);
    mpq_neg(out, out);
    for (size_t k = 0; k < r->size; k++) {
        fmb_vec_get_q(r->value, k, t);
        mpq_mul(t, t, x[r->column[k]]);
        mpq_add(out, out, t);
    }
    mpq_clear(t);
}

/* x is of the closure, and a_i.x - b_i = e > 0; at the inner point it is -s. A share of
 * (s + e/2) / (s + e) of the way from there to x it is e/2, and strict rows hold strictly. */
static void go_half_way_to_inner(fmb_pruner *p, size_t i)
{
    mpq_t e, s, share;
    mpq_inits(e, s, share, NULL);
    measure_excess(p, i, p->x, e);
    measure_excess(p, i, p->inner, s);
    mpq_sub(s, e, s);
    mpq_div_2exp(e, e, 1);
    mpq_sub(share, s, e);
    mpq_div(share, share, s);
    for (size_t j = 0; j < p->n; j++) {
        mpq_sub(p->x[j], p->x[j], p->inner[j]);
        mpq_mul(p->x[j], p->x[j], share);
        mpq_add(p->x[j], p->x[j], p->inner[j]);
    }
    mpq_clears(e, s, share, NULL);
}

/* The point where the oracle stands breaks row i; if `beyond`, even its closure. */
static fmb_status keep_tested_row(fmb_pruner *p, size_t i, bool beyond)
{
    p->fate[i] = FMB_FATE_KEPT;
    if (!p->told || !p->told->irredundant)
        return FMB_OK;
    FMB_TRY(fmb_oracle_point(p->over_all, p->x));
    if (beyond && p->all.any_strict)
        go_half_way_to_inner(p, i);
    return p->told->irredundant(p->told->self, i, p->x);
}

static fmb_status test_row(fmb_pruner *p, size_t i)
{
    int excess = 0;
    bool attained = false;
    FMB_TRY(move_right_side(p, i, true));
    FMB_TRY(push_row(p, i, &excess));
    if (excess == 0 && p->row[i].rel == FMB_LT)
        FMB_TRY(fmb_oracle_attain(p->over_all, &attained));
    if (excess < 0 || (excess == 0 && !attained))
        return drop_row_with_weights(p, p->over_all, i, NULL);
    FMB_TRY(keep_tested_row(p, i, excess > 0));
    return move_right_side(p, i, false);
}

/* From the last row to the first, at least one of them. */
static fmb_status test_undecided_rows(fmb_pruner *p)
{
    bool over = false;
    while (p->left > 0 && !over) {
        size_t i = --p->left;
        if (p->fate[i] != FMB_FATE_UNKNOWN)
            continue;
        FMB_TRY(test_row(p, i));
        over = p->pauses && fmb_run_is_slice_over(p->run);
    }
    return FMB_OK;
}

/* All passes but the last one. Without a solution no row is left to be looked at. */
static fmb_status prepare_pruner(fmb_pruner *p)
{
    bool room;
    FMB_TRY(open_pruner(p));
    FMB_TRY(fmb_oracle_feasible(p->over_all, p->feasible));
    if (!*p->feasible)
        return FMB_OK;
    FMB_TRY(fmb_oracle_point(p->over_all, p->inner));
    FMB_TRY(lock_equalities(p));
    p->left = p->m;
    FMB_TRY(look_from_inside(p, &room));
    return room || p->as_given ? FMB_OK : find_implicit_equalities(p);
}

fmb_status fmb_irredundant(fmb_run *run, size_t n, size_t m, const fmb_lp_row *row, fmb_fate *fate,
                           const fmb_verdicts *told, bool *feasible)
{
    fmb_pruner p = {
        .run = run, .n = n, .m = m, .row = row, .fate = fate, .told = told, .feasible = feasible};
    fmb_status st = prepare_pruner(&p);
    FMB_THEN(st, test_undecided_rows(&p));
    close_pruner(&p);
    return st;
}

static fmb_status begin_to_prune(const fmb_pruner *as, fmb_pruner **begun)
{
    FMB_TRY(FMB_GET_ZERO(as->run->mem, *begun, 1));
    **begun = *as;
    return prepare_pruner(*begun);
}

fmb_status fmb_redundant(fmb_run *run, size_t n, size_t m, const fmb_lp_row *row,
                         fmb_pruner **paused, fmb_fate *fate, bool *feasible)
{
    fmb_pruner as = {.run = run, .n = n, .m = m, .row = row, .fate = fate, .as_given = true};
    fmb_pruner *p = paused ? *paused : NULL;
    fmb_status st = FMB_OK;
    *feasible = true;
    as.pauses = paused != NULL;
    as.feasible = feasible;
    if (!p)
        st = begin_to_prune(&as, &p);
    FMB_THEN(st, test_undecided_rows(p));
    bool on = st == FMB_OK && p->left > 0;
    if (paused)
        *paused = on ? p : NULL;
    if (!on)
        fmb_pruner_close(p);
    return st;
}

void fmb_pruner_close(fmb_pruner *p)
{
    if (!p)
        return;
    fmb_mem *mem = p->run->mem;
    close_pruner(p);
    fmb_mem_put(mem, p, 1, sizeof *p);
}
