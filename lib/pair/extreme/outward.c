/* outward.c: see outward.h. */
#include "pair/extreme/outward.h"

/* -1, 0, 1: is x less than the fraction, equal to it, or greater? x is near it. */
static int compare_with_fraction(double x, const fmb_wide *numerator, const fmb_wide *det,
                                 int exponent)
{
    int e;
    double m = ldexp(frexp(x, &e), 53);
    fmb_wide word, left, right;
    fmb_wide_set_word(&word, (uint64_t)fabs(m));
    word.minus = m < 0;
    fmb_wide_multiply(&left, &word, det);
    fmb_wide_copy(&right, numerator);
    e += exponent - 53; /* m 2^e det against numerator */
    fmb_wide_shift(e > 0 ? &left : &right, e > 0 ? e : -e);
    return fmb_wide_compare(&left, &right);
}

bool fmb_extreme_round_outward(const fmb_wide *numerator, const fmb_wide *det, int exponent,
                               bool up, double *out)
{
    int sign = up ? 1 : -1;
    double toward = up ? HUGE_VAL : -HUGE_VAL;
    double x = ldexp(fmb_wide_to_double(numerator) / fmb_wide_to_double(det), -exponent);
    if (fmb_wide_sign(numerator) == 0) {
        *out = 0;
        return true;
    }
    if (!(fabs(x) > 0x1p-960 && fabs(x) < 0x1p960))
        return false;
    while (sign * compare_with_fraction(x, numerator, det, exponent) < 0)
        x = nextafter(x, toward);
    for (;;) {
        double in = nextafter(x, -toward);
        if (sign * compare_with_fraction(in, numerator, det, exponent) < 0)
            break;
        x = in;
    }
    *out = x;
    return true;
}
