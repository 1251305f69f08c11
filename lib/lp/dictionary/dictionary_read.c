/* dictionary_read.c: answers and their proofs, read off a dictionary; see dictionary_read.h.
 *
 * Row r says d B = K + D delta + sum_j c_j N_j with d = -e > 0, an identity in x once B and the N_j
 * are written out as slacks s_i = b_i - a_i.x - delta [strict]; its coefficients are the
 * multipliers of every proof.
 */
#include "lp/dictionary/dictionary_read.h"

/* value = entry j of row r over d, times sign. */
static void entry_over_own(const fmb_lp *lp, size_t r, size_t j, int sign, mpq_t value)
{
    fmb_vec_get(&lp->row[r], j, mpq_numref(value));
    fmb_vec_get(&lp->row[r], fmb_lp_place(lp, FMB_LP_OWN), mpq_denref(value));
    if (sign > 0)
        mpz_neg(mpq_denref(value), mpq_denref(value));
    mpq_canonicalize(value);
}

/* Add sign * c_rj / d for every nonbasic slack. */
static fmb_status add_nonbasic_weights(const fmb_lp *lp, size_t r, int sign, fmb_weights *w)
{
    fmb_status st = FMB_OK;
    mpq_t q;
    mpq_init(q);
    for (size_t j = 0; st == FMB_OK && j < (size_t)lp->n; j++) {
        if (fmb_lp_is_x(lp, lp->column[j]) || fmb_vec_sgn(&lp->row[r], j) == 0)
            continue;
        entry_over_own(lp, r, j, sign, q);
        st = fmb_weights_add(w, (uint32_t)(lp->column[j] - (size_t)lp->n), q, lp->run->mem);
    }
    mpq_clear(q);
    return st;
}

/* B - sum (c/d) N = (K + D delta)/d < 0. Only among equalities can the right side be positive; then
 * all signs turn. */
fmb_status fmb_lp_conflict(const fmb_lp *lp, fmb_weights *w)
{
    int sign = fmb_lp_sign(lp, lp->at_row) < 0 ? -1 : 1;
    mpq_t one;
    mpq_init(one);
    mpq_set_si(one, -sign, 1);
    fmb_status st =
        fmb_weights_add(w, (uint32_t)(lp->basic[lp->at_row] - (size_t)lp->n), one, lp->run->mem);
    mpq_clear(one);
    return st == FMB_OK ? add_nonbasic_weights(lp, lp->at_row, sign, w) : st;
}

fmb_status fmb_lp_optimum(const fmb_lp *lp, int sign, fmb_weights *w)
{
    return add_nonbasic_weights(lp, lp->at_row, -sign, w);
}

void fmb_lp_value(const fmb_lp *lp, mpq_t value, int *step)
{
    entry_over_own(lp, lp->at_row, fmb_lp_place(lp, FMB_LP_K), 1, value);
    *step = fmb_vec_sgn(&lp->row[lp->at_row], fmb_lp_place(lp, FMB_LP_D));
}

/* ---- points ---------------------------------------------------------------------------------- */

/* A step t = tk + td delta of column j in direction sign; j = SIZE_MAX: none. */
typedef struct stride {
    size_t j;
    int sign;
    mpq_t tk, td;
    mpq_t k, d, c; /* scratch: value of a row after the step is k + d delta */
} stride;

static void init_stride(stride *w, size_t j, int sign)
{
    w->j = j;
    w->sign = sign;
    mpq_inits(w->tk, w->td, w->k, w->d, w->c, NULL);
}

static void clear_stride(stride *w)
{
    mpq_clears(w->tk, w->td, w->k, w->d, w->c, NULL);
}

/* w->k, w->d = the basic variable of row r after the step. */
static void value_after_stride(const fmb_lp *lp, size_t r, stride *w)
{
    entry_over_own(lp, r, fmb_lp_place(lp, FMB_LP_K), 1, w->k);
    entry_over_own(lp, r, fmb_lp_place(lp, FMB_LP_D), 1, w->d);
    if (w->j == SIZE_MAX || fmb_vec_sgn(&lp->row[r], w->j) == 0)
        return;
    mpq_t move;
    mpq_init(move);
    entry_over_own(lp, r, w->j, w->sign, w->c);
    mpq_mul(move, w->c, w->tk);
    mpq_add(w->k, w->k, move);
    mpq_mul(move, w->c, w->td);
    mpq_add(w->d, w->d, move);
    mpq_clear(move);
}

/* delta = min(delta, k / -d) if k + d delta >= 0 could fail; halve: < 0 must not become 0. */
static void cap_delta(mpq_t delta, mpq_srcptr k, mpq_srcptr d, bool halve)
{
    if (mpq_sgn(k) * mpq_sgn(d) >= 0)
        return;
    mpq_t limit;
    mpq_init(limit);
    mpq_div(limit, k, d);
    mpq_abs(limit, limit);
    if (halve)
        mpq_div_2exp(limit, limit, 1);
    if (mpq_cmp(limit, delta) < 0)
        mpq_set(delta, limit);
    mpq_clear(limit);
}

/* The largest delta <= 1 for which the step is forward, and every row that counts nonnegative after
 * it. */
static fmb_status choose_safe_delta(const fmb_lp *lp, stride *w, mpq_t delta)
{
    mpq_set_ui(delta, 1, 1);
    cap_delta(delta, w->tk, w->td, false);
    for (size_t r = 0; lp->any_strict && r < lp->m; r++) {
        if (!fmb_lp_counts(lp, r))
            continue;
        value_after_stride(lp, r, w);
        cap_delta(delta, w->k, w->d, false);
        fmb_status st = fmb_run_poll(lp->run);
        if (st != FMB_OK)
            return st;
    }
    return FMB_OK;
}

/* x after the step, at delta. */
static void read_x_after_stride(const fmb_lp *lp, stride *w, const mpq_t delta, mpq_t *x)
{
    for (size_t v = 0; v < (size_t)lp->n; v++) {
        mpq_set_ui(x[v], 0, 1);
        if (lp->where[v] >= lp->m)
            continue;
        value_after_stride(lp, lp->where[v], w);
        mpq_mul(w->d, w->d, delta);
        mpq_add(x[v], w->k, w->d);
    }
}

fmb_status fmb_lp_point(const fmb_lp *lp, bool closure, mpq_t *x)
{
    stride w;
    mpq_t delta;
    mpq_init(delta);
    init_stride(&w, SIZE_MAX, 0);
    fmb_status st = closure ? FMB_OK : choose_safe_delta(lp, &w, delta);
    if (st == FMB_OK)
        read_x_after_stride(lp, &w, delta, x);
    clear_stride(&w);
    mpq_clear(delta);
    return st;
}

/* The length of the step to a violation: to the block, or else far enough to make the tested slack
 * -1. */
static void choose_stride_length(const fmb_lp *lp, stride *w)
{
    size_t r = lp->block;
    if (w->j == SIZE_MAX) /* it is violated where we are */
        return;
    if (r != SIZE_MAX) {
        mpq_set_ui(w->c, 1, 1);
        fmb_vec_get(&lp->row[r], w->j, mpq_numref(w->c));
        mpq_abs(w->c, w->c);
        fmb_vec_get(&lp->row[r], fmb_lp_place(lp, FMB_LP_K), mpq_numref(w->tk));
        fmb_vec_get(&lp->row[r], fmb_lp_place(lp, FMB_LP_D), mpq_numref(w->td));
        mpq_div(w->tk, w->tk, w->c);
        mpq_div(w->td, w->td, w->c);
        return;
    }
    mpq_set_ui(w->tk, 1, 1);
    r = lp->where[(size_t)lp->n + lp->tested];
    if (r >= lp->m)
        return;
    entry_over_own(lp, r, fmb_lp_place(lp, FMB_LP_K), 1, w->k);
    mpq_add(w->tk, w->k, w->tk);
    entry_over_own(lp, r, w->j, 1, w->c);
    mpq_abs(w->c, w->c);
    mpq_div(w->tk, w->tk, w->c);
}

/* The tested slack after the step, with the delta inside it taken out: k + d delta = b - a.x. */
static void read_tested_slack(const fmb_lp *lp, stride *w)
{
    size_t r = lp->where[(size_t)lp->n + lp->tested];
    if (r < lp->m) {
        value_after_stride(lp, r, w);
    } else { /* it is the one that moves, down from 0 */
        mpq_neg(w->k, w->tk);
        mpq_neg(w->d, w->td);
    }
    if (lp->strict[lp->tested]) {
        mpq_set_ui(w->c, 1, 1);
        mpq_add(w->d, w->d, w->c);
    }
}

fmb_status fmb_lp_violation(const fmb_lp *lp, mpq_t *x)
{
    stride w;
    mpq_t delta;
    mpq_init(delta);
    init_stride(&w, lp->at_column, lp->at_sign);
    choose_stride_length(lp, &w);
    fmb_status st = choose_safe_delta(lp, &w, delta);
    if (st == FMB_OK) {
        read_tested_slack(lp, &w);
        cap_delta(delta, w.k, w.d, true);
        read_x_after_stride(lp, &w, delta, x);
    }
    clear_stride(&w);
    mpq_clear(delta);
    return st;
}

void fmb_lp_ray(const fmb_lp *lp, mpq_t *x)
{
    for (size_t v = 0; v < (size_t)lp->n; v++) {
        if (lp->where[v] < lp->m)
            entry_over_own(lp, lp->where[v], lp->at_column, lp->at_sign, x[v]);
        else
            mpq_set_si(x[v], lp->where[v] - lp->m == lp->at_column ? lp->at_sign : 0, 1);
    }
}
