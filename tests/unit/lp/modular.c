/* modular.c: arithmetic modulo the primes of exact solutions, and fractions from their residues. */
#include <criterion/criterion.h>

#include "lp/linalg/exact/rational.h"
#include "num/prime.h"
#include "support.h"

Test(modular, arithmetic_modulo_each_prime)
{
    support_rng g = {5};
    mpz_t p, x, y;
    mpz_inits(p, x, y, NULL);
    for (int k = 0; k < FMB_PRIMES; k++) {
        fmb_prime q = fmb_prime_number(k);
        mpz_set_ui(p, q.p);
        cr_assert(mpz_probab_prime_p(p, 30));
        cr_assert_eq(q.p * q.inverse, 1);
        for (int s = 0; s < 2000 / WATCHED; s++) {
            uint64_t high = s < 2 ? UINT64_MAX : support_next(&g);
            uint64_t low = s % 2 ? UINT64_MAX : support_next(&g);
            mpz_set_ui(x, high);
            mpz_mul_2exp(x, x, 64);
            mpz_add_ui(x, x, low);
            cr_assert_eq(fmb_prime_fold(&q, fmb_u128_join(high, low)), mpz_fdiv_ui(x, q.p));
            int64_t z = (int64_t)(low >> 1) - (support_chance(&g, 50) ? (int64_t)4 << 60 : 0);
            mpz_set_si(x, z);
            cr_assert_eq(fmb_prime_of_signed(&q, z), mpz_fdiv_ui(x, q.p));
            uint64_t a = s < 20 ? (uint64_t)s + 1 : s < 40 ? q.p - (uint64_t)s + 19 : low % q.p;
            a = a ? a : 1;
            cr_assert_eq(fmb_prime_times(&q, a, fmb_prime_inverse(&q, a)), 1);
        }
    }
    mpz_clears(p, x, y, NULL);
}

Test(modular, fractions_come_back_from_residues)
{
    support_rng g = {9};
    fmb_rational w;
    mpz_t m, y, a, b, num, den, t;
    fmb_rational_init(&w);
    mpz_inits(m, y, a, b, num, den, t, NULL);
    for (int k = 0; k < 3000 / WATCHED; k++) {
        int a_bits = support_between(&g, 1, k % 10 ? 150 : 2000);
        int b_bits = support_between(&g, 1, k % 10 ? 150 : 2000);
        mpz_set_ui(m, 1);
        while (mpz_sizeinbase(m, 2) < (size_t)(a_bits + b_bits + 2))
            mpz_mul_ui(m, m, fmb_prime_number(0).p);
        do {
            support_integer(&g, support_between(&g, 0, a_bits - 1), num);
            for (int s = 0; s < 5; s++) {
                mpz_mul_ui(num, num, (unsigned)support_between(&g, 1, 1000));
                mpz_fdiv_r_2exp(num, num, (mp_bitcnt_t)a_bits);
            }
            mpz_set_ui(den, 1);
            while (mpz_sizeinbase(den, 2) + 10 < (size_t)b_bits)
                mpz_mul_ui(den, den, (unsigned)support_between(&g, 2, 1000));
            mpz_gcd(t, num, den);
        } while (mpz_cmp_ui(t, 1) != 0);
        if (support_chance(&g, 50))
            mpz_neg(num, num);
        cr_assert(mpz_invert(t, den, m));
        mpz_mul(y, num, t);
        mpz_fdiv_r(y, y, m);
        cr_assert(fmb_rational_find(&w, y, m, (size_t)a_bits, (size_t)b_bits, a, b, NULL));
        cr_assert_eq(mpz_cmp(a, num), 0);
        cr_assert_eq(mpz_cmp(b, den), 0);
    }
    mpz_clears(m, y, a, b, num, den, t, NULL);
    fmb_rational_clear(&w);
}

/* Says no at call `limit`. */
typedef struct waiting {
    size_t asked, limit;
} waiting;

static fmb_status ask(void *self)
{
    waiting *w = self;
    return ++w->asked < w->limit ? FMB_OK : FMB_ERR_IO;
}

/* One of so many bits takes a fifth of a second: a hundred calls are many times as often as is
 * needed. */
Test(modular, a_long_fraction_asks_and_ends)
{
    enum { BITS = 300000 };
    waiting all = {.limit = SIZE_MAX};
    const fmb_poll poll = {ask, &all};
    fmb_rational w;
    mpz_t m, y, a, b, num, den;
    fmb_rational_init(&w);
    mpz_inits(m, y, a, b, num, den, NULL);
    mpz_ui_pow_ui(num, 3, BITS / 2);
    mpz_ui_pow_ui(den, 7, BITS / 3);
    mpz_setbit(m, 2 * BITS + 3);
    cr_assert(mpz_invert(y, den, m));
    mpz_mul(y, y, num);
    mpz_fdiv_r(y, y, m);
    cr_assert(fmb_rational_find(&w, y, m, BITS, BITS, a, b, &poll));
    cr_expect_eq(mpz_cmp(a, num), 0);
    cr_expect_eq(mpz_cmp(b, den), 0);
    cr_expect_geq(all.asked, 100, "%zu calls", all.asked);
    for (size_t limit = 1; limit <= all.asked; limit += all.asked / 4) {
        waiting some = {.limit = limit};
        const fmb_poll ends = {ask, &some};
        cr_expect(!fmb_rational_find(&w, y, m, BITS, BITS, a, b, &ends));
        cr_expect_eq(some.asked, limit);
    }
    mpz_clears(m, y, a, b, num, den, NULL);
    fmb_rational_clear(&w);
}
