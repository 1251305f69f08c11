/* sums.c: signs of sums of integers times rationals (proof/sum.h), on which fmb_check rests,
 * against sums of rationals by GMP; mostly of sums that are 0, or nearly.
 *
 * A program of its own: the build also links it with sum.c after one line has been changed, and
 * expects it to fail then.
 */
#include <criterion/criterion.h>

#include "proof/sum.h"
#include "support/support.h"

enum { MOST = 24 };

typedef struct sample {
    size_t n;
    mpq_t weight[MOST];
    mpz_t entry[MOST];
    bool plain[MOST]; /* no vector: the entry is 1 */
} sample;

static void init_sample(sample *x)
{
    for (size_t i = 0; i < MOST; i++) {
        mpq_init(x->weight[i]);
        mpz_init(x->entry[i]);
        x->plain[i] = false;
    }
}

static void clear_sample(sample *x)
{
    for (size_t i = 0; i < MOST; i++) {
        mpq_clear(x->weight[i]);
        mpz_clear(x->entry[i]);
    }
}

/* A positive integer: small, of a few small primes, or very long. */
static void draw_denominator(support_rng *g, mpz_t out)
{
    static const unsigned prime[] = {2, 3, 5, 7};
    int family = support_between(g, 0, 2);
    mpz_set_ui(out, 1);
    for (int k = support_between(g, 0, 6); family == 0 && k > 0; k--)
        mpz_mul_ui(out, out, prime[support_between(g, 0, 3)]);
    if (family == 1)
        mpz_set_si(out, support_between(g, 1, 1000));
    if (family == 2)
        mpz_setbit(out, (mp_bitcnt_t)support_between(g, 100, 3000));
}

static void draw_sample(support_rng *g, sample *x)
{
    x->n = (size_t)support_between(g, 1, MOST - 1);
    for (size_t i = 0; i < x->n; i++) {
        support_integer(g, support_chance(g, 50) ? 0 : 200, mpq_numref(x->weight[i]));
        draw_denominator(g, mpq_denref(x->weight[i]));
        mpq_canonicalize(x->weight[i]);
        x->plain[i] = support_chance(g, 30);
        support_integer(g, support_chance(g, 50) ? 0 : 200, x->entry[i]);
        if (x->plain[i])
            mpz_set_ui(x->entry[i], 1);
    }
}

/* The sum, by GMP, one after another. */
static void add_naively(const sample *x, mpq_t sum)
{
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(sum, 0, 1);
    for (size_t i = 0; i < x->n; i++) {
        mpq_set_z(one, x->entry[i]);
        mpq_mul(one, one, x->weight[i]);
        mpq_add(sum, sum, one);
    }
    mpq_clear(one);
}

/* As the judge has it: weights in groups, entries in vectors. */
static int sign_by_groups(const sample *x)
{
    fmb_mem mem;
    fmb_poll forever = {0};
    fmb_fractions w;
    fmb_product p[MOST];
    fmb_vec val[MOST] = {{0}};
    int64_t room[MOST];
    int sign = 7;
    fmb_mem_init(&mem, NULL, 0);
    cr_assert_eq(fmb_fractions_init(&w, x->n, &mem, &forever), FMB_OK);
    for (size_t i = 0; i < x->n; i++) {
        mpz_t entry[1];
        mpz_init_set(entry[0], x->entry[i]);
        mpz_set(w.num.z[i], mpq_numref(x->weight[i]));
        mpz_set(w.den.z[i], mpq_denref(x->weight[i]));
        val[i].s = &room[i];
        cr_assert_eq(fmb_vec_set_z(&val[i], 1, entry, &mem), FMB_OK);
        mpz_clear(entry[0]);
    }
    cr_assert_eq(fmb_fractions_share(&w), FMB_OK);
    for (size_t i = 0; i < x->n; i++)
        p[i] = (fmb_product){0, w.group[i], x->plain[i] ? NULL : &val[i], 0, i};
    fmb_products_sort(p, x->n);
    cr_assert_eq(fmb_products_sign(&w, p, x->n, &sign), FMB_OK);
    for (size_t i = 0; i < x->n; i++)
        fmb_vec_clear(&val[i], 1, &mem);
    fmb_fractions_clear(&w);
    cr_assert_eq(mem.used, 0);
    return sign;
}

static void expect_sign(const sample *x, const char *what, uint64_t seed)
{
    mpq_t sum;
    mpq_init(sum);
    add_naively(x, sum);
    int sign = sign_by_groups(x);
    cr_expect_eq(sign, mpq_sgn(sum), "%s, seed %llu: %d, not %d", what, (unsigned long long)seed,
                 sign, mpq_sgn(sum));
    mpq_clear(sum);
}

/* One more weight makes the sum 0. */
static void balance(sample *x)
{
    size_t last = x->n;
    mpq_t sum;
    mpq_init(sum);
    add_naively(x, sum);
    mpq_neg(x->weight[last], sum);
    mpz_set_ui(x->entry[last], 1);
    x->plain[last] = true;
    x->n++;
    mpq_clear(sum);
}

/* A numerator that is wrong by 1, a sign, a denominator that is wrong, a term that is missing. */
static void spoil(support_rng *g, sample *x, int how)
{
    size_t i = (size_t)support_between(g, 0, (int)x->n - 1);
    mpz_ptr num = mpq_numref(x->weight[i]), den = mpq_denref(x->weight[i]);
    switch (how) {
    case 0:
        mpz_add_ui(num, num, 1);
        break;
    case 1:
        mpz_neg(num, num);
        break;
    case 2:
        mpz_add_ui(den, den, 1);
        break;
    default:
        x->n--;
        mpq_swap(x->weight[i], x->weight[x->n]);
        mpz_swap(x->entry[i], x->entry[x->n]);
        x->plain[i] = x->plain[x->n];
    }
    if (how < 3)
        mpq_canonicalize(x->weight[i]);
}

Test(sums, as_by_gmp)
{
    static const char *const what[] = {"numerator", "sign", "denominator", "missing"};
    size_t spoiled = 0;
    for (uint64_t seed = 0; seed < 1000; seed++) {
        support_rng g = {seed};
        sample x;
        mpq_t sum;
        mpq_init(sum);
        init_sample(&x);
        draw_sample(&g, &x);
        expect_sign(&x, "any", seed);
        balance(&x);
        cr_expect_eq(sign_by_groups(&x), 0, "balanced, seed %llu", (unsigned long long)seed);
        int how = support_between(&g, 0, 3);
        spoil(&g, &x, how);
        expect_sign(&x, what[how], seed);
        add_naively(&x, sum);
        spoiled += mpq_sgn(sum) != 0;
        clear_sample(&x);
        mpq_clear(sum);
    }
    cr_expect_gt(spoiled, 700, "only %zu sums were not 0 any more", spoiled);
}

/* Nothing is 0. */
Test(sums, empty)
{
    fmb_mem mem;
    fmb_poll forever = {0};
    fmb_fractions w;
    int sign = 7;
    fmb_mem_init(&mem, NULL, 0);
    cr_assert_eq(fmb_fractions_init(&w, 0, &mem, &forever), FMB_OK);
    cr_assert_eq(fmb_fractions_share(&w), FMB_OK);
    cr_assert_eq(fmb_products_sign(&w, NULL, 0, &sign), FMB_OK);
    cr_expect_eq(sign, 0);
    fmb_fractions_clear(&w);
}
