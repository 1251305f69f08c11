/* modular_kernel.c: what rows of short numbers leave free, against elimination on whole matrices.
 */
#include <criterion/criterion.h>

#include "bareiss.h"
#include "lp/linalg/modular/modular_kernel.h"
#include "num/gcd.h"
#include "support.h"

static void fill_at_random(support_rng *g, fmb_modular_kernel *h, size_t columns, int64_t *a)
{
    size_t n = h->n;
    bool dependent = n > 2 && support_chance(g, 30), empty = support_chance(g, 30);
    fmb_modular_kernel_zero(h, columns);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < columns; j++) {
            int64_t *x = &a[i * columns + j];
            *x = support_chance(g, 40) ? 0 : support_between(g, -9, 9);
            if (dependent && i + 1 == n)
                *x = a[j] - 2 * a[columns + j];
            if (empty && i == 1)
                *x = 0;
            if (*x != 0)
                fmb_modular_kernel_put(h, i, j, *x);
        }
}

static size_t rank_of_rows(const int64_t *a, size_t n, size_t columns)
{
    size_t size = n + columns;
    mpz_t *z = bareiss_numbers(size * size); /* with zeros around it */
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < columns; j++)
            mpz_set_si(z[i * size + j], a[i * columns + j]);
    size_t rank = bareiss_rank(z, size);
    bareiss_free(z, size * size);
    return rank;
}

/* Is v, not 0 and coprime, 0 on all rows? */
static void expect_kernel(const fmb_modular_kernel *h, const int64_t *a)
{
    uint64_t g = 0;
    for (size_t j = 0; j < h->columns; j++)
        g = fmb_gcd64(g, fmb_abs64(h->v[j]));
    cr_assert_eq(g, 1);
    for (size_t i = 0; i < h->n; i++) {
        fmb_i128 sum = fmb_i128_of(0);
        for (size_t j = 0; j < h->columns; j++)
            sum = fmb_i128_plus_product(sum, a[i * h->columns + j], h->v[j]);
        cr_assert(fmb_i128_sign(sum) == 0);
    }
}

Test(short, kernels)
{
    fmb_mem mem;
    fmb_mem_init(&mem, NULL, 0);
    for (uint64_t seed = 0; seed < 3000; seed++) {
        support_rng g = {seed};
        fmb_modular_kernel h;
        size_t n = (size_t)support_between(&g, 1, 12), columns = n + 1;
        int64_t a[12 * 13];
        if (support_chance(&g, 50))
            columns = (size_t)support_between(&g, n > 2 ? (int)n - 2 : 1, (int)n + 1);
        cr_assert_eq(fmb_modular_kernel_init(&h, &mem, n), FMB_OK);
        fill_at_random(&g, &h, columns, a);
        bool found = fmb_modular_kernel_find(&h);
        cr_assert_eq(found, rank_of_rows(a, n, columns) + 1 == columns);
        if (found)
            expect_kernel(&h, a);
        fmb_modular_kernel_clear(&h, &mem);
    }
    cr_assert_eq(mem.used, 0);
}
