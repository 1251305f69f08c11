/* outward.c: see outward.h. */
#include "pair/exact_box/outward.h"

/* |fraction| = (m + rest / unit) 2^e, 0 <= rest < unit, 2^52 <= m < 2^53: a quotient of 53 bits,
 * and its remainder. */
typedef struct quotient {
    uint64_t m;
    int e;
    fmb_wide rest, unit;
} quotient;

/* Start from a guess of m that is off by a few units, and correct it. */
static void guess_and_correct(quotient *q, const fmb_wide *numerator, const fmb_wide *det)
{
    double guess = fabs(fmb_wide_to_double(numerator) / fmb_wide_to_double(det));
    fmb_wide word, product;
    q->m = (uint64_t)ldexp(frexp(guess, &q->e), 53);
    q->e += 64 * (numerator->n - det->n) - 53;
    fmb_wide_copy(&q->rest, numerator);
    fmb_wide_copy(&q->unit, det);
    q->rest.minus = false;
    fmb_wide_shift(q->e < 0 ? &q->rest : &q->unit, q->e < 0 ? -q->e : q->e);
    fmb_wide_set_word(&word, q->m);
    fmb_wide_multiply(&product, &word, &q->unit);
    fmb_wide_subtract(&q->rest, &product);
    for (; fmb_wide_sign(&q->rest) < 0; q->m--)
        fmb_wide_add(&q->rest, &q->unit);
    for (; fmb_wide_compare(&q->rest, &q->unit) >= 0; q->m++)
        fmb_wide_subtract(&q->rest, &q->unit);
}

/* Normalize m, which is next to a power of two, to 53 bits. */
static void keep_53_bits(quotient *q)
{
    if (q->m >= UINT64_C(1) << 53) {
        if (q->m % 2 == 1)
            fmb_wide_add(&q->rest, &q->unit);
        fmb_wide_shift(&q->unit, 1);
        q->m /= 2;
        q->e++;
    } else if (q->m < UINT64_C(1) << 52) {
        fmb_wide_shift(&q->rest, 1);
        q->m *= 2;
        q->e--;
        if (fmb_wide_compare(&q->rest, &q->unit) >= 0) {
            fmb_wide_subtract(&q->rest, &q->unit);
            q->m++;
        }
    }
}

double fmb_exact_box_round_outward(const fmb_wide *numerator, const fmb_wide *det, bool up,
                                   int *exponent)
{
    quotient q;
    *exponent = 0;
    if (fmb_wide_sign(numerator) == 0)
        return 0;
    guess_and_correct(&q, numerator, det);
    keep_53_bits(&q);
    bool away = up != numerator->minus && fmb_wide_sign(&q.rest) != 0;
    double x = (double)(q.m + away);
    *exponent = q.e;
    return numerator->minus ? -x : x;
}
