/* vectors.c: whatever the width, the arithmetic of vectors is that of GMP. */
#include <criterion/criterion.h>

#include "num/gcd.h"
#include "num/vec.h"
#include "num/weights.h"
#include "support.h"

enum { N = 6 };

/* A vector with room of its own, beside the same numbers in GMP. */
typedef struct twin {
    fmb_vec v;
    int64_t words[N];
    mpz_t z[N];
} twin;

static void twin_init(twin *t)
{
    t->v = (fmb_vec){.s = t->words};
    for (int i = 0; i < N; i++)
        mpz_init(t->z[i]);
}

static void twin_clear(twin *t, fmb_mem *mem)
{
    fmb_vec_clear(&t->v, N, mem);
    for (int i = 0; i < N; i++)
        mpz_clear(t->z[i]);
}

/* Random numbers of one of many sizes; some entries 0; entry 0 never. */
static void twin_fill(twin *t, support_rng *g, fmb_mem *mem)
{
    static const int bits[] = {0, 3, 14, 15, 16, 29, 30, 31, 32, 60, 61, 62, 63, 64, 100, 200};
    int size = bits[support_between(g, 0, 15)];
    for (int i = 0; i < N; i++) {
        support_integer(g, size, t->z[i]);
        if (support_chance(g, 20))
            mpz_set_ui(t->z[i], 0);
    }
    if (mpz_sgn(t->z[0]) == 0)
        mpz_set_si(t->z[0], support_chance(g, 50) ? -7 : 6);
    cr_assert_eq(fmb_vec_set_z(&t->v, N, t->z, mem), FMB_OK);
}

static void assert_invariants(const fmb_vec *v)
{
    if (v->z)
        return;
    cr_assert_leq(v->bits, FMB_SMALL_BITS);
    for (int i = 0; i < N; i++)
        cr_assert_lt(fmb_abs64(v->s[i]), (uint64_t)1 << v->bits);
}

/* The vector equals the twin's numbers up to a positive factor. */
static void assert_parallel(const fmb_vec *v, mpz_t *z)
{
    mpz_t a, b, x, y;
    mpz_inits(a, b, x, y, NULL);
    for (size_t i = 0; i < N; i++) {
        cr_assert_eq(fmb_vec_sgn(v, i), mpz_sgn(z[i]));
        for (size_t k = 0; k < N; k++) {
            fmb_vec_get(v, i, x);
            fmb_vec_get(v, k, y);
            mpz_mul(a, x, z[k]);
            mpz_mul(b, y, z[i]);
            cr_assert_eq(mpz_cmp(a, b), 0);
        }
    }
    mpz_clears(a, b, x, y, NULL);
}

Test(vec, set_get_and_measure)
{
    support_rng g = {1};
    fmb_mem mem;
    mpz_t x;
    twin t;
    fmb_mem_init(&mem, NULL, 0);
    mpz_init(x);
    twin_init(&t);
    for (int k = 0; k < 20000; k++) {
        twin_fill(&t, &g, &mem);
        assert_invariants(&t.v);
        for (size_t i = 0; i < N; i++) {
            fmb_vec_get(&t.v, i, x);
            cr_assert_eq(mpz_cmp(x, t.z[i]), 0);
            cr_assert_eq(fmb_vec_sgn(&t.v, i), mpz_sgn(t.z[i]));
        }
    }
    twin_clear(&t, &mem);
    mpz_clear(x);
    cr_assert_eq(mem.used, 0);
}

/* dst = |b_c| a -+ |a_c| b, up to a positive factor; into a fresh vector and in place. */
static void check_cancel(bool wide_only)
{
    support_rng g = {2};
    fmb_mem mem;
    fmb_num num;
    twin a, b, fresh, truth;
    mpz_t t;
    fmb_mem_init(&mem, NULL, 0);
    cr_assert_eq(fmb_num_init(&num, &mem, N, wide_only), FMB_OK);
    twin_init(&a);
    twin_init(&b);
    twin_init(&fresh);
    twin_init(&truth);
    mpz_init(t);
    for (int k = 0; k < 100000; k++) {
        twin_fill(&a, &g, &mem);
        twin_fill(&b, &g, &mem);
        for (int i = 0; i < N; i++) {
            mpz_mul(truth.z[i], a.z[i], b.z[0]);
            mpz_submul(truth.z[i], b.z[i], a.z[0]);
            if (mpz_sgn(b.z[0]) < 0)
                mpz_neg(truth.z[i], truth.z[i]);
        }
        cr_assert_eq(fmb_vec_cancel(&fresh.v, &a.v, &b.v, N, 0, &num), FMB_OK);
        assert_invariants(&fresh.v);
        assert_parallel(&fresh.v, truth.z);
        cr_assert(!wide_only || fresh.v.z);
        cr_assert_eq(fmb_vec_cancel(&a.v, &a.v, &b.v, N, 0, &num), FMB_OK);
        assert_parallel(&a.v, truth.z);
    }
    mpz_clear(t);
    twin_clear(&a, &mem);
    twin_clear(&b, &mem);
    twin_clear(&fresh, &mem);
    twin_clear(&truth, &mem);
    fmb_num_clear(&num);
    cr_assert_eq(mem.used, 0);
}

Test(vec, cancel)
{
    check_cancel(false);
}

Test(vec, cancel_wide)
{
    check_cancel(true);
}

Test(vec, reduce_makes_primitive)
{
    support_rng g = {3};
    fmb_mem mem;
    fmb_num num;
    twin a;
    mpz_t gcd, x;
    fmb_mem_init(&mem, NULL, 0);
    cr_assert_eq(fmb_num_init(&num, &mem, N, false), FMB_OK);
    twin_init(&a);
    mpz_inits(gcd, x, NULL);
    for (int k = 0; k < 20000; k++) {
        twin_fill(&a, &g, &mem);
        for (int i = 0; i < N && k % 2; i++)
            mpz_mul_ui(a.z[i], a.z[i], 360360);
        cr_assert_eq(fmb_vec_set_z(&a.v, N, a.z, &mem), FMB_OK);
        cr_assert_eq(fmb_vec_reduce(&a.v, N, &num), FMB_OK);
        assert_parallel(&a.v, a.z);
        mpz_set_ui(gcd, 0);
        for (size_t i = 0; i < N; i++) {
            fmb_vec_get(&a.v, i, x);
            mpz_gcd(gcd, gcd, x);
        }
        cr_assert_eq(mpz_cmp_ui(gcd, 1), 0);
    }
    mpz_clears(gcd, x, NULL);
    twin_clear(&a, &mem);
    fmb_num_clear(&num);
    cr_assert_eq(mem.used, 0);
}

Test(vec, compare_copy_and_hash)
{
    support_rng g = {4};
    fmb_mem mem;
    twin a, b, c;
    mpz_t x, y;
    fmb_mem_init(&mem, NULL, 0);
    twin_init(&a);
    twin_init(&b);
    twin_init(&c);
    mpz_inits(x, y, NULL);
    for (int k = 0; k < 20000; k++) {
        twin_fill(&a, &g, &mem);
        twin_fill(&b, &g, &mem);
        mpz_abs(x, b.z[1]);
        mpz_mul(x, x, a.z[2]);
        mpz_abs(y, a.z[4]);
        mpz_mul(y, y, b.z[3]);
        int order = fmb_vec_compare_products(&a.v, 2, &b.v, 1, &b.v, 3, &a.v, 4);
        cr_assert_eq(order > 0, mpz_cmp(x, y) > 0);
        cr_assert_eq(order < 0, mpz_cmp(x, y) < 0);
        cr_assert_eq(fmb_vec_copy(&c.v, &a.v, N, &mem), FMB_OK);
        cr_assert(fmb_vec_equal(&c.v, &a.v, N));
        cr_assert_eq(fmb_vec_widen(&c.v, N, &mem), FMB_OK);
        cr_assert(fmb_vec_equal(&c.v, &a.v, N) && fmb_vec_equal(&a.v, &c.v, N));
        cr_assert_eq(fmb_vec_hash(&c.v, N), fmb_vec_hash(&a.v, N));
        cr_assert(!fmb_vec_equal(&a.v, &b.v, N) || fmb_vec_hash(&a.v, N) == fmb_vec_hash(&b.v, N));
    }
    mpz_clears(x, y, NULL);
    twin_clear(&a, &mem);
    twin_clear(&b, &mem);
    twin_clear(&c, &mem);
    cr_assert_eq(mem.used, 0);
}

Test(gcd, agrees_with_gmp)
{
    support_rng g = {5};
    mpz_t x;
    mpz_init(x);
    for (int k = 0; k < 100000; k++) {
        uint64_t a = support_next(&g) >> support_between(&g, 0, 63);
        uint64_t b = support_next(&g) >> support_between(&g, 0, 63);
        mpz_set_ui(x, a);
        mpz_gcd_ui(x, x, b);
        cr_assert_eq(fmb_gcd64(a, b), mpz_get_ui(x));
    }
    cr_assert_eq(fmb_gcd64(0, 0), 0);
    cr_assert_eq(fmb_gcd64(0, 12), 12);
    cr_assert_eq(fmb_gcd64(12, 0), 12);
    cr_assert_eq(fmb_abs64(INT64_MIN), (uint64_t)1 << 63);
    cr_assert_eq(fmb_bits64(0), 0);
    cr_assert_eq(fmb_bits64(UINT64_MAX), 64);
    mpz_clear(x);
}

Test(weights, grow_and_keep)
{
    fmb_mem mem;
    fmb_weights w = {0};
    mpq_t q;
    fmb_mem_init(&mem, NULL, 0);
    mpq_init(q);
    for (uint32_t i = 0; i < 100; i++) {
        mpq_set_ui(q, i, 7);
        mpq_canonicalize(q);
        cr_assert_eq(fmb_weights_add(&w, 3 * i, q, &mem), FMB_OK);
    }
    for (uint32_t i = 0; i < 100; i++) {
        mpq_set_ui(q, i, 7);
        mpq_canonicalize(q);
        cr_assert(mpq_equal(w.value[i], q) && w.index[i] == 3 * i);
    }
    fmb_weights_clear(&w, &mem);
    mpq_clear(q);
    cr_assert_eq(mem.used, 0);
}
