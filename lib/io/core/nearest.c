/* nearest.c: the double nearest to a number of a text; see number.h. */
#include <math.h>
#include <string.h>

#include "io/core/chars.h"
#include "io/core/number.h"

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

/* Powers of ten that are doubles. */
static const double power_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                      1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                      1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
enum { MOST_POWER = 22 };

/* Digits that an int64 holds, whatever they are. */
enum { MOST_DIGITS = 18 };

/* Digits, perhaps with a point among them, without an exponent: z / 10^*places. False: longer ones,
 * or something else. */
static bool scan_short_decimal(const char **at, const char *end, int64_t *z, int *places)
{
    const char *p = *at, *dot = NULL;
    int digits = 0;
    for (*z = 0; p < end && (fmb_is_digit(*p) || (*p == '.' && !dot)); p++) {
        if (*p == '.') {
            dot = p;
            continue;
        }
        if (++digits > MOST_DIGITS)
            return false;
        *z = 10 * *z + (*p - '0');
    }
    *places = dot ? (int)(p - dot) - 1 : 0;
    *at = p;
    return digits > 0 && (p == end || (*p != 'e' && *p != 'E'));
}

/* Of two doubles the quotient is the one nearest to the true one (Clinger, How to read floating
 * point numbers accurately, PLDI 1990, "fast path"). */
static bool scan_quotient_of_doubles(fmb_cursor *c, double *out)
{
    const char *p = c->at;
    int64_t z;
    int places;
    bool minus = p < c->end && *p == '-';
    p += p < c->end && (*p == '-' || *p == '+');
    if (!scan_short_decimal(&p, c->end, &z, &places) || z > INT64_C(1) << 53 || places > MOST_POWER)
        return false;
    double x = (double)z / power_of_ten[places];
    c->at = p;
    *out = minus ? -x : x;
    return true;
}

fmb_status fmb_scan_nearest(fmb_cursor *c, const char *what, double *out)
{
    const char *p = c->at;
    bool exact;
    mpq_t q;
    if (scan_quotient_of_doubles(c, out))
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
