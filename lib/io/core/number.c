/* number.c: exact numbers from text; see number.h.
 *
 * Nothing passes through a double, and no step costs more than a few multiplications of numbers as
 * long as the text itself: powers of ten are cancelled by removing twos and fives.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/core/cursor.h"
#include "io/core/number.h"
#include "io/core/short_decimal.h"
#include "num/rationals.h"
#include <float.h>
#include <math.h>

/* Digits that an exponent may add to those written. */
#define EXPONENT_MAX 100000

/* Digits [p, dot) and (dot, end), dot == end if there is no point. */
typedef struct decimal {
    const char *p, *dot, *end;
    size_t digits;
    const char *e; /* the 'e', or NULL */
    long exponent; /* clipped to +-(EXPONENT_MAX + 1) */
} decimal;

static int byte_ahead(const fmb_cursor *c, size_t ahead)
{
    return (size_t)(c->end - c->at) > ahead ? (unsigned char)c->at[ahead] : -1;
}

static size_t skip_decimal_digits(fmb_cursor *c)
{
    const char *p = c->at;
    while (fmb_is_digit(fmb_peek(c)))
        c->at++;
    return (size_t)(c->at - p);
}

/* An exponent, if digits follow the e. */
static void scan_exponent(fmb_cursor *c, int flags, decimal *d)
{
    int letter = fmb_peek(c) | 32;
    if (fmb_peek(c) < 0 || (letter != 'e' && !(letter == 'd' && flags & FMB_NUM_FORTRAN)))
        return;
    bool has_sign = byte_ahead(c, 1) == '+' || byte_ahead(c, 1) == '-';
    if (!fmb_is_digit(byte_ahead(c, has_sign ? 2 : 1)))
        return;
    bool minus = byte_ahead(c, 1) == '-';
    d->e = c->at;
    c->at += has_sign ? 2 : 1;
    for (; fmb_is_digit(fmb_peek(c)); c->at++)
        if (d->exponent <= EXPONENT_MAX)
            d->exponent = 10 * d->exponent + (*c->at - '0');
    if (d->exponent > EXPONENT_MAX)
        d->exponent = EXPONENT_MAX + 1;
    if (minus)
        d->exponent = -d->exponent;
}

/* False, with c unchanged, if there is no number at c. */
static bool scan_unsigned_decimal(fmb_cursor *c, int flags, decimal *d)
{
    *d = (decimal){.p = c->at};
    d->digits = skip_decimal_digits(c);
    d->dot = c->at;
    if (flags & FMB_NUM_DECIMAL && fmb_peek(c) == '.') {
        c->at++;
        d->digits += skip_decimal_digits(c);
    }
    d->end = c->at;
    if (d->digits == 0) {
        c->at = d->p;
        return false;
    }
    if (flags & FMB_NUM_EXPONENT)
        scan_exponent(c, flags, d);
    return true;
}

/* All digits as one integer z, and the power of ten that it is multiplied by. If the power is
 * negative, trailing zeros of z are cancelled against it: then ten does not divide z. */
static fmb_status join_decimal_digits(const decimal *d, fmb_mem *mem, mpz_t z, long *power)
{
    char small[64], *text = small;
    if (d->digits >= sizeof small && !(text = fmb_mem_get(mem, d->digits + 1, 1)))
        return fmb_mem_status(mem);
    size_t before = (size_t)(d->dot - d->p), n = d->digits;
    memcpy(text, d->p, before);
    if (n > before)
        memcpy(text + before, d->dot + 1, n - before);
    *power = d->exponent - (long)(n - before);
    for (; *power < 0 && n > 1 && text[n - 1] == '0'; n--)
        ++*power;
    text[n] = '\0';
    mpz_set_str(z, text, 10);
    if (text != small)
        fmb_mem_put(mem, text, d->digits + 1, 1);
    return FMB_OK;
}

/* z = z / 5^f with the largest f <= k, which is returned. */
static unsigned long divide_out_fives(mpz_t z, unsigned long k)
{
    mpz_t five;
    mpz_init_set_ui(five, 5);
    unsigned long f = mpz_remove(z, z, five);
    if (f > k) {
        mpz_ui_pow_ui(five, 5, f - k);
        mpz_mul(z, z, five);
        f = k;
    }
    mpz_clear(five);
    return f;
}

/* q = z 10^power, where ten does not divide z if power < 0. As 10^k = 2^k 5^k and only one of the
 * primes 2 and 5 can divide z, the fraction is canonical once that prime is cancelled. */
static void scale_by_power_of_ten(mpq_t q, long power)
{
    mpz_ptr z = mpq_numref(q), den = mpq_denref(q);
    unsigned long k = (unsigned long)(power < 0 ? -power : power);
    if (power >= 0) {
        mpz_ui_pow_ui(den, 5, k);
        mpz_mul(z, z, den);
        mpz_mul_2exp(z, z, k);
        mpz_set_ui(den, 1);
        return;
    }
    unsigned long twos = mpz_scan1(z, 0);
    twos = twos < k ? twos : k;
    mpz_fdiv_q_2exp(z, z, twos);
    unsigned long fives = divide_out_fives(z, k);
    mpz_ui_pow_ui(den, 5, k - fives);
    mpz_mul_2exp(den, den, k - twos);
}

static fmb_status value_of_decimal(fmb_cursor *c, const decimal *d, mpq_t out)
{
    long power = 0;
    mpz_set_ui(mpq_denref(out), 1);
    FMB_TRY(join_decimal_digits(d, c->mem, mpq_numref(out), &power));
    if (mpq_sgn(out) == 0)
        return FMB_OK;
    long grow = d->exponent < 0 ? -d->exponent : d->exponent;
    if (grow > EXPONENT_MAX)
        return fmb_io_fail(c, d->e, "expected an exponent between -%d and %d", EXPONENT_MAX,
                           EXPONENT_MAX);
    FMB_TRY(fmb_io_charge(c, d->p, (size_t)grow));
    if (power != 0)
        scale_by_power_of_ten(out, power);
    return FMB_OK;
}

/* Read the denominator after '/', if there is a number. */
static fmb_status scan_denominator(fmb_cursor *c, int flags, mpq_t out)
{
    const char *slash = c->at;
    decimal d;
    if (fmb_peek(c) != '/')
        return FMB_OK;
    c->at++;
    if (!scan_unsigned_decimal(c, flags, &d)) {
        c->at = slash;
        return FMB_OK;
    }
    mpq_t q;
    mpq_init(q);
    fmb_status st = value_of_decimal(c, &d, q);
    if (st == FMB_OK && mpq_sgn(q) == 0)
        st = fmb_io_fail(c, d.p, "expected a denominator other than zero");
    if (st == FMB_OK)
        mpq_div(out, out, q);
    mpq_clear(q);
    return st;
}

/* Read a number of few digits, as nearly all are; false, with c unchanged, if it may be none. */
static bool scan_short_number(fmb_cursor *c, int flags, mpq_t out)
{
    const int all = FMB_NUM_SIGN | FMB_NUM_DECIMAL | FMB_NUM_EXPONENT;
    const char *start = c->at;
    fmb_short_decimal d;
    bool exact;
    if ((flags & all) == all && fmb_scan_short_decimal(c, false, &d) &&
        !(flags & FMB_NUM_FRACTION && fmb_peek(c) == '/') &&
        !(flags & FMB_NUM_FORTRAN && (fmb_peek(c) | 32) == 'd') &&
        (size_t)abs(d.exponent) <= c->budget && fmb_short_decimal_value(&d, out, &exact)) {
        c->budget -= (size_t)abs(d.exponent);
        return true;
    }
    c->at = start;
    return false;
}

fmb_status fmb_scan_number(fmb_cursor *c, int flags, const char *what, mpq_t out)
{
    const char *start = c->at;
    bool minus = false;
    decimal d;
    if (scan_short_number(c, flags, out))
        return FMB_OK;
    if (flags & FMB_NUM_SIGN && (fmb_peek(c) == '-' || fmb_peek(c) == '+')) {
        minus = fmb_peek(c) == '-';
        c->at++;
    }
    if (!scan_unsigned_decimal(c, flags, &d)) {
        c->at = start;
        return fmb_io_expected(c, start, "%s", what);
    }
    FMB_TRY(value_of_decimal(c, &d, out));
    if (flags & FMB_NUM_FRACTION)
        FMB_TRY(scan_denominator(c, flags, out));
    if (minus)
        mpq_neg(out, out);
    return FMB_OK;
}

fmb_status fmb_scan_count(fmb_cursor *c, size_t max, const char *what, size_t *out)
{
    const char *start = c->at;
    size_t n = 0;
    for (; fmb_is_digit(fmb_peek(c)); c->at++) {
        size_t digit = (size_t)(*c->at - '0');
        if (n > max / 10 || digit > max - 10 * n)
            return fmb_io_expected(c, start, "%s of at most %zu", what, max);
        n = 10 * n + digit;
    }
    if (c->at == start)
        return fmb_io_expected(c, start, "%s", what);
    *out = n;
    return FMB_OK;
}

void fmb_print_q(FILE *out, mpq_srcptr q)
{
    mpq_out_str(out, 10, q);
}

double fmb_io_nearest(mpq_srcptr q, bool *exact)
{
    double x = fmb_nearest_double(q);
    mpz_srcptr den = mpq_denref(q);
    mpq_t back;
    *exact = false;
    if (!isfinite(x) || (fabs(x) < DBL_MAX && mpz_scan1(den, 0) + 1 < mpz_sizeinbase(den, 2)))
        return x;
    mpq_init(back);
    mpq_set_d(back, x);
    int beyond = mpq_cmp(q, back) * mpq_sgn(q);
    mpq_clear(back);
    *exact = beyond == 0;
    return beyond > 0 && fabs(x) == DBL_MAX ? copysign(INFINITY, x) : x;
}

fmb_status fmb_scan_nearest(fmb_cursor *c, const char *what, double *out)
{
    const char *p = c->at;
    fmb_short_decimal d;
    bool exact;
    mpq_t q;
    if (fmb_scan_short_decimal(c, false, &d) && fmb_short_decimal_nearest(&d, out))
        return FMB_OK;
    c->at = p;
    mpq_init(q);
    fmb_status st = fmb_scan_number(c, FMB_NUM_SIGN | FMB_NUM_DECIMAL | FMB_NUM_EXPONENT, what, q);
    double x = st == FMB_OK ? fmb_io_nearest(q, &exact) : 0;
    mpq_clear(q);
    if (st == FMB_OK && !isfinite(x))
        return fmb_io_fail(c, p, "expected a number that is not beyond all doubles");
    if (st == FMB_OK)
        *out = x;
    return st;
}
