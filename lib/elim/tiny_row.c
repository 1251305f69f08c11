/* tiny_row.c: combinations of rows of a tiny elimination.
 *
 * Where a combination could pass 62 bits, it is formed in 128 and divided by a factor that it is
 * bound to have. Let r columns be gone, and the entries of p and q be minors: determinants of the
 * r + 1 rows in their histories over the gone columns and one more. If their histories have r rows
 * S in common, the combination's entries are minors of r + 2 rows times the determinant of S over
 * the gone columns (Sylvester's identity). Whether the entries are such minors is not known; so
 * each quotient is checked. Source: Bareiss 1968.
 */
#include "elim/tiny_inside.h"
#include "num/gcd.h"

/* ---- the factor ------------------------------------------------------------------------------ */

static bool fits(fmb_i128 v)
{
    return v > -((fmb_i128)1 << FMB_SMALL_BITS) && v < (fmb_i128)1 << FMB_SMALL_BITS;
}

/* The determinant of 2 rows over places c, d. */
static fmb_i128 minor2(const int64_t *x, const int64_t *y, int c, int d)
{
    return (fmb_i128)x[c] * y[d] - (fmb_i128)x[d] * y[c];
}

static fmb_i128 minor3(const int64_t *x, const int64_t *y, const int64_t *z, const int *c)
{
    fmb_i128 m0 = minor2(y, z, c[1], c[2]), m1 = minor2(y, z, c[0], c[2]),
             m2 = minor2(y, z, c[0], c[1]);
    if (!fits(m0) || !fits(m1) || !fits(m2))
        return 0;
    return x[c[0]] * m0 - x[c[1]] * m1 + x[c[2]] * m2;
}

/* The determinant of the base rows of a set over the gone columns: its absolute value, or 0 if it
 * is not known. */
static uint64_t determinant(const fmb_tiny *t, uint64_t set)
{
    const int64_t *row[3] = {NULL, NULL, NULL};
    int size = 0;
    for (; set != 0; set &= set - 1) {
        if (size == 3)
            return 0;
        row[size++] = t->base.a[__builtin_ctzll(set)];
    }
    if (size != t->since || size == 0)
        return 0;
    fmb_i128 d = size == 1   ? row[0][t->gone[0]]
                 : size == 2 ? minor2(row[0], row[1], t->gone[0], t->gone[1])
                             : minor3(row[0], row[1], row[2], t->gone);
    return fits(d) ? fmb_abs64((int64_t)d) : 0;
}

/* ---- division -------------------------------------------------------------------------------- */

/* 1 / d modulo 2^64, d odd: each step doubles the number of right bits, and d itself has three. */
static uint64_t invert(uint64_t d)
{
    uint64_t x = d;
    for (int bits = 3; bits < 64; bits *= 2)
        x *= 2 - d * x;
    return x;
}

/* out = v / d if d divides all and the quotients fit; the quotient modulo 2^64 is right if d times
 * it is v. */
static bool divide(int64_t *out, const fmb_i128 *v, int n, uint64_t d)
{
    int shift = __builtin_ctzll(d);
    uint64_t inverse = invert(d >> shift);
    for (int k = 0; k <= n; k++) {
        out[k] = (int64_t)((uint64_t)(v[k] >> shift) * inverse);
        if (!fits(out[k]) || out[k] * (fmb_i128)d != v[k])
            return false;
    }
    return true;
}

/* out = v divided by its content, found by Euclid's algorithm: slow, and rarely needed. */
static bool reduce(int64_t *out, const fmb_i128 *v, int n)
{
    fmb_i128 g = 0;
    for (int k = 0; k <= n; k++) {
        fmb_i128 a = v[k];
        while (a != 0) {
            fmb_i128 rest = g % a;
            g = a;
            a = rest;
        }
    }
    g = g < 0 ? -g : g;
    for (int k = 0; k <= n; k++) {
        fmb_i128 quotient = g > 1 ? v[k] / g : v[k];
        if (!fits(quotient))
            return false;
        out[k] = (int64_t)quotient;
    }
    return true;
}

/* ---- combinations ---------------------------------------------------------------------------- */

/* out = f p + g q in 128 bits, divided by what divides it. */
static bool combine_wide(const fmb_tiny *t, int64_t *out, int p, int q, int64_t f, int64_t g)
{
    const int64_t *a = t->now->a[p], *b = t->now->a[q];
    fmb_i128 v[FMB_TINY_WORDS];
    for (int k = 0; k <= t->n; k++)
        v[k] = (fmb_i128)f * a[k] + (fmb_i128)g * b[k];
    uint64_t d = determinant(t, t->now->history[p] & t->now->history[q]);
    if (d != 0 && divide(out, v, t->n, d))
        return true;
    return reduce(out, v, t->n);
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
    } else if (!combine_wide(t, out, p, q, f, g)) {
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
