/* nearest.c: the double nearest to a number of a text; see number.h. */
#include <math.h>
#include <string.h>

#include "io/core/chars.h"
#include "io/core/number.h"
#include "num/vec.h"

static bool has_odd_significand(double d)
{
    uint64_t bits;
    memcpy(&bits, &d, sizeof bits);
    return bits & 1;
}

/* mpq_get_d cuts towards zero, so the answer is that or the next one outward. */
double fmb_io_nearest(mpq_srcptr q, bool *exact)
{
    double in = mpq_get_d(q), out = nextafter(in, mpq_sgn(q) < 0 ? -INFINITY : INFINITY);
    int beyond = 1;
    mpq_t a, b;
    *exact = false;
    if (!isfinite(in))
        return in;
    mpq_inits(a, b, NULL);
    mpq_set_d(a, in);
    *exact = mpq_equal(a, q) != 0;
    if (!*exact && isfinite(out)) {
        mpq_set_d(b, out);
        mpq_add(a, a, b);
        mpq_div_2exp(a, a, 1);
        beyond = mpq_cmp(q, a) * mpq_sgn(q);
    }
    mpq_clears(a, b, NULL);
    return !*exact && (beyond > 0 || (beyond == 0 && has_odd_significand(in))) ? out : in;
}

/* ---- from text ------------------------------------------------------------------------------- */

/* z 10^power, z of at most 19 digits. */
typedef struct short_decimal {
    uint64_t z;
    int power;
} short_decimal;

enum { MOST_DIGITS = 19, MOST_POWER = 27 };

/* 5^27 is the largest that 64 bits hold. */
static const uint64_t power_of_five[MOST_POWER + 1] = {1,
                                                       5,
                                                       25,
                                                       125,
                                                       625,
                                                       3125,
                                                       15625,
                                                       78125,
                                                       390625,
                                                       1953125,
                                                       9765625,
                                                       48828125,
                                                       244140625,
                                                       1220703125,
                                                       6103515625,
                                                       30517578125,
                                                       152587890625,
                                                       762939453125,
                                                       3814697265625,
                                                       19073486328125,
                                                       95367431640625,
                                                       476837158203125,
                                                       2384185791015625,
                                                       11920928955078125,
                                                       59604644775390625,
                                                       298023223876953125,
                                                       1490116119384765625,
                                                       7450580596923828125};

/* An exponent of at most three digits, if one is here. */
static bool scan_short_exponent(const char **at, const char *end, int *power)
{
    const char *p = *at + 1;
    if (*at == end || (**at | 32) != 'e')
        return true;
    bool minus = p < end && *p == '-';
    p += p < end && (*p == '-' || *p == '+');
    const char *first = p;
    int exponent = 0;
    for (; p < end && fmb_is_digit(*p) && p - first < 4; p++)
        exponent = 10 * exponent + (*p - '0');
    *power += minus ? -exponent : exponent;
    *at = p;
    return p > first && p - first < 4;
}

/* False: a longer one, or something else. */
static bool scan_short_decimal(const char **at, const char *end, short_decimal *out)
{
    const char *p = *at, *dot = NULL;
    int digits = 0;
    for (out->z = 0; p < end && (fmb_is_digit(*p) || (*p == '.' && !dot)); p++) {
        if (*p == '.') {
            dot = p;
            continue;
        }
        if (out->z > 0 && ++digits >= MOST_DIGITS)
            return false;
        out->z = 10 * out->z + (uint64_t)(*p - '0');
    }
    out->power = dot ? 1 - (int)(p - dot) : 0;
    bool any = p - *at > (dot != NULL);
    *at = p;
    return any && scan_short_exponent(at, end, &out->power);
}

/* q 2^e rounded to the nearest double, ties to even; `more`: the number is a little larger than q,
 * which then has more than 54 bits. It is neither tiny nor huge. */
static double round_to_double(fmb_u128 q, bool more, int e)
{
    uint64_t high = (uint64_t)(q >> 64);
    int bits = high > 0 ? 128 - __builtin_clzll(high) : 64 - __builtin_clzll((uint64_t)q);
    int drop = bits - 53;
    if (drop <= 0)
        return ldexp((double)(uint64_t)q, e);
    fmb_u128 half = (fmb_u128)1 << (drop - 1), rest = q & (2 * half - 1);
    uint64_t m = (uint64_t)(q >> drop);
    m += rest > half || (rest == half && (more || (m & 1)));
    return ldexp((double)m, e + drop);
}

/* Exactly rounded: 10^k is 2^k 5^k, and a quotient of 127 bits by 63, or a product of 64 by 63, has
 * all bits that matter. */
static bool nearest_to_short_decimal(const short_decimal *d, double *out)
{
    int k = d->power < 0 ? -d->power : d->power;
    *out = 0;
    if (d->z == 0 || k > MOST_POWER)
        return d->z == 0;
    if (d->power >= 0) {
        *out = round_to_double((fmb_u128)d->z * power_of_five[k], false, k);
        return true;
    }
    int shift = 63 + __builtin_clzll(d->z);
    fmb_u128 z = (fmb_u128)d->z << shift, q = z / power_of_five[k];
    *out = round_to_double(q, q * power_of_five[k] != z, -shift - k);
    return true;
}

bool fmb_scan_short_nearest(fmb_cursor *c, const char *end, double *out)
{
    const char *p = c->at;
    short_decimal d;
    bool minus = p < end && *p == '-';
    p += p < end && (*p == '-' || *p == '+');
    if (!scan_short_decimal(&p, end, &d) || !nearest_to_short_decimal(&d, out))
        return false;
    c->at = p;
    *out = minus ? -*out : *out;
    return true;
}

fmb_status fmb_scan_nearest(fmb_cursor *c, const char *what, double *out)
{
    const char *p = c->at;
    bool exact;
    mpq_t q;
    if (fmb_scan_short_nearest(c, c->end, out))
        return FMB_OK;
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
