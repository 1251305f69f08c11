/* simplex.c: choosing pivots.
 *
 * Every loop here prefers large coefficients while steps make progress and turns to Bland's rule
 * (least index, both for the entering and the leaving variable) after a run of pivots without any,
 * until one moves again: so no loop cycles. Ratios are compared lexicographically in (K, D), that
 * is, for all small delta > 0 at once.
 */
#include <stdlib.h>

#include "lp/lp.h"

/* Pivots without progress before Bland's rule takes over. */
#define PATIENCE 16

static bool by_least_index(const fmb_lp *lp)
{
    return lp->stalled > PATIENCE;
}

/* Order of the steps (K + D delta) / |c| at which rows a and b stop column j. */
static int compare_steps(const fmb_lp *lp, size_t a, size_t b, size_t j)
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
        int order = best == SIZE_MAX ? -1 : compare_steps(lp, r, best, j);
        if (order < 0 || (order == 0 && lp->basic[r] < lp->basic[best]))
            best = r;
    }
    return best;
}

/* Is |row[a]| > |row[b]|, for entries of one row? */
static bool is_larger(const fmb_vec *v, size_t a, size_t b)
{
    return v->z ? mpz_cmpabs(v->z[a], v->z[b]) > 0 : llabs(v->s[a]) > llabs(v->s[b]);
}

/* A column whose variable, by entering, moves the basic variable of row r in the direction sign;
 * SIZE_MAX if none does. A free variable may move either way. */
static size_t find_entering(const fmb_lp *lp, size_t r, int sign)
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
            (by_least_index(lp) ? lp->column[j] < lp->column[best] : is_larger(v, j, best)))
            best = j;
    }
    return best;
}

/* Pivot, and note whether the step had any length. */
static fmb_status step(fmb_lp *lp, size_t r, size_t j)
{
    lp->stalled = fmb_lp_sign(lp, r) == 0 ? lp->stalled + 1 : 0;
    return fmb_lp_pivot(lp, r, j);
}

/* Count a program, and tell the watcher. */
static void begin(fmb_lp *lp)
{
    lp->stalled = 0;
    lp->run->stats.lps++;
    fmb_run_emit(lp->run,
                 (fmb_event){.kind = FMB_EVENT_LP, .var = -1, .rows_in = lp->m, .rows_out = lp->m});
}

/* ---- phase one ------------------------------------------------------------------------------- */

double fmb_lp_ratio(const fmb_lp *lp, size_t r, size_t j)
{
    const fmb_vec *v = &lp->row[r];
    size_t own = fmb_lp_place(lp, FMB_LP_OWN);
    if (!v->z)
        return (double)v->s[j] / -(double)v->s[own];
    long ej, eo;
    double a = mpz_get_d_2exp(&ej, v->z[j]), b = mpz_get_d_2exp(&eo, v->z[own]);
    long shift = ej - eo > 1000 ? 1000 : ej - eo < -1000 ? -1000 : ej - eo;
    return __builtin_ldexp(a / -b, (int)shift);
}

/* A row that must be nonnegative and is not: the deepest, or under Bland's rule that of least
 * variable. */
static size_t find_negative(const fmb_lp *lp, bool least_index)
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
    size_t patience = lp->run->stats.pivots + 2 * ((size_t)lp->n + lp->m);
    lp->stalled = 0;
    lp->at_row = find_broken_equality(lp);
    while (lp->at_row == SIZE_MAX) {
        bool least_index = lp->run->stats.pivots > patience;
        size_t r = find_negative(lp, least_index);
        if (r == SIZE_MAX)
            break;
        lp->stalled = least_index ? PATIENCE + 1 : 0;
        size_t j = find_entering(lp, r, 1);
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
    begin(lp);
    return fmb_lp_make_feasible(lp, feasible);
}

/* ---- phase two ------------------------------------------------------------------------------- */

fmb_status fmb_lp_extreme(fmb_lp *lp, int x, int sign, fmb_lp_end *end)
{
    size_t r = lp->where[x];
    begin(lp);
    lp->at_row = r;
    if (r >= lp->m) { /* no row names x */
        lp->at_column = r - lp->m;
        lp->at_sign = sign;
        *end = FMB_LP_UNBOUNDED;
        return FMB_OK;
    }
    for (;;) {
        size_t j = lp->at_column = find_entering(lp, r, sign);
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
        fmb_status st = step(lp, block, j);
        if (st != FMB_OK)
            return st;
    }
}

/* Value of the tested slack s of row r after a step of column j to the block: is b - a.x then
 * negative (for a strict row: not positive)? Scaled by positive factors it is K_r |c_b| - |c_r|
 * K_b, and likewise in delta. */
static bool violates(const fmb_lp *lp, size_t r, size_t j, size_t block, bool strict)
{
    const fmb_vec *u = &lp->row[r], *v = &lp->row[block];
    size_t k = fmb_lp_place(lp, FMB_LP_K), d = fmb_lp_place(lp, FMB_LP_D);
    int order = fmb_vec_compare_products(u, k, v, j, v, k, u, j);
    if (order != 0 || !lp->any_strict)
        return order < 0;
    if (!strict)
        return fmb_vec_compare_products(u, d, v, j, v, d, u, j) < 0;
    mpz_t a, b, t; /* (D_r - e_r) |c_b| - D_b |c_r| <= 0: the delta inside s itself is taken out */
    mpz_inits(a, b, t, NULL);
    fmb_vec_get(u, d, a);
    fmb_vec_get(u, fmb_lp_place(lp, FMB_LP_OWN), t);
    mpz_sub(a, a, t);
    fmb_vec_get(v, j, t);
    mpz_abs(t, t);
    mpz_mul(a, a, t);
    fmb_vec_get(v, d, b);
    fmb_vec_get(u, j, t);
    mpz_abs(t, t);
    mpz_submul(a, b, t);
    bool not_positive = mpz_sgn(a) <= 0;
    mpz_clears(a, b, t, NULL);
    return not_positive;
}

/* The same when s itself is nonbasic, in column j, and goes down from 0 by the step of the block.
 */
static bool falls(const fmb_lp *lp, size_t j, size_t block, bool strict)
{
    const fmb_vec *v = &lp->row[block];
    size_t d = fmb_lp_place(lp, FMB_LP_D);
    if (fmb_vec_sgn(v, fmb_lp_place(lp, FMB_LP_K)) > 0)
        return true;
    if (!strict)
        return fmb_vec_sgn(v, d) > 0;
    return v->z ? mpz_sgn(v->z[d]) > 0 && mpz_cmpabs(v->z[d], v->z[j]) >= 0
                : v->s[d] > 0 && v->s[d] >= llabs(v->s[j]);
}

/* Is it broken already, at the current point? As above, the delta inside the slack of a strict row
 * is taken out. */
static bool is_broken(const fmb_lp *lp, size_t r, bool strict)
{
    const fmb_vec *v = &lp->row[r];
    size_t d = fmb_lp_place(lp, FMB_LP_D), own = fmb_lp_place(lp, FMB_LP_OWN);
    int k = fmb_vec_sgn(v, fmb_lp_place(lp, FMB_LP_K));
    if (k != 0 || !strict)
        return fmb_lp_sign(lp, r) < 0;
    return v->z ? mpz_cmp(v->z[d], v->z[own]) <= 0 : v->s[d] <= v->s[own];
}

fmb_status fmb_lp_test(fmb_lp *lp, size_t i, fmb_lp_end *end)
{
    size_t target = (size_t)lp->n + i;
    bool strict = lp->strict[i];
    lp->slack[i] = FMB_SLACK_TESTED;
    lp->tested = i;
    begin(lp);
    for (;;) {
        size_t r = lp->where[target];
        bool basic = r < lp->m;
        lp->at_row = r;
        lp->at_column = SIZE_MAX;
        if (basic && is_broken(lp, r, strict)) {
            *end = FMB_LP_VIOLATED;
            return FMB_OK;
        }
        size_t j = lp->at_column = basic ? find_entering(lp, r, -1) : r - lp->m;
        if (j == SIZE_MAX) {
            lp->slack[i] = FMB_SLACK_RELAXED;
            *end = FMB_LP_OPTIMUM;
            return FMB_OK;
        }
        lp->at_sign = basic ? 1 : -1;
        lp->block = fmb_lp_find_block(lp, j, lp->at_sign);
        if (lp->block == SIZE_MAX ||
            (basic ? violates(lp, r, j, lp->block, strict) : falls(lp, j, lp->block, strict))) {
            *end = FMB_LP_VIOLATED;
            return FMB_OK;
        }
        fmb_status st = step(lp, lp->block, j);
        if (st != FMB_OK)
            return st;
    }
}

fmb_status fmb_lp_restore(fmb_lp *lp)
{
    bool feasible;
    lp->slack[lp->tested] = FMB_SLACK_ACTIVE;
    return fmb_lp_make_feasible(lp, &feasible);
}

bool fmb_lp_is_slack(const fmb_lp *lp, size_t i)
{
    size_t r = lp->where[(size_t)lp->n + i];
    return r < lp->m && fmb_vec_sgn(&lp->row[r], fmb_lp_place(lp, FMB_LP_K)) > 0;
}

fmb_status fmb_lp_widen_slack(fmb_lp *lp, size_t i, fmb_lp_end *end)
{
    size_t target = (size_t)lp->n + i;
    begin(lp);
    for (;;) {
        size_t r = lp->where[target];
        bool basic = r < lp->m;
        size_t j = basic ? find_entering(lp, r, 1) : r - lp->m;
        lp->at_row = r;
        *end = j == SIZE_MAX && !fmb_lp_is_slack(lp, i) ? FMB_LP_OPTIMUM : FMB_LP_UNBOUNDED;
        if (j == SIZE_MAX || fmb_lp_is_slack(lp, i))
            return FMB_OK;
        size_t block = fmb_lp_find_block(lp, j, 1);
        if (block == SIZE_MAX)
            return FMB_OK;
        fmb_status st = step(lp, block, j);
        if (st != FMB_OK)
            return st;
    }
}

/* A column that may enter with a nonzero entry in row r. */
static size_t find_any(const fmb_lp *lp, size_t r)
{
    for (size_t j = 0; j < (size_t)lp->n; j++)
        if (fmb_vec_sgn(&lp->row[r], j) != 0 && fmb_lp_may_enter(lp, j))
            return j;
    return SIZE_MAX;
}

/* A basic slack that is 0 everywhere has K = D = 0, so exchanging it moves nothing. */
fmb_status fmb_lp_lock(fmb_lp *lp, size_t i, bool *depends)
{
    size_t r = lp->where[(size_t)lp->n + i];
    *depends = false;
    lp->slack[i] = FMB_SLACK_LOCKED;
    if (r >= lp->m)
        return FMB_OK;
    size_t j = find_any(lp, r);
    if (j != SIZE_MAX)
        return fmb_lp_pivot(lp, r, j);
    *depends = true;
    lp->slack[i] = FMB_SLACK_RELAXED;
    lp->at_row = r;
    return FMB_OK;
}
