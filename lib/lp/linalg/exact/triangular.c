/* triangular.c: see triangular.h.
 *
 * With D the product of the diagonal entries in the rows that are reached, D x is integral: by
 * Cramer's rule, as the rows reached are triangular among themselves. So each unknown, times D, is
 * an integer that one exact division gives.
 */
#include "lp/linalg/exact/triangular.h"

#include "num/gcd.h"
#include "num/integers.h"

/* Longer solutions are left to lifting, which stops early if the solution is short. */
#define MOST_BITS 4096

static size_t turn_at(const fmb_triangular *t, size_t s)
{
    return (size_t)t->turn[t->backwards ? t->b->n - 1 - s : s];
}

/* den = D. False: it is too long. */
static bool reach_unknowns(const fmb_triangular *t, mpz_t *right, const int *right_at, mpz_t den)
{
    const fmb_sparse *b = t->b;
    mpz_set_ui(den, 1);
    for (size_t s = 0; s < b->n; s++) {
        size_t k = turn_at(t, s);
        uint64_t diagonal = 1;
        t->reached[k] = mpz_sgn(right[right_at[k]]) != 0;
        for (size_t e = b->start[k]; e < b->start[k + 1]; e++) {
            if ((size_t)b->index[e] == k)
                diagonal = fmb_abs64(b->value[e]);
            else
                t->reached[k] = t->reached[k] || t->reached[b->index[e]];
        }
        if (!t->reached[k] || diagonal == 1)
            continue;
        fmb_integer_times_u64(den, den, diagonal);
        if (mpz_sizeinbase(den, 2) > MOST_BITS)
            return false;
    }
    return true;
}

/* x = D times unknown k. */
static void solve_for_unknown(const fmb_triangular *t, size_t k, const mpz_t right, const int *at,
                              mpz_t *x, const mpz_t den)
{
    const fmb_sparse *b = t->b;
    mpz_ptr to = x[at[k]];
    int64_t diagonal = 1;
    mpz_mul(to, right, den);
    for (size_t e = b->start[k]; e < b->start[k + 1]; e++) {
        size_t j = (size_t)b->index[e];
        if (j == k)
            diagonal = b->value[e];
        else if (t->reached[j])
            fmb_integer_add_product_i64(to, x[at[j]], -b->value[e]);
    }
    if (fmb_abs64(diagonal) != 1)
        fmb_integer_divide_exactly_u64(to, to, fmb_abs64(diagonal));
    if (diagonal < 0)
        mpz_neg(to, to);
}

bool fmb_triangular_solve(const fmb_triangular *t, mpz_t *right, const int *right_at, const int *at,
                          mpz_t *x, mpz_t den)
{
    size_t n = t->b->n;
    if (t->b->big || !reach_unknowns(t, right, right_at, den))
        return false;
    for (size_t s = 0; s < n; s++) {
        size_t k = turn_at(t, s);
        if (t->reached[k])
            solve_for_unknown(t, k, right[right_at[k]], at, x, den);
        else
            mpz_set_ui(x[at[k]], 0);
    }
    return fmb_integers_cancel(x, n, den, NULL) == FMB_OK; /* den is short */
}
