/* wide.c: see wide.h. */
#define FMB_LANES 1
#include "pair/exact_box/wide.h"

#include "pair/kernels/lane/error_free.h"

/* to += a b in magnitude; there is room for carries. */
static void add_product_of_words(uint64_t *to, const fmb_wide *a, const fmb_wide *b)
{
    for (int i = 0; i < a->n; i++) {
        uint64_t x = a->word[i], carry = 0;
        int k = i;
        for (int j = 0; j < b->n; j++, k++) {
            fmb_u128 sum = fmb_u128_plus_word(fmb_u128_product(x, b->word[j]), to[k]);
            sum = fmb_u128_plus_word(sum, carry);
            to[k] = fmb_u128_low(sum);
            carry = fmb_u128_high(sum);
        }
        for (; carry != 0; k++) {
            to[k] += carry;
            carry = to[k] < carry;
        }
    }
}

/* out = large - small, of n words. */
static void subtract_words(fmb_wide *out, const uint64_t *large, const uint64_t *small, int n)
{
    uint64_t borrow = 0;
    for (int i = 0; i < n; i++) {
        uint64_t less = large[i] - small[i];
        out->word[i] = less - borrow;
        borrow = (large[i] < small[i]) | (less < borrow);
    }
    out->n = n;
}

/* The same where all factors have at most 62 bits, and there are at most four products: their sum
 * has less than 127. False: they are longer. */
static bool dot_of_short_factors(fmb_wide *out, int n, const fmb_wide *const *a,
                                 const fmb_wide *const *b, unsigned minus)
{
    fmb_i128 sum = fmb_i128_of(0);
    for (int i = 0; i < n; i++) {
        uint64_t x = a[i]->n > 0 ? a[i]->word[0] : 0, y = b[i]->n > 0 ? b[i]->word[0] : 0;
        if ((a[i]->n > 1) | (b[i]->n > 1) | ((x | y) >> 62 > 0))
            return false;
        fmb_i128 product = fmb_i128_of_u128(fmb_u128_product(x, y));
        bool negative = (a[i]->minus != b[i]->minus) != (minus >> i & 1);
        sum = fmb_i128_plus(sum, negative ? fmb_i128_negative(product) : product);
    }
    fmb_u128 size = fmb_i128_size(sum);
    out->word[0] = fmb_u128_low(size);
    out->word[1] = fmb_u128_high(size);
    out->n = out->word[1] > 0 ? 2 : out->word[0] > 0;
    out->minus = fmb_i128_sign(sum) < 0;
    return true;
}

/* Products are gathered by their signs; in the end one sum is taken from the other. */
void fmb_wide_dot(fmb_wide *out, int n, const fmb_wide *const *a, const fmb_wide *const *b,
                  unsigned minus)
{
    uint64_t part[2][FMB_WIDE_WORDS + 1];
    int words = 0, top;
    assert(n <= 4);
    if (dot_of_short_factors(out, n, a, b, minus))
        return;
    for (int i = 0; i < n; i++)
        if (a[i]->n > 0 && b[i]->n > 0 && a[i]->n + b[i]->n > words)
            words = a[i]->n + b[i]->n;
    assert(words <= FMB_WIDE_WORDS);
    for (int i = 0; i <= words; i++)
        part[0][i] = part[1][i] = 0;
    for (int i = 0; i < n; i++)
        if (a[i]->n > 0 && b[i]->n > 0)
            add_product_of_words(part[(a[i]->minus != b[i]->minus) != (minus >> i & 1)], a[i],
                                 b[i]);
    for (top = words; top >= 0 && part[0][top] == part[1][top]; top--)
        ;
    assert(top < FMB_WIDE_WORDS);
    out->minus = top >= 0 && part[0][top] < part[1][top];
    subtract_words(out, part[out->minus], part[!out->minus], top + 1);
    fmb_wide_trim(out);
}

const double fmb_wide_unit[FMB_WIDE_WORDS] = {0x1p0,   0x1p64,  0x1p128, 0x1p192, 0x1p256, 0x1p320,
                                              0x1p384, 0x1p448, 0x1p512, 0x1p576, 0x1p640, 0x1p704};

/* A word exactly, as the upper 53 bits and the others. */
static lane2 split_word(uint64_t word)
{
    const uint64_t low = 0x7ff;
    return (lane2){(double)(word & ~low), (double)(word & low)};
}

/* The two upper words exactly; the third is less than 2^-64 of all, what is below it 2^-128. */
double fmb_wide_to_doubles(const fmb_wide *a, double *rest)
{
    int n = a->n;
    if (n == 0)
        return *rest = 0;
    double unit = a->minus ? -fmb_wide_unit[n - 1] : fmb_wide_unit[n - 1];
    lane2 x = split_word(a->word[n - 1]), sum = two_sum(x.hi, x.lo);
    if (n > 1) {
        lane2 y = split_word(a->word[n - 2]), middle = two_sum(x.lo, y.hi * 0x1p-64);
        double third = n > 2 ? (double)a->word[n - 3] * 0x1p-64 : 0;
        sum = two_sum(x.hi, middle.hi);
        sum = two_sum(sum.hi, sum.lo + (middle.lo + (y.lo + third) * 0x1p-64));
    }
    *rest = sum.lo * unit;
    return sum.hi * unit;
}
