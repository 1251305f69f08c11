/* exact_simplex.c: choosing pivots.
 *
 * Every loop here prefers large coefficients while steps make progress and turns to Bland's rule
 * (least index, both for the entering and the leaving variable) after a run of pivots without any,
 * until one moves again: so no loop cycles. Ratios are compared lexicographically in (K, D), that
 * is, for all small delta > 0 at once.
 */
#include "lp/dictionary/exact_simplex.h"

#include <stdlib.h>

/* Pivots without progress before Bland's rule takes over. */
#define PATIENCE 16

static bool uses_bland_rule(const fmb_lp *lp)
{
    return lp->stalled > PATIENCE;
}

/* Order of the steps (K + D delta) / |c| at which rows a and b stop column j. */
static int compare_step_lengths(const fmb_lp *lp, size_t a, size_t b, size_t j)
{
    const fmb_vec *u = &lp->row[a], *v = &lp->row[b];
    size_t k = fmb_lp_place(lp, FMB_LP_K), d = fmb_lp_place(lp, FMB_LP_D);
    int order = fmb_vec_compare_products(u, k, v, j, v, k, u, j);
    if (order == 0 && lp->any_strict)
        order = fmb_vec_compare_products(u, d, v, j, v, d, u, j);
    return order;
}

size_t fmb_lp_find_block(const fmb_lp *lp, size_t j, int sign)
{
    size_t best = SIZE_MAX;
    for (size_t r = 0; r < lp->m; r++) {
        if (!fmb_lp_counts(lp, r) || fmb_vec_sgn(&lp->row[r], j) * sign >= 0)
            continue;
        int order = best == SIZE_MAX ? -1 : compare_step_lengths(lp, r, best, j);
        if (order < 0 || (order == 0 && lp->basic[r] < lp->basic[best]))
            best = r;
    }
    return best;
}

/* Is |row[a]| > |row[b]|, for entries of one row? */
static bool is_larger_entry(const fmb_vec *v, size_t a, size_t b)
{
    return v->z ? mpz_cmpabs(v->z[a], v->z[b]) > 0 : llabs(v->s[a]) > llabs(v->s[b]);
}

size_t fmb_lp_find_entering(const fmb_lp *lp, size_t r, int sign)
{
    const fmb_vec *v = &lp->row[r];
    size_t best = SIZE_MAX;
    for (size_t j = 0; j < (size_t)lp->n; j++) {
        int s = fmb_vec_sgn(v, j);
        if (s == 0)
            continue;
        if (fmb_lp_is_free(lp, lp->column[j]))
            return j;
        if (s != sign || !fmb_lp_may_enter(lp, j))
            continue;
        if (best == SIZE_MAX ||
            (uses_bland_rule(lp) ? lp->column[j] < lp->column[best] : is_larger_entry(v, j, best)))
            best = j;
    }
    return best;
}

fmb_status fmb_lp_step(fmb_lp *lp, size_t r, size_t j)
{
    lp->stalled = fmb_lp_sign(lp, r) == 0 ? lp->stalled + 1 : 0;
    return fmb_lp_pivot(lp, r, j);
}

void fmb_lp_begin(fmb_lp *lp)
{
    lp->stalled = 0;
    lp->run->stats.lps++;
    fmb_run_emit(lp->run,
                 (fmb_event){.kind = FMB_EVENT_LP, .var = -1, .rows_in = lp->m, .rows_out = lp->m});
}

/* ---- phase one ------------------------------------------------------------------------------- */

/* A row that must be nonnegative and is not: the deepest, or under Bland's rule that of least
 * variable. */
static size_t find_negative_slack(const fmb_lp *lp, bool least_index)
{
    size_t best = SIZE_MAX;
    double best_depth = 0;
    for (size_t r = 0; r < lp->m; r++) {
        if (!fmb_lp_counts(lp, r) || fmb_lp_sign(lp, r) >= 0)
            continue;
        double d =
            least_index ? (double)lp->basic[r] : fmb_lp_ratio(lp, r, fmb_lp_place(lp, FMB_LP_K));
        if (best == SIZE_MAX || d < best_depth) {
            best = r;
            best_depth = d;
        }
    }
    return best;
}

/* An equality that depends on others and contradicts them. */
static size_t find_broken_equality(const fmb_lp *lp)
{
    for (size_t r = 0; r < lp->m; r++) {
        size_t v = lp->basic[r];
        if (!fmb_lp_is_x(lp, v) && lp->slack[v - (size_t)lp->n] == FMB_SLACK_LOCKED &&
            fmb_lp_sign(lp, r) != 0)
            return r;
    }
    return SIZE_MAX;
}

/* Dutertre and de Moura's check: bring a negative basic variable to 0 by any variable that can
 * raise it. It ends under Bland's rule, which takes over after as many pivots as the deepest-row
 * rule usually needs. */
fmb_status fmb_lp_make_feasible(fmb_lp *lp, bool *feasible)
{
    uint64_t patience = lp->run->stats.pivots + 2 * ((size_t)lp->n + lp->m);
    lp->stalled = 0;
    lp->at_row = find_broken_equality(lp);
    while (lp->at_row == SIZE_MAX) {
        bool least_index = lp->run->stats.pivots > patience;
        size_t r = find_negative_slack(lp, least_index);
        if (r == SIZE_MAX)
            break;
        lp->stalled = least_index ? PATIENCE + 1 : 0;
        size_t j = fmb_lp_find_entering(lp, r, 1);
        fmb_status st = j == SIZE_MAX ? FMB_OK : fmb_lp_pivot(lp, r, j);
        if (st != FMB_OK)
            return st;
        if (j == SIZE_MAX)
            lp->at_row = r;
    }
    lp->stalled = 0;
    *feasible = lp->at_row == SIZE_MAX;
    return FMB_OK;
}

fmb_status fmb_lp_feasible(fmb_lp *lp, bool *feasible)
{
    fmb_lp_begin(lp);
    return fmb_lp_make_feasible(lp, feasible);
}

/* ---- phase two ------------------------------------------------------------------------------- */

fmb_status fmb_lp_extreme(fmb_lp *lp, int x, int sign, fmb_lp_end *end)
{
    size_t r = lp->where[x];
    fmb_lp_begin(lp);
    lp->at_row = r;
    if (r >= lp->m) { /* no row names x */
        lp->at_column = r - lp->m;
        lp->at_sign = sign;
        *end = FMB_LP_UNBOUNDED;
        return FMB_OK;
    }
    for (;;) {
        size_t j = lp->at_column = fmb_lp_find_entering(lp, r, sign);
        if (j == SIZE_MAX) {
            *end = FMB_LP_OPTIMUM;
            return FMB_OK;
        }
        lp->at_sign = fmb_vec_sgn(&lp->row[r], j) * sign;
        size_t block = fmb_lp_find_block(lp, j, lp->at_sign);
        if (block == SIZE_MAX) {
            *end = FMB_LP_UNBOUNDED;
            return FMB_OK;
        }
        fmb_status st = fmb_lp_step(lp, block, j);
        if (st != FMB_OK)
            return st;
    }
}
