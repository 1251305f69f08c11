/* box_slack.c: rows over the box; see box_rule.h.
 *
 * If the least value of a.x over the box is more than b, then the row and the rows that make those
 * ends combine to a row 0 <= negative: one combination for each variable of the row. This is the
 * article's inconsistency test. Source: Baillehache 2020.
 */
#include "elim/rules/box_rule.h"

#include "num/gcd.h"

/* The same as below in GMP. */
static int slack_sign_in_gmp(const fmb_elim *e, const fmb_derived *r, int at)
{
    const fmb_box_rows *box = &e->box;
    mpz_t sum, t;
    mpz_inits(sum, t, NULL);
    fmb_vec_get(&r->v, (size_t)e->n, t);
    fmb_integer_times_i64(sum, t, box->unit);
    for (size_t j = 0; j < (size_t)e->n; j++) {
        int sign = fmb_vec_sgn(&r->v, j);
        if (sign == 0)
            continue;
        fmb_vec_get(&r->v, j, t);
        fmb_integer_times_i64(t, t, box->end[sign * at > 0][j]);
        mpz_sub(sum, sum, t);
    }
    int sign = mpz_sgn(sum);
    mpz_clears(sum, t, NULL);
    return sign;
}

static int slack_sign_in_int128(const fmb_elim *e, const fmb_derived *r, int at)
{
    const fmb_box_rows *box = &e->box;
    const int64_t *a = r->v.s;
    fmb_i128 sum = fmb_i128_product(a[e->n], box->unit);
    for (int j = fmb_elim_next_variable(e, r, 0); j >= 0; j = fmb_elim_next_variable(e, r, j + 1))
        sum = fmb_i128_minus_product(sum, a[j], box->end[(a[j] > 0) == (at > 0)][j]);
    return fmb_i128_sign(sum);
}

/* Has the box an end wherever a.x is greatest (at = 1) or least (at = -1)? */
static bool box_is_closed_at(const fmb_elim *e, const fmb_derived *r, int at)
{
    for (int j = fmb_elim_next_variable(e, r, 0); j >= 0; j = fmb_elim_next_variable(e, r, j + 1))
        if (e->box.row[fmb_vec_sgn(&r->v, (size_t)j) * at > 0][j] == FMB_NO_ROW)
            return false;
    return true;
}

/* The sign of b - a.x where a.x is greatest or least. A sum of n + 1 products in 128 bits. */
static int slack_sign_at(const fmb_elim *e, const fmb_derived *r, int at)
{
    int bits = r->v.bits + e->box.bits + fmb_bits64((uint64_t)e->n + 1);
    return r->v.z || bits > 126 ? slack_sign_in_gmp(e, r, at) : slack_sign_in_int128(e, r, at);
}

/* Does the row itself make an end? */
static bool makes_end(const fmb_elim *e, const fmb_derived *r)
{
    int c = fmb_elim_single_variable(e, r);
    return c >= 0 && e->box.row[fmb_vec_sgn(&r->v, (size_t)c) > 0][c] == (uint32_t)(r - e->row);
}

int fmb_box_slack(const fmb_elim *e, const fmb_derived *r)
{
    bool open = !e->box.any || makes_end(e, r) || !box_is_closed_at(e, r, 1);
    return open ? -1 : slack_sign_at(e, r, 1);
}

bool fmb_box_refutes(const fmb_elim *e, const fmb_derived *r)
{
    if (!e->box.any || !box_is_closed_at(e, r, -1))
        return false;
    int sign = slack_sign_at(e, r, -1);
    return sign < 0 || (sign == 0 && r->strict);
}

fmb_status fmb_box_refute(fmb_elim *e, uint32_t r)
{
    fmb_status st = FMB_OK;
    for (size_t c = 0; st == FMB_OK && c < (size_t)e->n && e->clash == FMB_NO_ROW; c++) {
        int sign = fmb_vec_sgn(&e->row[r].v, c);
        if (sign == 0)
            continue;
        st = fmb_elim_derive_row(e, r, e->box.row[sign < 0][c], (int)c, &r);
    }
    return st;
}
