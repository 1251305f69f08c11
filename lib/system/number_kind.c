/* number_kind.c: doubles, machine integers and rationals in the arrays of a caller; see
 * number_kind.h. */
#include "system/number_kind.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include "num/gcd.h"
#include "num/vec.h"

static const char *no_double(const void *numbers, size_t i, char buf[FMB_WRONG_NUMBER])
{
    double x = ((const double *)numbers)[i];
    if (isfinite(x))
        return NULL;
    snprintf(buf, FMB_WRONG_NUMBER, "is %g", x);
    return buf;
}

static bool is_zero_double(const void *numbers, size_t i)
{
    return fpclassify(((const double *)numbers)[i]) == FP_ZERO;
}

static uint64_t double_denominator(const void *numbers, size_t i)
{
    int power;
    int64_t digits = (int64_t)ldexp(frexp(((const double *)numbers)[i], &power), DBL_MANT_DIG);
    int lowest = power - DBL_MANT_DIG + (digits ? __builtin_ctzll((uint64_t)digits) : 0);
    return !digits || lowest >= 0 ? 1 : lowest > -FMB_SMALL_BITS ? (uint64_t)1 << -lowest : 0;
}

/* The factor is a power of two. */
static bool multiply_double(const void *numbers, size_t i, uint64_t factor, int64_t *out)
{
    double x = ((const double *)numbers)[i] * (double)factor;
    if (!(fabs(x) < (double)((int64_t)1 << FMB_SMALL_BITS)))
        return false;
    *out = (int64_t)x;
    return true;
}

static void get_double(mpq_t q, const void *numbers, size_t i)
{
    mpq_set_d(q, ((const double *)numbers)[i]);
}

static const char *no_integer(const void *numbers, size_t i, char buf[FMB_WRONG_NUMBER])
{
    (void)numbers;
    (void)i;
    (void)buf;
    return NULL;
}

static bool is_zero_integer(const void *numbers, size_t i)
{
    return ((const int64_t *)numbers)[i] == 0;
}

static uint64_t integer_denominator(const void *numbers, size_t i)
{
    (void)numbers;
    (void)i;
    return 1;
}

static bool is_small(int64_t z)
{
    int64_t most = (int64_t)1 << FMB_SMALL_BITS;
    return -most < z && z < most;
}

static bool multiply_integer(const void *numbers, size_t i, uint64_t factor, int64_t *out)
{
    int64_t z = ((const int64_t *)numbers)[i];
    return !__builtin_mul_overflow(z, (int64_t)factor, out) && is_small(*out);
}

static void get_integer(mpq_t q, const void *numbers, size_t i)
{
    fmb_integer_set_i64(mpq_numref(q), ((const int64_t *)numbers)[i]);
    mpz_set_ui(mpq_denref(q), 1);
}

static const char *no_rational(const void *numbers, size_t i, char buf[FMB_WRONG_NUMBER])
{
    (void)buf;
    return mpz_sgn(mpq_denref(((const mpq_t *)numbers)[i])) ? NULL : "has denominator 0";
}

static bool is_zero_rational(const void *numbers, size_t i)
{
    return mpz_sgn(mpq_numref(((const mpq_t *)numbers)[i])) == 0;
}

static bool is_word(mpz_srcptr z)
{
    return mpz_sizeinbase(z, 2) <= FMB_SMALL_BITS;
}

/* 0 also for a number that is not in lowest terms. */
static uint64_t rational_denominator(const void *numbers, size_t i)
{
    mpq_srcptr q = ((const mpq_t *)numbers)[i];
    if (mpz_cmp_ui(mpq_denref(q), 1) == 0)
        return 1;
    if (mpz_sgn(mpq_denref(q)) < 0 || !is_word(mpq_denref(q)) || !is_word(mpq_numref(q)))
        return 0;
    uint64_t den = (uint64_t)fmb_integer_get_i64(mpq_denref(q));
    return fmb_gcd64(fmb_abs64(fmb_integer_get_i64(mpq_numref(q))), den) == 1 ? den : 0;
}

static bool multiply_rational(const void *numbers, size_t i, uint64_t factor, int64_t *out)
{
    mpq_srcptr q = ((const mpq_t *)numbers)[i];
    if (!is_word(mpq_numref(q)))
        return false;
    int64_t z = fmb_integer_get_i64(mpq_numref(q));
    if (factor > 1 && mpz_cmp_ui(mpq_denref(q), 1) != 0)
        factor /= (uint64_t)fmb_integer_get_i64(mpq_denref(q));
    return !__builtin_mul_overflow(z, (int64_t)factor, out) && is_small(*out);
}

/* GMP needs lowest terms and a positive denominator even for copying; the caller's numbers may lack
 * both. */
static void get_rational(mpq_t q, const void *numbers, size_t i)
{
    mpq_srcptr from = ((const mpq_t *)numbers)[i];
    mpz_set(mpq_numref(q), mpq_numref(from));
    mpz_set(mpq_denref(q), mpq_denref(from));
    mpq_canonicalize(q);
}

const fmb_number_kind fmb_doubles = {no_double, is_zero_double, double_denominator, multiply_double,
                                     get_double};
const fmb_number_kind fmb_integers = {no_integer, is_zero_integer, integer_denominator,
                                      multiply_integer, get_integer};
const fmb_number_kind fmb_given_rationals = {no_rational, is_zero_rational, rational_denominator,
                                             multiply_rational, get_rational};
