/* nearest_double.c: the double nearest to a number of a text; see number.h. */
#include <float.h>
#include <math.h>

#include "io/core/number.h"
#include "io/core/short_decimal.h"
#include "num/rationals.h"

double fmb_io_nearest(mpq_srcptr q, bool *exact)
{
    double x = fmb_nearest_double(q);
    mpq_t back;
    *exact = false;
    if (!isfinite(x))
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
