/* tiny_last.c: the last variable of a tiny elimination; see round/squeeze.c.
 *
 * Ends are fractions b / c below 2^126, compared by products of 256 bits where they must be.
 */
#include "elim/tiny/tiny_private.h"

/* high, low = x y */
static void multiply_to_256_bits(fmb_u128 x, fmb_u128 y, fmb_u128 *high, fmb_u128 *low)
{
    uint64_t x0 = fmb_u128_low(x), x1 = fmb_u128_high(x), y0 = fmb_u128_low(y),
             y1 = fmb_u128_high(y);
    fmb_u128 least = fmb_u128_product(x0, y0);
    fmb_u128 mid =
        fmb_u128_plus_product(fmb_u128_of(fmb_u128_high(least)), x1, y0); /* below 2^127 + 2^64 */
    fmb_u128 more = fmb_u128_plus_product(fmb_u128_of(fmb_u128_low(mid)), x0, y1);
    *high = fmb_u128_plus_product(fmb_u128_of(fmb_u128_high(mid)), x1, y1);
    *high = fmb_u128_plus_word(*high, fmb_u128_high(more));
    *low = fmb_u128_join(fmb_u128_low(more), fmb_u128_low(least));
}

/* Sign of x y - z w, for y, w > 0. */
static int compare_products_exactly(fmb_i128 x, fmb_i128 y, fmb_i128 z, fmb_i128 w)
{
    if (fmb_i128_is_word(x) && fmb_i128_is_word(y) && fmb_i128_is_word(z) && fmb_i128_is_word(w))
        return fmb_i128_compare(fmb_i128_product(fmb_i128_low(x), fmb_i128_low(y)),
                                fmb_i128_product(fmb_i128_low(z), fmb_i128_low(w)));
    int sign = fmb_i128_sign(x), other = fmb_i128_sign(z);
    if (sign != other || sign == 0)
        return (sign > other) - (sign < other);
    fmb_u128 high, low, high2, low2;
    multiply_to_256_bits(fmb_i128_size(x), fmb_u128_of_i128(y), &high, &low);
    multiply_to_256_bits(fmb_i128_size(z), fmb_u128_of_i128(w), &high2, &low2);
    int order = fmb_u128_compare(high, high2);
    return sign * (order != 0 ? order : fmb_u128_compare(low, low2));
}

fmb_tiny_step fmb_tiny_note(fmb_tiny *t, fmb_i128 c, fmb_i128 b, bool strict, uint64_t history)
{
    int side = fmb_i128_sign(c), room = fmb_i128_sign(b);
    if (side == 0) {
        t->clash = history;
        return room < 0 || (room == 0 && strict) ? FMB_TINY_CLASH : FMB_TINY_GO;
    }
    fmb_tiny_end *end = &t->last[side > 0];
    c = side < 0 ? fmb_i128_negative(c) : c;
    int order = end->known ? compare_products_exactly(b, end->c, end->b, c) : -1;
    if (order < 0 || (order == 0 && strict))
        *end = (fmb_tiny_end){.b = b, .c = c, .history = history, .strict = strict, .known = true};
    return FMB_TINY_GO;
}

/* -b0 / c0 <= x <= b1 / c1 */
fmb_tiny_step fmb_tiny_compare_ends(fmb_tiny *t)
{
    const fmb_tiny_end *low = &t->last[0], *high = &t->last[1];
    if (!low->known || !high->known)
        return FMB_TINY_GO;
    int order = compare_products_exactly(high->b, low->c, fmb_i128_negative(low->b), high->c);
    t->clash = low->history | high->history;
    return order > 0 || (order == 0 && !low->strict && !high->strict) ? FMB_TINY_GO
                                                                      : FMB_TINY_CLASH;
}
