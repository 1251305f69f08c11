/* short_decimal.c: see short_decimal.h.
 *
 * 10^k = 2^k 5^k, and 5^27 is the largest power of five that fits 64 bits: up to it a decimal is a
 * product or a quotient of machine words. A quotient is first approximated by the reciprocal of its
 * denominator, which gives the nearest double in all but a few of a thousand cases.
 *
 * Sources: Clinger 1990 (doi 10.1145/93542.93557), where both numbers are doubles; Lemire 2021
 * (doi 10.1002/spe.2984), reciprocals.
 */
#include "io/core/short_decimal.h"

#include <string.h>

#include "io/core/cursor.h"
#include "num/vec.h"

enum { MOST_DIGITS = 19, MOST_WRITTEN_POWER = 1000, MOST_POWER = 27, MOST_DOUBLE_POWER = 22 };

/* A power of five, and its reciprocal: `inverse` 2^(1 - 64 - bits) rounded down, where 5^k has so
 * many bits. */
static const struct power_of_five {
    uint64_t value, inverse;
    int bits;
} power_of_five[MOST_POWER + 1] = {{1, 0, 1},
                                   {5, 0xcccccccccccccccc, 3},
                                   {25, 0xa3d70a3d70a3d70a, 5},
                                   {125, 0x83126e978d4fdf3b, 7},
                                   {625, 0xd1b71758e219652b, 10},
                                   {3125, 0xa7c5ac471b478423, 12},
                                   {15625, 0x8637bd05af6c69b5, 14},
                                   {78125, 0xd6bf94d5e57a42bc, 17},
                                   {390625, 0xabcc77118461cefc, 19},
                                   {1953125, 0x89705f4136b4a597, 21},
                                   {9765625, 0xdbe6fecebdedd5be, 24},
                                   {48828125, 0xafebff0bcb24aafe, 26},
                                   {244140625, 0x8cbccc096f5088cb, 28},
                                   {1220703125, 0xe12e13424bb40e13, 31},
                                   {6103515625, 0xb424dc35095cd80f, 33},
                                   {30517578125, 0x901d7cf73ab0acd9, 35},
                                   {152587890625, 0xe69594bec44de15b, 38},
                                   {762939453125, 0xb877aa3236a4b449, 40},
                                   {3814697265625, 0x9392ee8e921d5d07, 42},
                                   {19073486328125, 0xec1e4a7db69561a5, 45},
                                   {95367431640625, 0xbce5086492111aea, 47},
                                   {476837158203125, 0x971da05074da7bee, 49},
                                   {2384185791015625, 0xf1c90080baf72cb1, 52},
                                   {11920928955078125, 0xc16d9a0095928a27, 54},
                                   {59604644775390625, 0x9abe14cd44753b52, 56},
                                   {298023223876953125, 0xf79687aed3eec551, 59},
                                   {1490116119384765625, 0xc612062576589dda, 61},
                                   {7450580596923828125, 0x9e74d1b791e07e48, 63}};

static const double power_of_ten[MOST_DOUBLE_POWER + 1] = {
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/* ---- digits ---------------------------------------------------------------------------------- */

/* The first one in the lowest byte. */
static inline uint64_t load_eight_bytes(const char *p)
{
    const unsigned char *b = (const unsigned char *)p;
    return (uint64_t)b[0] | (uint64_t)b[1] << 8 | (uint64_t)b[2] << 16 | (uint64_t)b[3] << 24 |
           (uint64_t)b[4] << 32 | (uint64_t)b[5] << 40 | (uint64_t)b[6] << 48 |
           (uint64_t)b[7] << 56;
}

/* How many of eight bytes, from the lowest on, are '0' to '9', which is 0x30 to 0x39: seven bits
 * that differ from 0x30 by more than 9 reach 0x80 when 0x76 is added, and no byte carries. */
static inline int count_digits_in_front(uint64_t w)
{
    const uint64_t each = 0x0101010101010101;
    uint64_t x = w ^ 0x30 * each, other = (((x & 0x7f * each) + 0x76 * each) | x) & 0x80 * each;
    return other ? __builtin_ctzll(other) / 8 : 8;
}

/* Eight digits, the first one in the lowest byte: neighbours become numbers of two, of four, of
 * eight digits. Bytes that are 0 are zeros. */
static inline uint64_t join_eight_digits(uint64_t w)
{
    w &= 0x0f0f0f0f0f0f0f0f;
    w = (10 * w + (w >> 8)) & 0x00ff00ff00ff00ff;
    w = (100 * w + (w >> 16)) & 0x0000ffff0000ffff;
    return (10000 * w + (w >> 32)) & 0xffffffff;
}

/* Append the digits at p to the decimal *z, modulo 2^64; returns their end. */
static inline const char *append_digits(const char *p, const char *end, uint64_t *z)
{
    static const uint64_t shifted[9] = {1,      10,      100,      1000,     10000,
                                        100000, 1000000, 10000000, 100000000};
    while (end - p >= 8) {
        uint64_t w = load_eight_bytes(p);
        int n = count_digits_in_front(w);
        if (n > 0)
            *z = *z * shifted[n] + join_eight_digits(w << (64 - 8 * n));
        p += n;
        if (n < 8)
            return p;
    }
    for (; p < end && fmb_is_digit(*p); p++)
        *z = 10 * *z + (uint64_t)(*p - '0');
    return p;
}

/* Of `written` digits from p on, are all but the last `most` leading zeros? */
static bool are_others_zeros(const char *p, ptrdiff_t written, ptrdiff_t most)
{
    for (; written > most && (*p == '0' || *p == '.'); p++)
        written -= *p == '0';
    return written <= most;
}

/* ---- a number -------------------------------------------------------------------------------- */

/* An exponent of at most three digits, if one is here. */
static bool scan_short_exponent(const char **at, const char *end, int *out)
{
    const char *p = *at + 1;
    if (*at == end || (**at | 32) != 'e')
        return true;
    bool minus = p < end && *p == '-';
    p += p < end && (*p == '-' || *p == '+');
    const char *first = p;
    int exponent = 0;
    for (; p < end && fmb_is_digit(*p) && p - first < 4; p++)
        exponent = 10 * exponent + (*p - '0');
    *out = minus ? -exponent : exponent;
    *at = p;
    return p > first && p - first < 4;
}

/* Append the first digits; mostly there is one digit before the point. */
static inline const char *append_first_digits(const char *p, const char *end, uint64_t *z)
{
    if (end - p < 2 || p[1] != '.' || !fmb_is_digit(*p))
        return append_digits(p, end, z);
    *z = (uint64_t)(*p - '0');
    return p + 1;
}

/* Digits, and perhaps a point between them. */
static bool scan_short_digits(const char **at, const char *end, bool strictly,
                              fmb_short_decimal *out)
{
    const char *first = *at, *dot = append_first_digits(first, end, &out->z), *p = dot;
    ptrdiff_t before = dot - first, behind = 0;
    bool has_point = p < end && *p == '.';
    if (has_point) {
        p = append_digits(dot + 1, end, &out->z);
        behind = p - dot - 1;
    }
    *at = p;
    if (strictly && (before == 0 || (before > 1 && *first == '0') || (has_point && behind == 0)))
        return false;
    if (before + behind == 0 || behind > MOST_WRITTEN_POWER ||
        !are_others_zeros(first, before + behind, MOST_DIGITS))
        return false;
    out->power = (int)-behind;
    return true;
}

bool fmb_scan_short_decimal(fmb_cursor *c, bool strictly, fmb_short_decimal *out)
{
    const char *p = c->at;
    int sign = p < c->end ? *p : 0;
    *out = (fmb_short_decimal){.minus = sign == '-'};
    p += out->minus | (!strictly & (sign == '+'));
    if (!scan_short_digits(&p, c->end, strictly, out) ||
        !scan_short_exponent(&p, c->end, &out->exponent))
        return false;
    out->power += out->exponent;
    c->at = p;
    return true;
}

/* ---- as a double ----------------------------------------------------------------------------- */

/* m 2^e, m at most 2^53, which is neither tiny nor huge. */
static inline double scale_by_power_of_two(uint64_t m, int e)
{
    uint64_t bits = (uint64_t)(e + 1023) << 52;
    double power;
    memcpy(&power, &bits, sizeof power);
    return (double)m * power;
}

/* q 2^e rounded to the nearest double, ties to even; `more`: the number is a little larger than q,
 * which then has more than 54 bits. It is neither tiny nor huge. */
static double round_to_double(fmb_u128 q, bool more, int e)
{
    const fmb_u128 one = fmb_u128_of(1);
    int drop = fmb_u128_bits(q) - 53;
    if (drop <= 0)
        return scale_by_power_of_two(fmb_u128_low(q), e);
    fmb_u128 half = fmb_u128_left(one, drop - 1), unit = fmb_u128_left(one, drop);
    int order = fmb_u128_compare(fmb_u128_and(q, fmb_u128_minus(unit, one)), half);
    uint64_t m = fmb_u128_low(fmb_u128_right(q, drop));
    m += order > 0 || (order == 0 && (more || (m & 1)));
    return scale_by_power_of_two(m, e + drop);
}

/* z 10^-k, z > 0, exactly rounded: a quotient of 127 bits by 63 has all bits that matter. */
static double divide_by_power_of_ten(uint64_t z, int k)
{
    int shift = 63 + __builtin_clzll(z);
    fmb_u128 rest, power = fmb_u128_of(power_of_five[k].value);
    fmb_u128 q = fmb_u128_divide(fmb_u128_left(fmb_u128_of(z), shift), power, &rest);
    return round_to_double(q, !fmb_u128_is_zero(rest), -shift - k);
}

/* z 10^-k by the reciprocal r = inverse 2^(1 - 64 - bits), r <= 5^-k < r + 2^(1 - 64 - bits). With
 * z shifted so that its highest bit is set, high 2^64 <= z inverse < (high + 1) 2^64, and the exact
 * inverse is less than 1 larger: in units of 2^64 the exact product lies in [high, high + 2). False
 * if the numbers of this interval do not all have the same nearest double. */
static inline bool multiply_by_reciprocal(uint64_t z, int k, double *out)
{
    const struct power_of_five *five = &power_of_five[k];
    int shift = __builtin_clzll(z);
    uint64_t high = fmb_u128_high(fmb_u128_product(z << shift, five->inverse));
    int drop = 11 - __builtin_clzll(high);
    uint64_t half = (uint64_t)1 << (drop - 1), rest = high & (2 * half - 1);
    bool up = rest > half;
    *out = scale_by_power_of_two((high >> drop) + up, drop + 1 - five->bits - shift - k);
    return rest + 2 <= half || (up & (rest + 2 <= 2 * half));
}

/* |d| of z > 0. */
static inline double nearest_to_magnitude(uint64_t z, int power)
{
    double x;
    int k = power < 0 ? -power : power;
    bool are_doubles = z <= (uint64_t)1 << 53 && k <= MOST_DOUBLE_POWER;
    if (power < 0 && multiply_by_reciprocal(z, k, &x))
        return x;
    if (power < 0)
        return are_doubles ? (double)z / power_of_ten[k] : divide_by_power_of_ten(z, k);
    return are_doubles ? (double)z * power_of_ten[k]
                       : round_to_double(fmb_u128_product(z, power_of_five[k].value), false, k);
}

bool fmb_short_decimal_nearest(const fmb_short_decimal *d, double *out)
{
    static const double sign[] = {1, -1};
    bool is_near = d->power >= -MOST_POWER && d->power <= MOST_POWER;
    if (!is_near && d->z > 0)
        return false;
    *out = (d->z > 0 ? nearest_to_magnitude(d->z, d->power) : 0) * sign[d->minus];
    return true;
}

/* ---- as a rational --------------------------------------------------------------------------- */

/* z 10^power, z > 0: of 2^k 5^k, what z has of the twos and fives is cancelled. */
static void set_magnitude(uint64_t z, int power, mpq_t out, bool *exact)
{
    int twos = __builtin_ctzll(z), fives = power < 0 ? -power : 0;
    for (; fives > 0 && z % 5 == 0; fives--)
        z /= 5;
    twos += power;
    z >>= __builtin_ctzll(z);
    mpz_ptr n = mpq_numref(out);
    fmb_integer_set_u64(n, z);
    if (power > 0)
        fmb_integer_times_u64(n, n, power_of_five[power].value);
    fmb_integer_set_u64(mpq_denref(out), power_of_five[fives].value);
    *exact = fives == 0 && mpz_sizeinbase(n, 2) <= 53;
    if (twos > 0)
        mpz_mul_2exp(n, n, (mp_bitcnt_t)twos);
    if (twos < 0)
        mpz_mul_2exp(mpq_denref(out), mpq_denref(out), (mp_bitcnt_t)-twos);
}

bool fmb_short_decimal_value(const fmb_short_decimal *d, mpq_t out, bool *exact)
{
    bool is_near = d->power >= -MOST_POWER && d->power <= MOST_POWER;
    if (!is_near && d->z > 0)
        return false;
    *exact = true;
    if (d->z == 0)
        mpq_set_ui(out, 0, 1);
    else
        set_magnitude(d->z, d->power, out, exact);
    if (d->minus)
        mpq_neg(out, out);
    return true;
}
