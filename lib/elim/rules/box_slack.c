/* box_slack.c: compares rows with the box; see box_rule.h.
 *
 * If the least value of a.x over the box is more than b, then the row and the rows of those ends
 * combine to a row 0 <= negative: one combination for each variable of the row. This is the
 * article's inconsistency test. Source: Baillehache 2020.
 */
#include "elim/rules/box_rule.h"

#include "num/gcd.h"

/* Like slack_sign_at, in GMP. */
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

/* Has the box an end for each variable of the row? */
static bool is_row_ended(const fmb_elim *e, const fmb_derived *r)
{
    return e->box.any && fmb_set_is_inside(r->names, e->box.ended, e->var_words);
}

/* Has the box all ends where a.x is greatest (at = 1) or least (at = -1)? */
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

/* Is the row itself one of an end or of the budget? */
static bool makes_end_or_budget(const fmb_elim *e, const fmb_derived *r)
{
    uint32_t number = (uint32_t)(r - e->row);
    int c = fmb_elim_single_variable(e, r);
    return number == e->box.budget ||
           (c >= 0 && e->box.row[fmb_vec_sgn(&r->v, (size_t)c) > 0][c] == number);
}

/* Is the row derived from rows of the box and the budget only? */
static bool is_made_of_box_rows(const fmb_elim *e, const fmb_derived *r)
{
    if (!e->box.hard || !r->history)
        return false;
    for (size_t k = 0; k < e->words; k++)
        if (r->history[k] & ~e->box.hard[k])
            return false;
    return true;
}

/* Over the box with a budget, a.x is greatest with all variables of the budget at their least ends
 * except the one with the greatest gain a_j / s_j, if any gains, which uses all the room. Sign of b
 * - that maximum, times unit and s_j. */
static int slack_sign_with_budget(const fmb_elim *e, const fmb_derived *r)
{
    const fmb_box_rows *box = &e->box;
    const int64_t *a = r->v.s, *s = e->row[box->budget].v.s;
    fmb_i128 sum = fmb_i128_product(a[e->n], box->unit);
    int64_t gain = 0, price = 1;
    int bits = r->v.bits + box->bits + fmb_bits64((uint64_t)e->n + 1);
    if (r->v.z || bits + e->row[box->budget].v.bits > 126)
        return -1;
    for (int j = fmb_elim_next_variable(e, r, 0); j >= 0; j = fmb_elim_next_variable(e, r, j + 1)) {
        int side = s[j] != 0 ? fmb_box_side_of_least(s[j]) : a[j] > 0 ? FMB_UPPER : FMB_LOWER;
        if (box->row[side][j] == FMB_NO_ROW)
            return -1;
        sum = fmb_i128_minus_product(sum, a[j], box->end[side][j]);
        int64_t g = s[j] < 0 ? -a[j] : a[j], p = (int64_t)fmb_abs64(s[j]);
        if (p > 0 && g > 0 &&
            fmb_i128_compare(fmb_i128_product(g, price), fmb_i128_product(gain, p)) > 0) {
            gain = g;
            price = p;
        }
    }
    sum = fmb_i128_times(sum, fmb_i128_of(price));
    return fmb_i128_sign(fmb_i128_minus_product(sum, gain, box->room));
}

int fmb_box_slack(const fmb_elim *e, const fmb_derived *r)
{
    if (!is_row_ended(e, r) || makes_end_or_budget(e, r))
        return -1;
    if (e->box.budget != FMB_NO_ROW)
        return is_made_of_box_rows(e, r) ? -1 : slack_sign_with_budget(e, r);
    return box_is_closed_at(e, r, 1) ? slack_sign_at(e, r, 1) : -1;
}

bool fmb_box_refutes(const fmb_elim *e, const fmb_derived *r)
{
    if (!is_row_ended(e, r) || !box_is_closed_at(e, r, -1))
        return false;
    int sign = slack_sign_at(e, r, -1);
    return sign < 0 || (sign == 0 && r->strict);
}

fmb_status fmb_box_refute(fmb_elim *e, uint32_t r)
{
    for (size_t c = 0; c < (size_t)e->n && e->clash == FMB_NO_ROW; c++) {
        int sign = fmb_vec_sgn(&e->row[r].v, c);
        if (sign == 0)
            continue;
        FMB_TRY(fmb_elim_derive_row(e, r, e->box.row[sign < 0][c], (int)c, &r));
    }
    return FMB_OK;
}
