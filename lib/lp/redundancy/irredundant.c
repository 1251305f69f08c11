/* irredundant.c: see irredundant.h.
 *
 * Theorem. Let z satisfy all rows, and e > 0. The other rows imply a.x <= b if and only if they and
 * a.x <= b + e do. Proof: let y satisfy the other rows and a.y > b. The points between z and y
 * satisfy them, too, and some of these points have b < a.x <= b + e. (Strict rows hold strictly
 * there, even if y is only in the closure.) So a row is tested with a larger right side, where a.x
 * has an optimum. If that is at most b, the row is not tight there, and has no multiplier.
 */
#include "lp/redundancy/irredundant.h"

#include "lp/redundancy/implicit_equalities.h"

/* Sign of a_i.x - b_i at the oracle's point x. */
static int sign_of_excess(fmb_pruner *p, size_t i)
{
    fmb_oracle_point_integers(p->over_all, p->point.z, p->den);
    fmb_vec_get(p->row[i].v, p->n, p->sum);
    mpz_mul(p->sum, p->sum, p->den);
    mpz_neg(p->sum, p->sum);
    fmb_program_add_product(&p->all, i, p->point.z, p->sum);
    return mpz_sgn(p->sum);
}

/* *excess = the sign of the maximum of a_i.x - b_i, which is bounded. A first point at which it is
 * positive is enough. */
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

/* A right side grows by 1, or by a power of two that is so many bits shorter than the coefficients:
 * a much smaller change would be lost in the doubles of the oracle's guesses. */
#define BITS_BELOW 20

/* Make the right side of row i larger, or b_i again. */
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

/* x is in the closure with a_i.x - b_i = e > 0, and at the inner point that difference is -s. Move
 * x to inner + share (x - inner), share = (s + e/2) / (s + e): there it is e/2, and strict rows
 * hold. */
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

/* The oracle's point violates row i; if `beyond`, the closure of row i as well. */
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

/* From the last undecided row to the first; at least one row is tested in each slice. */
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

/* All passes but the last. Without a solution, p->left stays 0: there is nothing to test. */
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
