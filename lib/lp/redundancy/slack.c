/* slack.c: how far the slack of a row goes; see slack.h. Steps are those of simplex.c. */
#include "lp/redundancy/slack.h"

#include <stdlib.h>

/* Value of the tested slack s of row r after a step of column j to the block: is b - a.x then
 * negative (for a strict row: not positive)? Scaled by positive factors it is K_r |c_b| - |c_r|
 * K_b, and likewise in delta. */
static bool does_step_violate(const fmb_lp *lp, size_t r, size_t j, size_t block, bool strict)
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
static bool does_fall_violate(const fmb_lp *lp, size_t j, size_t block, bool strict)
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
static bool is_row_broken(const fmb_lp *lp, size_t r, bool strict)
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
    fmb_lp_begin(lp);
    for (;;) {
        size_t r = lp->where[target];
        bool basic = r < lp->m;
        lp->at_row = r;
        lp->at_column = SIZE_MAX;
        if (basic && is_row_broken(lp, r, strict)) {
            *end = FMB_LP_VIOLATED;
            return FMB_OK;
        }
        size_t j = lp->at_column = basic ? fmb_lp_find_entering(lp, r, -1) : r - lp->m;
        if (j == SIZE_MAX) {
            lp->slack[i] = FMB_SLACK_RELAXED;
            *end = FMB_LP_OPTIMUM;
            return FMB_OK;
        }
        lp->at_sign = basic ? 1 : -1;
        lp->block = fmb_lp_find_block(lp, j, lp->at_sign);
        if (lp->block == SIZE_MAX || (basic ? does_step_violate(lp, r, j, lp->block, strict)
                                            : does_fall_violate(lp, j, lp->block, strict))) {
            *end = FMB_LP_VIOLATED;
            return FMB_OK;
        }
        fmb_status st = fmb_lp_step(lp, lp->block, j);
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
    fmb_lp_begin(lp);
    for (;;) {
        size_t r = lp->where[target];
        bool basic = r < lp->m;
        size_t j = basic ? fmb_lp_find_entering(lp, r, 1) : r - lp->m;
        lp->at_row = r;
        *end = j == SIZE_MAX && !fmb_lp_is_slack(lp, i) ? FMB_LP_OPTIMUM : FMB_LP_UNBOUNDED;
        if (j == SIZE_MAX || fmb_lp_is_slack(lp, i))
            return FMB_OK;
        size_t block = fmb_lp_find_block(lp, j, 1);
        if (block == SIZE_MAX)
            return FMB_OK;
        fmb_status st = fmb_lp_step(lp, block, j);
        if (st != FMB_OK)
            return st;
    }
}

/* A column that may enter with a nonzero entry in row r. */
static size_t find_any_entering(const fmb_lp *lp, size_t r)
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
    size_t j = find_any_entering(lp, r);
    if (j != SIZE_MAX)
        return fmb_lp_pivot(lp, r, j);
    *depends = true;
    lp->slack[i] = FMB_SLACK_RELAXED;
    lp->at_row = r;
    return FMB_OK;
}
