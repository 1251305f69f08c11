/* number_kind.c: doubles, machine integers and rationals in the arrays of a caller; see
 * number_kind.h. */
#include "system/number_kind.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

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

static size_t double_fraction_bits(const void *numbers, size_t i)
{
    int power;
    int64_t digits = (int64_t)ldexp(frexp(((const double *)numbers)[i], &power), DBL_MANT_DIG);
    int lowest = power - DBL_MANT_DIG + (digits ? __builtin_ctzll((uint64_t)digits) : 0);
    return digits && lowest < 0 ? (size_t)-lowest : 0;
}

static bool shift_double(const void *numbers, size_t i, size_t shift, int64_t *out)
{
    double x = ldexp(((const double *)numbers)[i], (int)shift);
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

static size_t integer_fraction_bits(const void *numbers, size_t i)
{
    (void)numbers;
    (void)i;
    return 0;
}

static bool shift_integer(const void *numbers, size_t i, size_t shift, int64_t *out)
{
    int64_t z = ((const int64_t *)numbers)[i], most = (int64_t)1 << FMB_SMALL_BITS;
    *out = z;
    return shift == 0 && -most < z && z < most;
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

static size_t rational_fraction_bits(const void *numbers, size_t i)
{
    return mpz_cmp_ui(mpq_denref(((const mpq_t *)numbers)[i]), 1) == 0 ? 0 : SIZE_MAX;
}

static bool shift_rational(const void *numbers, size_t i, size_t shift, int64_t *out)
{
    mpz_srcptr z = mpq_numref(((const mpq_t *)numbers)[i]);
    if (shift > 0 || mpz_sizeinbase(z, 2) > FMB_SMALL_BITS)
        return false;
    *out = fmb_integer_get_i64(z);
    return true;
}

/* GMP needs lowest terms over a positive denominator even to copy; the caller may have written
 * otherwise. */
static void get_rational(mpq_t q, const void *numbers, size_t i)
{
    mpq_srcptr from = ((const mpq_t *)numbers)[i];
    mpz_set(mpq_numref(q), mpq_numref(from));
    mpz_set(mpq_denref(q), mpq_denref(from));
    mpq_canonicalize(q);
}

const fmb_number_kind fmb_doubles = {no_double, is_zero_double, double_fraction_bits, shift_double,
                                     get_double};
const fmb_number_kind fmb_integers = {no_integer, is_zero_integer, integer_fraction_bits,
                                      shift_integer, get_integer};
const fmb_number_kind fmb_given_rationals = {no_rational, is_zero_rational, rational_fraction_bits,
                                             shift_rational, get_rational};
