/* last.c: the last variable of a tiny elimination; see round/squeeze.c.
 *
 * Ends are fractions b / c below 2^126, compared by products of 256 bits where they must be.
 */
#include "elim/tiny/tiny_private.h"

static bool fits_int64(fmb_i128 v)
{
    return v == (fmb_i128)(int64_t)v;
}

/* high, low = x y */
static void multiply_to_256_bits(fmb_u128 x, fmb_u128 y, fmb_u128 *high, fmb_u128 *low)
{
    fmb_u128 x0 = (uint64_t)x, x1 = x >> 64, y0 = (uint64_t)y, y1 = y >> 64;
    fmb_u128 mid = x1 * y0 + ((x0 * y0) >> 64); /* below 2^127 + 2^64 */
    fmb_u128 more = x0 * y1 + (uint64_t)mid;
    *high = x1 * y1 + (mid >> 64) + (more >> 64);
    *low = more << 64 | (uint64_t)(x0 * y0);
}

/* Sign of x y - z w, for y, w > 0. */
static int compare_products_exactly(fmb_i128 x, fmb_i128 y, fmb_i128 z, fmb_i128 w)
{
    if (fits_int64(x) && fits_int64(y) && fits_int64(z) && fits_int64(w)) {
        fmb_i128 a = x * y, b = z * w;
        return (a > b) - (a < b);
    }
    int sign = (x > 0) - (x < 0), other = (z > 0) - (z < 0);
    if (sign != other || sign == 0)
        return (sign > other) - (sign < other);
    fmb_u128 high, low, high2, low2;
    multiply_to_256_bits((fmb_u128)(x < 0 ? -x : x), (fmb_u128)y, &high, &low);
    multiply_to_256_bits((fmb_u128)(z < 0 ? -z : z), (fmb_u128)w, &high2, &low2);
    int order = high != high2 ? (high > high2) - (high < high2) : (low > low2) - (low < low2);
    return sign * order;
}

fmb_tiny_step fmb_tiny_note(fmb_tiny *t, fmb_i128 c, fmb_i128 b, bool strict)
{
    if (c == 0)
        return b < 0 || (b == 0 && strict) ? FMB_TINY_CLASH : FMB_TINY_GO;
    fmb_tiny_end *end = &t->last[c > 0];
    c = c < 0 ? -c : c;
    int order = end->known ? compare_products_exactly(b, end->c, end->b, c) : -1;
    if (order < 0 || (order == 0 && strict))
        *end = (fmb_tiny_end){.b = b, .c = c, .strict = strict, .known = true};
    return FMB_TINY_GO;
}

/* -b0 / c0 <= x <= b1 / c1 */
bool fmb_tiny_is_open(const fmb_tiny *t)
{
    const fmb_tiny_end *low = &t->last[0], *high = &t->last[1];
    if (!low->known || !high->known)
        return true;
    int order = compare_products_exactly(high->b, low->c, -low->b, high->c);
    return order > 0 || (order == 0 && !low->strict && !high->strict);
}
