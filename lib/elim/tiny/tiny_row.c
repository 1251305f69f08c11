/* tiny_row.c: combinations of rows of a tiny elimination.
 *
 * Two rows whose bits add up to less than 62 can be combined directly: each product is below 2^61.
 * Others are combined in 128 bits and divided by their content.
 */
#include "elim/tiny/tiny_private.h"
#include "num/gcd.h"

static bool fits_small_bits(fmb_i128 v)
{
    return fmb_u128_is_zero(fmb_u128_right(fmb_i128_size(v), FMB_SMALL_BITS));
}

/* out = v divided by its content, found by Euclid's algorithm: slow, and rarely needed. */
static bool divide_by_content(int64_t *out, const fmb_i128 *v, int n)
{
    fmb_u128 g = fmb_u128_of(0);
    for (int k = 0; k <= n; k++) {
        fmb_u128 a = fmb_i128_size(v[k]);
        while (!fmb_u128_is_zero(a)) {
            fmb_u128 rest;
            fmb_u128_divide(g, a, &rest);
            g = a;
            a = rest;
        }
    }
    bool divides = fmb_u128_is_less(fmb_u128_of(1), g);
    for (int k = 0; k <= n; k++) {
        fmb_i128 quotient = divides ? fmb_i128_quotient(v[k], fmb_i128_of_u128(g)) : v[k];
        if (!fits_small_bits(quotient))
            return false;
        out[k] = fmb_i128_low(quotient);
    }
    return true;
}

/* out = f p + g q in 128 bits, divided by its content; false if it does not fit. */
static bool combine_in_128_bits(const fmb_tiny *t, int64_t *out, int p, int q, int64_t f, int64_t g)
{
    const int64_t *a = t->now->a[p], *b = t->now->a[q];
    fmb_i128 v[FMB_TINY_WORDS];
    for (int k = 0; k <= t->n; k++)
        v[k] = fmb_i128_plus_product(fmb_i128_product(f, a[k]), g, b[k]);
    return divide_by_content(out, v, t->n);
}

bool fmb_tiny_combine(fmb_tiny *t, int p, int q, int c)
{
    const fmb_tiny_table *now = t->now;
    fmb_tiny_table *next = t->next;
    const int64_t *a = now->a[p], *b = now->a[q];
    int64_t f = b[c], g = -a[c], *out = next->a[next->rows];
    if (now->bits[p] + now->bits[q] < FMB_SMALL_BITS) {
        for (int k = 0; k <= t->n; k++)
            out[k] = f * a[k] + g * b[k];
    } else if (!combine_in_128_bits(t, out, p, q, f, g)) {
        return false;
    }
    out[c] = out[t->n];
    uint64_t all = 0;
    for (int k = 0; k < t->n; k++)
        all |= fmb_abs64(out[k]);
    next->bits[next->rows] = (uint8_t)fmb_bits64(all);
    next->history[next->rows] = now->history[p] | now->history[q];
    next->strict[next->rows] = now->strict[p] || now->strict[q];
    return true;
}
