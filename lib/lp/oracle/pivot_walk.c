/* pivot_walk.c: exact pivots; see pivot_walk.h. */
#include "lp/oracle/pivot_walk.h"

/* Steps after which Bland's rule, the least index, is used. */
#define PATIENCE(v) (50 + (v)->n / 4)

fmb_status fmb_pivot_walk_init(fmb_pivot_walk *w, fmb_vertex *v)
{
    *w = (fmb_pivot_walk){.v = v};
    mpz_inits(w->ray_den, w->ratio_num, w->ratio_den, w->num, w->den, NULL);
    FMB_TRY(fmb_integers_init(&w->cost, v->n, v->run->mem));
    return fmb_integers_init(&w->ray, v->n, v->run->mem);
}

void fmb_pivot_walk_clear(fmb_pivot_walk *w)
{
    fmb_integers_clear(&w->cost, w->v->run->mem);
    fmb_integers_clear(&w->ray, w->v->run->mem);
    mpz_clears(w->ray_den, w->ratio_num, w->ratio_den, w->num, w->den, NULL);
}

/* ---- to a feasible vertex -------------------------------------------------------------------- */

/* Price sign * a_row. */
static fmb_status price_row(fmb_pivot_walk *w, size_t row, int sign)
{
    const fmb_program *p = w->v->p;
    const fmb_program_row *r = &p->row[row];
    for (size_t j = 0; j < w->v->n; j++)
        mpz_set_ui(w->cost.z[j], 0);
    for (size_t k = 0; k < r->size; k++) {
        mpz_ptr at = w->cost.z[r->column[k]];
        fmb_program_get(p, row, k, at);
        if (sign < 0)
            mpz_neg(at, at);
    }
    return fmb_vertex_price(w->v, w->cost.z);
}

bool fmb_pivot_walk_is_price_allowed(const fmb_vertex *v, size_t r, int sign)
{
    int s = mpz_sgn(v->y.z[r]);
    return s == 0 || (fmb_vertex_is_loose(v, r)      ? false
                      : fmb_vertex_is_equality(v, r) ? true
                                                     : s == sign);
}

/* A place to leave, among those whose price is not allowed: first units and rows that are off, then
 * the largest price, or (least) the least row. SIZE_MAX: all are allowed. */
static size_t find_place_to_leave(const fmb_vertex *v, int sign, bool least)
{
    size_t best = SIZE_MAX;
    bool loose = false;
    for (size_t r = 0; r < v->n; r++) {
        if (fmb_pivot_walk_is_price_allowed(v, r, sign))
            continue;
        bool now = fmb_vertex_is_loose(v, r);
        bool better = best == SIZE_MAX ? true
                      : now != loose   ? now
                      : least          ? v->basis[r] < v->basis[best]
                                       : mpz_cmpabs(v->y.z[r], v->y.z[best]) > 0;
        if (better) {
            best = r;
            loose = now;
        }
    }
    return best;
}

/* Sign of sign * b_row - sum_r y_r b_r / unit, y being the prices of sign * a_row: the right side
 * of the combination. */
static int sign_of_remainder(fmb_pivot_walk *w, size_t row, int sign)
{
    const fmb_vertex *v = w->v;
    fmb_program_get(v->p, row, v->p->row[row].size, w->num);
    mpz_mul(w->num, w->num, v->unit);
    if (sign < 0)
        mpz_neg(w->num, w->num);
    for (size_t r = 0; r < v->n; r++) {
        if (fmb_vertex_is_unit(v, r) || mpz_sgn(v->y.z[r]) == 0)
            continue;
        fmb_program_get(v->p, v->basis[r], v->p->row[v->basis[r]].size, w->den);
        mpz_submul(w->num, w->den, v->y.z[r]);
    }
    return mpz_sgn(w->num);
}

/* Note a conflict whose prices are known. */
static void note_conflict(fmb_pivot_walk *w, size_t odd, int sign, fmb_pivot_walk_end *end)
{
    w->odd = odd;
    w->sign = sign;
    w->is_priced = true;
    *end = FMB_PIVOT_WALK_CONFLICT;
}

fmb_status fmb_pivot_walk_try_conflict(fmb_pivot_walk *w, size_t odd, fmb_pivot_walk_end *end)
{
    const fmb_program_row *row = &w->v->p->row[odd];
    *end = FMB_PIVOT_WALK_ITERATION_LIMIT;
    if (row->off || fmb_vertex_holds(w->v, odd))
        return FMB_OK;
    for (int sign = 1; sign >= (row->rel == FMB_EQ ? -1 : 1); sign -= 2) {
        FMB_TRY(price_row(w, odd, sign));
        if (find_place_to_leave(w->v, -1, true) != SIZE_MAX || sign_of_remainder(w, odd, sign) >= 0)
            continue;
        note_conflict(w, odd, sign, end);
        return FMB_OK;
    }
    return FMB_OK;
}

fmb_status fmb_pivot_walk_price_conflict(fmb_pivot_walk *w)
{
    fmb_status st = w->is_priced ? FMB_OK : price_row(w, w->odd, w->sign);
    w->is_priced = st == FMB_OK;
    return st;
}

/* Make row `row`, violated with this sign, hold by a pivot; otherwise there is a conflict. */
static fmb_status make_row_hold(fmb_pivot_walk *w, size_t row, int sign, bool least,
                                fmb_pivot_walk_end *end)
{
    FMB_TRY(price_row(w, row, sign));
    size_t r = find_place_to_leave(w->v, -1, least);
    if (r != SIZE_MAX)
        return fmb_vertex_replace(w->v, r, row);
    note_conflict(w, row, sign, end);
    return FMB_OK;
}

fmb_status fmb_pivot_walk_to_feasible(fmb_pivot_walk *w, size_t steps, fmb_pivot_walk_end *end)
{
    fmb_vertex *v = w->v;
    *end = FMB_PIVOT_WALK_REACHED;
    for (size_t k = 0; *end == FMB_PIVOT_WALK_REACHED; k++) {
        size_t row;
        int sign;
        bool least = k > PATIENCE(v);
        FMB_TRY(fmb_run_poll_now(v->run));
        FMB_TRY(fmb_vertex_solve(v));
        FMB_TRY(fmb_vertex_find_violated(v, least, &row, &sign));
        if (row == SIZE_MAX)
            return FMB_OK;
        if (steps > 0 && k >= steps)
            *end = FMB_PIVOT_WALK_ITERATION_LIMIT;
        else
            FMB_TRY(make_row_hold(w, row, sign, least, end));
    }
    return FMB_OK;
}

/* ---- to an optimum --------------------------------------------------------------------------- */

/* w->num = a_i.ray. */
static int slope_of_row(fmb_pivot_walk *w, size_t i)
{
    mpz_set_ui(w->num, 0);
    fmb_program_add_product(w->v->p, i, w->ray.z, w->num);
    return mpz_sgn(w->num);
}

/* Is the slack of row i over its slope, just computed, less than the least one so far? If so, it
 * becomes the least. */
static bool blocks_sooner(fmb_pivot_walk *w, size_t i, bool any)
{
    fmb_vertex *v = w->v;
    bool equality = v->p->row[i].rel == FMB_EQ;
    mpz_set_ui(w->den, 0);
    if (!equality && fmb_vertex_slack_sign(v, i) != 0)
        mpz_neg(w->den, v->sum); /* slack, times the denominator of x */
    mpz_abs(w->num, w->num);
    if (any) {
        mpz_mul(v->sum, w->den, w->ratio_den);
        mpz_submul(v->sum, w->ratio_num, w->num);
        if (mpz_sgn(v->sum) >= 0)
            return false;
    }
    mpz_swap(w->ratio_num, w->den);
    mpz_swap(w->ratio_den, w->num);
    return true;
}

/* The row that first stops the ray, of equal ones the least; SIZE_MAX if none does. Equalities
 * outside of the basis stop it at once. */
static fmb_status find_blocking_row(fmb_pivot_walk *w, size_t *block)
{
    const fmb_vertex *v = w->v;
    *block = SIZE_MAX;
    for (size_t i = 0; i < v->m; i++) {
        if (v->p->row[i].off || fmb_vertex_holds(v, i))
            continue;
        FMB_TRY(fmb_run_poll(v->run));
        int slope = slope_of_row(w, i);
        fmb_run_count(v->run, v->p->row[i].size * (20 + 2 * mpz_size(w->ray_den)) +
                                  fmb_limbs_work(3 * mpz_size(w->ray_den) / 2));
        FMB_TRY(fmb_run_poll_long(v->run, w->num));
        if (slope == 0 || (slope < 0 && v->p->row[i].rel != FMB_EQ))
            continue;
        if (blocks_sooner(w, i, *block != SIZE_MAX))
            *block = i;
    }
    return FMB_OK;
}

/* Leave place r in the direction in which cost.x increases, by the sign of its price. */
static fmb_status leave_place(fmb_pivot_walk *w, size_t r, size_t *block)
{
    fmb_vertex *v = w->v;
    FMB_TRY(fmb_vertex_leave(v, r, mpz_sgn(v->y.z[r]) < 0, &w->ray, w->ray_den));
    return find_blocking_row(w, block);
}

fmb_status fmb_pivot_walk_try_ray(fmb_pivot_walk *w, size_t r, mpz_t *cost, fmb_pivot_walk_end *end)
{
    size_t block;
    *end = FMB_PIVOT_WALK_ITERATION_LIMIT;
    FMB_TRY(fmb_vertex_price(w->v, cost));
    if (fmb_pivot_walk_is_price_allowed(w->v, r, 1) || fmb_vertex_is_equality(w->v, r))
        return FMB_OK;
    FMB_TRY(fmb_vertex_solve(w->v));
    FMB_TRY(leave_place(w, r, &block));
    if (block == SIZE_MAX)
        *end = FMB_PIVOT_WALK_RAY;
    return FMB_OK;
}

fmb_status fmb_pivot_walk_to_optimum(fmb_pivot_walk *w, size_t steps, mpz_t *cost,
                                     fmb_pivot_walk_end *end)
{
    fmb_vertex *v = w->v;
    size_t stalled = 0, block;
    *end = FMB_PIVOT_WALK_REACHED;
    for (size_t k = 0;; k++) {
        fmb_status st = fmb_run_poll_now(v->run);
        FMB_THEN(st, fmb_vertex_solve(v));
        FMB_THEN(st, fmb_vertex_price(v, cost));
        size_t r = st == FMB_OK ? find_place_to_leave(v, 1, stalled > PATIENCE(v)) : SIZE_MAX;
        if (r == SIZE_MAX)
            return st;
        if (steps > 0 && k >= steps) {
            *end = FMB_PIVOT_WALK_ITERATION_LIMIT;
            return FMB_OK;
        }
        st = leave_place(w, r, &block);
        if (st != FMB_OK)
            return st;
        if (block == SIZE_MAX) {
            *end = FMB_PIVOT_WALK_RAY;
            return FMB_OK;
        }
        stalled = mpz_sgn(w->ratio_num) == 0 ? stalled + 1 : 0;
        st = fmb_vertex_replace(v, r, block);
        v->feasible = st == FMB_OK;
        if (st != FMB_OK)
            return st;
    }
}
