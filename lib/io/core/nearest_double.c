/* nearest_double.c: the double nearest to a number of a text; see number.h. */
#include <math.h>
#include <string.h>

#include "io/core/number.h"
#include "io/core/short_decimal.h"

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
