/* bareiss.c: see bareiss.h. */
#include "bareiss.h"

#include <criterion/criterion.h>
#include <stdlib.h>

mpz_t *bareiss_numbers(size_t n)
{
    mpz_t *z = malloc(n * sizeof *z);
    for (size_t i = 0; i < n; i++)
        mpz_init(z[i]);
    return z;
}

void bareiss_free(mpz_t *z, size_t n)
{
    for (size_t i = 0; i < n; i++)
        mpz_clear(z[i]);
    free(z);
}

/* Rank of a[n][width], whose first n columns count; a becomes triangular, and where the rank is n,
 * a[n-1][n-1] is the determinant but for its sign. */
static size_t eliminate_plainly(mpz_t *a, size_t n, size_t width)
{
    mpz_t last, t;
    mpz_init_set_ui(last, 1);
    mpz_init(t);
    size_t rank = 0;
    for (size_t c = 0; c < n; c++) {
        size_t p = rank;
        while (p < n && mpz_sgn(a[p * width + c]) == 0)
            p++;
        if (p == n)
            continue;
        for (size_t j = 0; p != rank && j < width; j++)
            mpz_swap(a[p * width + j], a[rank * width + j]);
        for (size_t i = rank + 1; i < n; i++) {
            for (size_t j = c + 1; j < width; j++) {
                mpz_mul(a[i * width + j], a[i * width + j], a[rank * width + c]);
                mpz_mul(t, a[i * width + c], a[rank * width + j]);
                mpz_sub(a[i * width + j], a[i * width + j], t);
                mpz_divexact(a[i * width + j], a[i * width + j], last);
            }
            mpz_set_ui(a[i * width + c], 0);
        }
        mpz_set(last, a[rank * width + c]);
        rank++;
    }
    mpz_clears(last, t, NULL);
    return rank;
}

size_t bareiss_rank(mpz_t *a, size_t n)
{
    mpz_t *copy = bareiss_numbers(n * n);
    for (size_t t = 0; t < n * n; t++)
        mpz_set(copy[t], a[t]);
    size_t rank = eliminate_plainly(copy, n, n);
    bareiss_free(copy, n * n);
    return rank;
}

void bareiss_solve(mpz_t *a, size_t n, mpz_t *right, mpz_t *x, mpz_t den)
{
    mpz_t *w = bareiss_numbers(n * (n + 1)), g;
    mpz_init(g);
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < n; j++)
            mpz_set(w[i * (n + 1) + j], a[i * n + j]);
        mpz_set(w[i * (n + 1) + n], right[i]);
    }
    cr_assert_eq(eliminate_plainly(w, n, n + 1), n);
    mpz_set(den, w[(n - 1) * (n + 1) + n - 1]);
    for (size_t i = n; i-- > 0;) { /* Cramer: each den x is an integer */
        mpz_mul(x[i], w[i * (n + 1) + n], den);
        for (size_t j = i + 1; j < n; j++)
            mpz_submul(x[i], w[i * (n + 1) + j], x[j]);
        mpz_divexact(x[i], x[i], w[i * (n + 1) + i]);
    }
    mpz_set(g, den);
    for (size_t i = 0; i < n; i++)
        mpz_gcd(g, g, x[i]);
    if (mpz_sgn(den) < 0)
        mpz_neg(g, g);
    mpz_divexact(den, den, g);
    for (size_t i = 0; i < n; i++)
        mpz_divexact(x[i], x[i], g);
    mpz_clear(g);
    bareiss_free(w, n * (n + 1));
}
