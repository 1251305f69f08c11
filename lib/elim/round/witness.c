/* witness.c: back-substitution.
 *
 * If values of the remaining variables satisfy the combined rows, the largest lower bound of the
 * eliminated variable is at most its least upper bound (less if one of the two rows is strict). So,
 * last round first, each variable gets a value between them. Rows dropped by a rule are implied by
 * kept rows, for all three kinds of points alike. Source: Schrijver 1986, section 12.2.
 */
#include "elim/round/witness.h"

#include "num/gcd.h"

typedef struct range {
    mpq_t lower, upper, value, t;
    bool has_lower, has_upper, lower_open, upper_open;
} range;

/* value = (b - sum of the other terms) / a_var for row r: the bound that it puts on var. */
static fmb_status bound_by_row(const fmb_elim *e, const fmb_derived *r, int var,
                               fmb_point_kind kind, mpq_t *x, range *g)
{
    const fmb_poll poll = fmb_run_asked(e->run);
    fmb_status st = FMB_OK;
    mpq_set_ui(g->value, 0, 1);
    if (kind != FMB_POINT_RAY)
        fmb_vec_get(&r->v, (size_t)e->n, mpq_numref(g->value));
    for (int j = 0; st == FMB_OK && j < e->n; j++) {
        if (j == var || fmb_vec_sgn(&r->v, (size_t)j) == 0 || mpq_sgn(x[j]) == 0)
            continue;
        mpq_set_ui(g->t, 1, 1);
        fmb_vec_get(&r->v, (size_t)j, mpq_numref(g->t));
        mpq_mul(g->t, g->t, x[j]);
        mpq_sub(g->value, g->value, g->t);
        if (fmb_vec_is_wide(&r->v))
            st = fmb_run_poll_now(e->run);
    }
    fmb_vec_get(&r->v, (size_t)var, mpq_numref(g->t));
    return st == FMB_OK ? fmb_long_divide(g->value, mpq_numref(g->t), &poll) : st;
}

/* Narrow the range by value; of equal bounds the open one is kept. */
static void narrow_range(range *g, bool is_lower, bool open)
{
    mpq_ptr end = is_lower ? g->lower : g->upper;
    bool *has = is_lower ? &g->has_lower : &g->has_upper;
    bool *end_open = is_lower ? &g->lower_open : &g->upper_open;
    int order = *has ? mpq_cmp(g->value, end) : is_lower ? 1 : -1;
    if (is_lower ? order > 0 : order < 0) {
        mpq_set(end, g->value);
        *end_open = open;
        *has = true;
    } else if (order == 0) {
        *end_open = *end_open || open;
    }
}

static bool is_between(mpq_srcptr x, mpq_srcptr lower, bool lower_open, mpq_srcptr upper,
                       bool upper_open)
{
    int low = lower ? mpq_cmp(x, lower) : 1, high = upper ? mpq_cmp(x, upper) : -1;
    return (low > 0 || (low == 0 && !lower_open)) && (high < 0 || (high == 0 && !upper_open));
}

void fmb_simple_between(mpq_t x, mpq_srcptr lower, bool lower_open, mpq_srcptr upper,
                        bool upper_open)
{
    mpq_set_ui(x, 0, 1);
    if (is_between(x, lower, lower_open, upper, upper_open))
        return;
    bool positive = lower && mpq_sgn(lower) >= 0;
    mpq_srcptr near = positive ? lower : upper; /* the end next to 0; the range lies beyond it */
    bool near_open = positive ? lower_open : upper_open;
    mpz_ptr num = mpq_numref(x);
    if (positive)
        mpz_fdiv_q(num, mpq_numref(near), mpq_denref(near));
    else
        mpz_cdiv_q(num, mpq_numref(near), mpq_denref(near));
    if (near_open || mpq_cmp(x, near) != 0)
        (positive ? mpz_add_ui : mpz_sub_ui)(num, num, 1);
    if (is_between(x, lower, lower_open, upper, upper_open))
        return;
    if (!near_open) {
        mpq_set(x, near);
        return;
    }
    mpq_add(x, lower, upper); /* no integer fits, so both ends exist */
    mpq_div_2exp(x, x, 1);
}

static fmb_status choose_value_of_round(const fmb_elim *e, const fmb_round *round,
                                        fmb_point_kind kind, mpq_t *x, range *g)
{
    g->has_lower = g->has_upper = g->lower_open = g->upper_open = false;
    for (size_t i = 0; i < round->rows; i++) {
        const fmb_derived *r = &e->row[round->row[i]];
        FMB_TRY(bound_by_row(e, r, round->var, kind, x, g));
        if (round->equality) {
            mpq_set(x[round->var], g->value);
            return FMB_OK;
        }
        narrow_range(g, fmb_vec_sgn(&r->v, (size_t)round->var) < 0,
                     r->strict && kind == FMB_POINT_INSIDE);
    }
    fmb_simple_between(x[round->var], g->has_lower ? g->lower : NULL, g->lower_open,
                       g->has_upper ? g->upper : NULL, g->upper_open);
    return FMB_OK;
}

fmb_status fmb_elim_point(const fmb_elim *e, fmb_point_kind kind, mpq_t *x)
{
    range g;
    fmb_status st = FMB_OK;
    mpq_inits(g.lower, g.upper, g.value, g.t, NULL);
    for (int i = e->rounds; st == FMB_OK && i-- > 0;) {
        st = choose_value_of_round(e, &e->round[i], kind, x, &g);
        FMB_THEN(st, fmb_run_poll(e->run));
    }
    mpq_clears(g.lower, g.upper, g.value, g.t, NULL);
    return st;
}
