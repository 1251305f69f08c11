/* cancel.c: the one operation on rows that everything is made of: combine two vectors so that an
 * entry vanishes. Three widths, one formula; see vec.h.
 */
#include "num/gcd.h"
#include "num/vec.h"

static fmb_u128 absolute_128(fmb_i128 v)
{
    return v < 0 ? 0 - (fmb_u128)v : (fmb_u128)v;
}

static fmb_status store_scratch(fmb_vec *dst, size_t n, fmb_num *k, fmb_u128 all)
{
    const fmb_i128 *w = k->scratch;
    if (all >> FMB_SMALL_BITS == 0) {
        fmb_vec_clear(dst, n, k->mem);
        for (size_t i = 0; i < n; i++)
            dst->s[i] = (int64_t)w[i];
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

static int trailing_zeros_128(fmb_u128 v)
{
    uint64_t low = (uint64_t)v;
    return low != 0 ? __builtin_ctzll(low) : 64 + __builtin_ctzll((uint64_t)(v >> 64));
}

/* As fmb_gcd64, until both fit. */
static fmb_u128 gcd_of_128_bits(fmb_u128 a, fmb_u128 b)
{
    if (a == 0 || b == 0)
        return a | b;
    int shift = trailing_zeros_128(a | b);
    a >>= trailing_zeros_128(a);
    while (b != 0 && (a | b) >> 64 != 0) {
        b >>= trailing_zeros_128(b);
        fmb_u128 low = a < b ? a : b;
        b = a < b ? b - a : a - b;
        a = low;
    }
    return (b == 0 ? a : (fmb_u128)fmb_gcd64((uint64_t)a, (uint64_t)b)) << shift;
}

/* p a + q b in 128 bits, divided by its content before it is stored. */
static fmb_status cancel_in_128_bits(fmb_vec *dst, const fmb_vec *a, const fmb_vec *b, size_t n,
                                     int64_t p, int64_t q, fmb_num *k)
{
    fmb_i128 *w = k->scratch;
    fmb_u128 g = 0, all = 0;
    for (size_t i = 0; i < n; i++) {
        w[i] = (fmb_i128)p * a->s[i] + (fmb_i128)q * b->s[i];
        if (g != 1)
            g = gcd_of_128_bits(g, absolute_128(w[i]));
    }
    for (size_t i = 0; i < n; i++) {
        if (g > 1)
            w[i] /= (fmb_i128)g;
        all |= absolute_128(w[i]);
    }
    fmb_status st = store_scratch(dst, n, k, all);
    if (st == FMB_OK && !dst->z)
        fmb_vec_measure(dst, n);
    return st;
}

static fmb_status cancel_in_int64(fmb_vec *dst, const fmb_vec *a, const fmb_vec *b, size_t n,
                                  size_t c, fmb_num *k)
{
    uint64_t ac = fmb_abs64(a->s[c]), bc = fmb_abs64(b->s[c]), g = fmb_gcd64(ac, bc);
    int64_t p = (int64_t)(bc / g), q = (int64_t)(ac / g);
    int pa = fmb_bits64((uint64_t)p) + a->bits, qb = fmb_bits64((uint64_t)q) + b->bits;
    if ((a->s[c] > 0) == (b->s[c] > 0))
        q = -q;
    if ((pa > qb ? pa : qb) + 1 > FMB_SMALL_BITS)
        return cancel_in_128_bits(dst, a, b, n, p, q, k);
    fmb_vec_clear(dst, n, k->mem);
    bool narrow = (bc / g | ac / g) >> 31 == 0 && a->bits <= 31 && b->bits <= 31;
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
    mpz_set_si(room, v->s[i]);
    return room;
}

static fmb_status cancel_in_gmp(fmb_vec *dst, const fmb_vec *a, const fmb_vec *b, size_t n,
                                size_t c, fmb_num *k)
{
    mpz_t *z = dst->z; /* entry i is read before it is written: dst may be a */
    if (!z)
        z = fmb_vec_block(n, k->mem);
    if (!z)
        return fmb_mem_status(k->mem);
    fmb_vec_get(a, c, k->q);
    fmb_vec_get(b, c, k->p);
    mpz_gcd(k->t, k->p, k->q);
    mpz_divexact(k->p, k->p, k->t);
    mpz_divexact(k->q, k->q, k->t);
    if (mpz_sgn(k->p) < 0)
        mpz_neg(k->p, k->p);
    else
        mpz_neg(k->q, k->q);
    for (size_t i = 0; i < n; i++) {
        mpz_mul(z[i], k->p, entry_as_mpz(a, i, k->t));
        mpz_addmul(z[i], k->q, entry_as_mpz(b, i, k->t));
    }
    k->promotions += dst->z == NULL;
    dst->z = z;
    return fmb_vec_reduce(dst, n, k);
}

fmb_status fmb_vec_cancel(fmb_vec *dst, const fmb_vec *a, const fmb_vec *b, size_t n, size_t c,
                          fmb_num *k)
{
    fmb_status st =
        a->z || b->z ? cancel_in_gmp(dst, a, b, n, c, k) : cancel_in_int64(dst, a, b, n, c, k);
    if (st == FMB_OK && k->wide_only)
        st = fmb_vec_widen(dst, n, k->mem);
    return st;
}
