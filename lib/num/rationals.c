/* rationals.c: vectors of rationals; see rationals.h. */
#include "num/rationals.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "num/word.h"

/* Bytes that malloc takes for the limb of a denominator 1. */
#define FIRST_LIMB ((size_t)32)

fmb_status fmb_rationals_new(mpq_t **out, size_t n, fmb_mem *mem)
{
    mpq_t *x;
    FMB_TRY(FMB_GET(mem, x, n));
    if (!fmb_mem_charge(mem, n * FIRST_LIMB)) {
        fmb_mem_put(mem, x, n, sizeof *x);
        return fmb_mem_status(mem);
    }
    for (size_t j = 0; j < n; j++)
        mpq_init(x[j]);
    *out = x;
    return FMB_OK;
}

void fmb_rationals_free(mpq_t *x, size_t n, fmb_mem *mem)
{
    if (!x)
        return;
    for (size_t j = 0; j < n; j++)
        mpq_clear(x[j]);
    fmb_mem_refund(mem, n * FIRST_LIMB);
    fmb_mem_put(mem, x, n, sizeof *x);
}

enum { LEAST_EXPONENT = -1074, MOST_EXPONENT = 1024 }; /* 2^LEAST is a double, 2^MOST is none */

/* |q| = m 2^e, except that the last bit of m, of at least 57 bits, is set if any later bit is. */
static uint64_t first_bits(mpq_srcptr q, long *e)
{
    const long up =
        56 - ((long)mpz_sizeinbase(mpq_numref(q), 2) - (long)mpz_sizeinbase(mpq_denref(q), 2));
    mpz_t m, rest;
    mpz_inits(m, rest, NULL);
    if (up >= 0) {
        mpz_mul_2exp(m, mpq_numref(q), (mp_bitcnt_t)up);
        mpz_tdiv_qr(m, rest, m, mpq_denref(q));
    } else {
        mpz_mul_2exp(rest, mpq_denref(q), (mp_bitcnt_t)-up);
        mpz_tdiv_qr(m, rest, mpq_numref(q), rest);
    }
    uint64_t bits = fmb_integer_low(m) << 1 | (mpz_sgn(rest) != 0);
    mpz_clears(m, rest, NULL);
    *e = -up - 1;
    return bits;
}

/* Of two nearest doubles the even one; beyond the largest double that one, or what mpq_get_d
 * gives. */
double fmb_nearest_double(mpq_srcptr q)
{
    long e;
    if (!q || mpq_sgn(q) == 0)
        return 0;
    const uint64_t m = first_bits(q, &e);
    const int length = 64 - __builtin_clzll(m);
    const long room = length + e - LEAST_EXPONENT; /* mantissa bits of doubles of that size */
    if (length + e > MOST_EXPONENT)
        return mpq_get_d(q);
    if (room < 0)
        return 0;
    const int drop = length - (room < DBL_MANT_DIG ? (int)room : DBL_MANT_DIG);
    const uint64_t half = UINT64_C(1) << (drop - 1), rest = m & (2 * half - 1);
    uint64_t kept = m >> drop;
    kept += rest > half || (rest == half && kept % 2 == 1);
    double x = fmin(ldexp((double)kept, (int)e + drop), DBL_MAX);
    return mpq_sgn(q) < 0 ? -x : x;
}

/* If both are doubles, their quotient is rounded once, so it is the nearest double. If den is a
 * power of two, thus a double, dividing by it is exact, and num has been rounded once. As den <
 * 2^63, no such quotient underflows. */
bool fmb_nearest_quotient(int64_t num, int64_t den, double *out)
{
    const int64_t most = (int64_t)1 << 53;
    bool are_doubles = num >= -most && num <= most && den <= most;
    if (!are_doubles && (den & (den - 1)) != 0)
        return false;
    *out = (double)num / (double)den;
    return true;
}

/* Least number of bits of the integer root: from 54 bits and one that stands for all later ones,
 * the rounding to 53 bits, or to fewer for subnormals, is the same as from all bits. */
enum { ROOT_BITS = 64 };

/* With k such that q 4^k has at least 2 ROOT_BITS bits, floor(sqrt(floor(q 4^k))) is floor(sqrt(q)
 * 2^k); its last bit, of weight far below any rounding, is set if anything was cut off. So it is,
 * over 2^k, on the same side of every midpoint of two doubles as the root. */
double fmb_nearest_root(mpq_srcptr q)
{
    if (mpq_sgn(q) == 0)
        return 0;
    long bits = (long)mpz_sizeinbase(mpq_numref(q), 2) - (long)mpz_sizeinbase(mpq_denref(q), 2);
    long k = ROOT_BITS - bits / 2 + 1;
    mpq_t root;
    mpz_t rest, other;
    mpq_init(root);
    mpz_inits(rest, other, NULL);
    mpz_mul_2exp(rest, mpq_numref(q), k > 0 ? 2 * (mp_bitcnt_t)k : 0);
    mpz_mul_2exp(other, mpq_denref(q), k < 0 ? 2 * (mp_bitcnt_t)-k : 0);
    mpz_fdiv_qr(rest, other, rest, other);
    bool cut = mpz_sgn(other) != 0;
    mpz_sqrtrem(mpq_numref(root), rest, rest);
    if (cut || mpz_sgn(rest) != 0)
        mpz_setbit(mpq_numref(root), 0);
    if (k > 0)
        mpq_div_2exp(root, root, (mp_bitcnt_t)k);
    else
        mpq_mul_2exp(root, root, (mp_bitcnt_t)-k);
    double nearest = fmb_nearest_double(root);
    mpq_clear(root);
    mpz_clears(rest, other, NULL);
    return nearest;
}

bool fmb_rational_as_integer(mpq_srcptr q, int64_t *out)
{
    if (mpz_cmp_ui(mpq_denref(q), 1) != 0 || !fmb_integer_is_i64(mpq_numref(q)))
        return false;
    *out = fmb_integer_get_i64(mpq_numref(q));
    return true;
}

void fmb_rational_give(mpq_srcptr q, mpq_ptr out)
{
    if (out && q)
        mpq_set(out, q);
    else if (out)
        mpq_set_ui(out, 0, 1);
}

/* The text is allocated and released by GMP's functions, like limbs. */
size_t fmb_rational_print(mpq_srcptr q, char *text, size_t size)
{
    void (*release)(void *, size_t);
    if (!q && text && size > 1)
        memcpy(text, "0", 2);
    if (!q)
        return 1;
    char *all = mpq_get_str(NULL, 10, q);
    size_t length = strlen(all);
    if (text && length < size)
        memcpy(text, all, length + 1);
    mp_get_memory_functions(NULL, NULL, &release);
    release(all, length + 1);
    return length;
}
