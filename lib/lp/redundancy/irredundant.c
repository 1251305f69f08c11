/* irredundant.c: see irredundant.h.
 *
 * Theorem. Of rows with a solution z, the others imply a.x <= b if and only if a.x <= b holds where
 * they do and a.x <= b + e, for any e > 0. For if y satisfies the others and a.y > b, so do the
 * points between z and y, and among these are some with b < a.x <= b + e. (They satisfy strict rows
 * strictly, too, if z does, even where y is of the closure.) So a row is tested with its right side
 * larger, where a.x has an optimum; there the row is not tight, so it has no part in the proof.
 */
#include "lp/redundancy/irredundant.h"

#include "lp/redundancy/implicit_equalities.h"

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

/* How large can a_i.x - b_i be, which is bounded? Where it is positive, the first point seen is
 * enough. */
static fmb_status push_row(fmb_pruner *p, size_t i, int *excess)
{
    fmb_oracle_end end;
    fmb_status st = fmb_pruner_write_form(p, i);
    FMB_THEN(st, fmb_oracle_approach(p->over_all, &p->form, &end));
    *excess = st == FMB_OK ? sign_of_excess(p, i) : 0;
    if (st != FMB_OK || *excess > 0)
        return st;
    st = fmb_oracle_climb(p->over_all, &end);
    *excess = st == FMB_OK ? sign_of_excess(p, i) : 0;
    return st;
}

/* A right side moves by a power of two, which is so many bits shorter than coefficients, or by 1:
 * doubles, in which the oracle guesses, take it for the same if it moves by much less. */
#define BITS_BELOW 20

/* The right side of row i becomes as it was, or larger. */
static fmb_status move_right_side(fmb_pruner *p, size_t i, bool larger)
{
    size_t bits = fmb_vec_most_bits(p->row[i].v, p->n);
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
        return fmb_pruner_drop(p, p->over_all, i, NULL);
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
    FMB_TRY(fmb_pruner_open(p));
    FMB_TRY(fmb_oracle_feasible(p->over_all, p->feasible));
    if (!*p->feasible)
        return FMB_OK;
    FMB_TRY(fmb_oracle_point(p->over_all, p->inner));
    FMB_TRY(fmb_lock_equalities(p));
    p->left = p->m;
    return p->as_given ? FMB_OK : fmb_find_implicit_equalities(p);
}

fmb_status fmb_irredundant(fmb_run *run, size_t n, size_t m, const fmb_lp_row *row, fmb_fate *fate,
                           const fmb_verdicts *told, bool *feasible)
{
    fmb_pruner p = {
        .run = run, .n = n, .m = m, .row = row, .fate = fate, .told = told, .feasible = feasible};
    fmb_status st = prepare_pruner(&p);
    FMB_THEN(st, test_undecided_rows(&p));
    fmb_pruner_clear(&p);
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
    fmb_pruner_clear(p);
    fmb_mem_put(mem, p, 1, sizeof *p);
}
