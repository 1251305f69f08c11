/* cancel.c: the basic operation on rows: combine two vectors so that an entry vanishes. Three
 * widths of numbers, one formula; see vec.h.
 */
#include "num/gcd.h"
#include "num/vec.h"

static fmb_status store_scratch(fmb_vec *dst, size_t n, fmb_num *k, fmb_u128 all)
{
    const fmb_i128 *w = k->scratch;
    if (fmb_u128_is_zero(fmb_u128_right(all, FMB_SMALL_BITS))) {
        fmb_vec_clear(dst, n, k->mem);
        for (size_t i = 0; i < n; i++)
            dst->s[i] = fmb_i128_low(w[i]);
        return FMB_OK;
    }
    k->promotions++;
    if (!dst->z)
        dst->z = fmb_vec_block(n, k->mem);
    if (!dst->z)
        return fmb_mem_status(k->mem);
    for (size_t i = 0; i < n; i++)
        fmb_integer_set_128(dst->z[i], w[i]);
    return fmb_vec_settle(dst, n, k->mem);
}

/* By shifts and subtractions until both numbers fit into 64 bits, then fmb_gcd64. */
static fmb_u128 gcd_of_128_bits(fmb_u128 a, fmb_u128 b)
{
    if (fmb_u128_is_zero(a) || fmb_u128_is_zero(b))
        return fmb_u128_or(a, b);
    int shift = fmb_u128_trailing_zeros(fmb_u128_or(a, b));
    a = fmb_u128_right(a, fmb_u128_trailing_zeros(a));
    while (!fmb_u128_is_zero(b) && (fmb_u128_high(a) | fmb_u128_high(b)) != 0) {
        b = fmb_u128_right(b, fmb_u128_trailing_zeros(b));
        bool less = fmb_u128_is_less(a, b);
        fmb_u128 low = less ? a : b;
        b = less ? fmb_u128_minus(b, a) : fmb_u128_minus(a, b);
        a = low;
    }
    if (!fmb_u128_is_zero(b))
        a = fmb_u128_of(fmb_gcd64(fmb_u128_low(a), fmb_u128_low(b)));
    return fmb_u128_left(a, shift);
}

/* p a + q b in 128 bits, divided by its content before it is stored. */
static fmb_status cancel_in_128_bits(fmb_vec *dst, const fmb_vec *a, const fmb_vec *b, size_t n,
                                     int64_t p, int64_t q, fmb_num *k)
{
    fmb_i128 *w = k->scratch;
    const fmb_u128 one = fmb_u128_of(1);
    fmb_u128 g = fmb_u128_of(0), all = g;
    for (size_t i = 0; i < n; i++) {
        w[i] = fmb_i128_plus_product(fmb_i128_product(p, a->s[i]), q, b->s[i]);
        if (!fmb_u128_are_equal(g, one))
            g = gcd_of_128_bits(g, fmb_i128_size(w[i]));
    }
    for (size_t i = 0; i < n; i++) {
        if (fmb_u128_is_less(one, g))
            w[i] = fmb_i128_quotient(w[i], fmb_i128_of_u128(g));
        all = fmb_u128_or(all, fmb_i128_size(w[i]));
    }
    FMB_TRY(store_scratch(dst, n, k, all));
    if (!dst->z)
        fmb_vec_measure(dst, n);
    return FMB_OK;
}

static fmb_status cancel_in_int64(fmb_vec *dst, const fmb_vec *a, const fmb_vec *b, size_t n,
                                  size_t c, fmb_num *k)
{
    uint64_t ac = fmb_abs64(a->s[c]), bc = fmb_abs64(b->s[c]);
    uint64_t g = ac == 1 || bc == 1 ? 1 : fmb_gcd64(ac, bc);
    if (g > 1) {
        ac /= g;
        bc /= g;
    }
    int64_t p = (int64_t)bc, q = (int64_t)ac;
    int pa = fmb_bits64((uint64_t)p) + a->bits, qb = fmb_bits64((uint64_t)q) + b->bits;
    if ((a->s[c] > 0) == (b->s[c] > 0))
        q = -q;
    if ((pa > qb ? pa : qb) + 1 > FMB_SMALL_BITS)
        return cancel_in_128_bits(dst, a, b, n, p, q, k);
    fmb_vec_clear(dst, n, k->mem);
    bool narrow = (bc | ac) >> 31 == 0 && a->bits <= 31 && b->bits <= 31;
    uint64_t all =
        (narrow ? k->kernels->combine_narrow : k->kernels->combine)(dst->s, a->s, b->s, n, p, q);
    dst->bits = fmb_bits64(all);
    if (dst->bits > FMB_LAZY_BITS)
        fmb_vec_reduce_small(dst, n);
    return FMB_OK;
}

/* Entry i of v as an mpz, without copying a wide one. */
static mpz_srcptr entry_as_mpz(const fmb_vec *v, size_t i, mpz_t room)
{
    if (v->z)
        return v->z[i];
    fmb_integer_set_i64(room, v->s[i]);
    return room;
}

static bool is_long(const mpz_t z)
{
    return mpz_sizeinbase(z, 2) > FMB_LONG_BITS;
}

/* dst = p a + q b, with p and q in k. dst may be a, so entry i is read before it is written. Long
 * results are written to other memory first, so that dst is unchanged if the operation is cut off
 * by poll or memory. */
static fmb_status combine_in_gmp(fmb_vec *dst, const fmb_vec *a, const fmb_vec *b, size_t n,
                                 fmb_num *k)
{
    bool takes_long = is_long(k->p) || is_long(k->q), apart = takes_long || !dst->z;
    fmb_status st = FMB_OK;
    mpz_t *z = apart ? fmb_vec_block(n, k->mem) : dst->z;
    if (!z)
        return fmb_mem_status(k->mem);
    for (size_t i = 0; st == FMB_OK && i < n; i++) {
        mpz_mul(z[i], k->p, entry_as_mpz(a, i, k->t));
        mpz_addmul(z[i], k->q, entry_as_mpz(b, i, k->t));
        st = takes_long ? fmb_poll_ask(&k->poll) : FMB_OK;
    }
    if (st != FMB_OK) {
        fmb_vec_block_free(z, n, k->mem);
        return st;
    }
    k->promotions += dst->z == NULL;
    if (apart)
        fmb_vec_clear(dst, n, k->mem);
    dst->z = z;
    return FMB_OK;
}

static fmb_status cancel_in_gmp(fmb_vec *dst, const fmb_vec *a, const fmb_vec *b, size_t n,
                                size_t c, fmb_num *k)
{
    fmb_vec_get(a, c, k->q);
    fmb_vec_get(b, c, k->p);
    FMB_TRY(fmb_long_gcd(k->t, k->p, k->q, &k->poll));
    mpz_divexact(k->p, k->p, k->t);
    mpz_divexact(k->q, k->q, k->t);
    if (mpz_sgn(k->p) < 0)
        mpz_neg(k->p, k->p);
    else
        mpz_neg(k->q, k->q);
    FMB_TRY(combine_in_gmp(dst, a, b, n, k));
    return fmb_vec_reduce(dst, n, k);
}

fmb_status fmb_vec_cancel(fmb_vec *dst, const fmb_vec *a, const fmb_vec *b, size_t n, size_t c,
                          fmb_num *k)
{
    FMB_TRY(a->z || b->z ? cancel_in_gmp(dst, a, b, n, c, k) : cancel_in_int64(dst, a, b, n, c, k));
    return k->wide_only ? fmb_vec_widen(dst, n, k->mem) : FMB_OK;
}
