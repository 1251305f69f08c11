/* product.c: sums of products of two vectors; see vec.h. */
#include "num/gcd.h"
#include "num/vec.h"

static bool is_sum_small(const fmb_vec *a, const fmb_vec *b, size_t n)
{
    return !a->z && !b->z && a->bits + b->bits + fmb_bits64(n) <= 126;
}

static fmb_i128 sum_of_small_products(const fmb_vec *a, const fmb_vec *b, size_t n)
{
    fmb_i128 sum = fmb_i128_of(0);
    if (a->bits + b->bits + fmb_bits64(n) < 64) {
        int64_t word = 0;
        for (size_t k = 0; k < n; k++)
            word += a->s[k] * b->s[k];
        return fmb_i128_of(word);
    }
    for (size_t k = 0; k < n; k++)
        sum = fmb_i128_plus_product(sum, a->s[k], b->s[k]);
    return sum;
}

int fmb_vec_product_sign(const fmb_vec *a, const fmb_vec *b, size_t n, fmb_num *k)
{
    if (is_sum_small(a, b, n))
        return fmb_i128_sign(sum_of_small_products(a, b, n));
    mpz_set_ui(k->t, 0);
    for (size_t j = 0; j < n; j++) {
        fmb_vec_get(a, j, k->p);
        fmb_vec_get(b, j, k->q);
        mpz_addmul(k->t, k->p, k->q);
    }
    return mpz_sgn(k->t);
}

fmb_status fmb_vec_set_product(fmb_vec *v, size_t n, size_t width, const fmb_vec *row, fmb_num *k)
{
    if (is_sum_small(v, row, n)) {
        fmb_i128 sum = sum_of_small_products(row, v, n);
        if (fmb_u128_bits(fmb_i128_size(sum)) <= FMB_SMALL_BITS) {
            v->s[n] = fmb_i128_low(sum);
            fmb_vec_measure(v, width);
            return FMB_OK;
        }
    }
    FMB_TRY(fmb_vec_widen(v, width, k->mem));
    mpz_set_ui(v->z[n], 0);
    for (size_t j = 0; j < n; j++) {
        fmb_vec_get(row, j, k->t);
        mpz_addmul(v->z[n], k->t, v->z[j]);
    }
    return fmb_vec_settle(v, width, k->mem);
}

void fmb_vec_negate(fmb_vec *v, size_t n)
{
    for (size_t j = 0; j < n; j++) {
        if (v->z)
            mpz_neg(v->z[j], v->z[j]);
        else
            v->s[j] = -v->s[j];
    }
}
