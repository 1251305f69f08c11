// counted.h: numbers that know how far they may be off; they stand in place of the lanes of
// pair/kernels/lane/lane.h, so that the kernels' own text is counted.
//
// A number is a value v, and e: what is computed is within e u of what is meant, u = 2^-53. Each
// operation adds what it inherits and its own rounding (docs/error-bounds.md). Where values are
// `majorants`, v is a bound on the absolute value: differences are sums, and a choice is the
// larger.
#ifndef FMB_TEST_COUNTED_H
#define FMB_TEST_COUNTED_H

#define FMB_PAIR_LANE_H
#define FMB_PAIR_ERROR_FREE_H
#define FMB_INLINE     static inline __attribute__((unused))
#define FMB_BOX_INLINE FMB_INLINE
#define FMB_UNROLL
#define FMB_NEVER_CLONED __attribute__((noinline))
#define FMB_LANES        1
#define FMB_LANE_FUSED   counted_fused

#include <algorithm>
#include <cmath>
#include <cstdint>

static bool counted_fused;    // products are fused with sums
static bool counted_majorant; // values are bounds
static double counted_sign;   // the error of numbers whose sign was asked for

static const double UNIT = 0x1p-53;

struct lane {
    double v, e;
};
typedef bool lane_mask;

static double size_of(lane a)
{
    return std::fabs(a.v);
}

static lane rounded(double v, double e)
{
    return {v, e + std::fabs(v) + e * UNIT};
}

static bool is_zero(lane a)
{
    return a.v == 0 && a.e == 0;
}

static bool is_power_of_two(lane a)
{
    int exponent;
    return a.e == 0 && std::fabs(std::frexp(a.v, &exponent)) == 0.5;
}

/* A product that underflows is off by half the least number, 2^-1074: in units. */
static const double UNDERFLOW = 0x1p-1022;

static double product_error(lane a, lane b)
{
    if (is_zero(a) || is_zero(b))
        return 0;
    return size_of(a) * b.e + size_of(b) * a.e + a.e * b.e * UNIT + UNDERFLOW;
}

static lane exact_product(lane a, lane b)
{
    return {a.v * b.v, product_error(a, b)};
}

static lane operator-(lane a)
{
    return {counted_majorant ? a.v : -a.v, a.e};
}

static lane operator+(lane a, lane b)
{
    if (is_zero(a) || is_zero(b))
        return is_zero(a) ? b : a;
    return rounded(a.v + b.v, a.e + b.e);
}

static lane operator-(lane a, lane b)
{
    return a + -b;
}

static lane operator*(lane a, lane b)
{
    lane p = exact_product(a, b);
    return is_power_of_two(a) || is_power_of_two(b) || is_zero(p) ? p : rounded(p.v, p.e);
}

static lane operator/(lane a, lane b)
{
    double q = a.v / b.v, least = size_of(b) - b.e * UNIT;
    return rounded(q, (a.e + std::fabs(q) * b.e) / least + UNDERFLOW);
}

FMB_INLINE lane lane_of(double a)
{
    return {counted_majorant ? (std::isinf(a) ? 0 : std::fabs(a)) : a, 0};
}

FMB_INLINE lane lane_abs(lane a)
{
    return {size_of(a), a.e};
}

FMB_INLINE lane lane_max(lane a, lane b)
{
    return {std::max(a.v, b.v), std::max(a.e, b.e)};
}

FMB_INLINE lane lane_min(lane a, lane b)
{
    return {counted_majorant ? std::max(a.v, b.v) : std::min(a.v, b.v), std::max(a.e, b.e)};
}

FMB_INLINE lane lane_max_abs(lane a, lane b)
{
    return lane_max(a, lane_abs(b));
}

FMB_INLINE lane lane_min_abs(lane a, lane b)
{
    return lane_min(a, lane_abs(b));
}

FMB_INLINE lane lane_times_sign(lane a, lane s)
{
    counted_sign = std::max(counted_sign, s.e);
    return {!counted_majorant && std::signbit(s.v) ? -a.v : a.v, a.e};
}

FMB_INLINE lane_mask lane_less(lane a, lane b)
{
    return !counted_majorant && a.v < b.v;
}

FMB_INLINE lane_mask lane_negative(lane a)
{
    return std::signbit(a.v);
}

FMB_INLINE lane lane_pick(lane_mask m, lane yes, lane no)
{
    return counted_majorant ? lane_max(yes, no) : m ? yes : no;
}

FMB_INLINE lane lane_max_where(lane_mask m, lane a, lane b)
{
    return m ? lane_max(a, b) : a;
}

FMB_INLINE unsigned lane_bits(lane_mask m)
{
    return m;
}

FMB_INLINE lane_mask lane_and(lane_mask a, lane_mask b)
{
    return a && b;
}

FMB_INLINE lane_mask lane_or(lane_mask a, lane_mask b)
{
    return a || b;
}

/* Bits are not counted: the kernel says which signs have to be certain. */
FMB_INLINE lane lane_shift_right(lane a, int)
{
    return a;
}

FMB_INLINE lane lane_with_sign(lane a, lane, int)
{
    return a;
}
FMB_INLINE lane lane_or_and(lane a, lane, lane)
{
    return a;
}

#define lane_or_xor     lane_or_and
#define lane_or_same    lane_or_and
#define lane_xor_xor    lane_or_and
#define lane_or_and_not lane_or_and
#define lane_any_bit(a) (a)
#define lane_of_bits(a) lane_of(0)

FMB_INLINE lane lane_fma(lane a, lane b, lane c)
{
    return (counted_fused ? exact_product(a, b) : a * b) + c;
}

FMB_INLINE lane lane_fms(lane a, lane b, lane c)
{
    return lane_fma(a, b, -c);
}

FMB_INLINE lane lane_fnma(lane a, lane b, lane c)
{
    return lane_fma(-a, b, c);
}

FMB_INLINE lane lane_fnms(lane a, lane b, lane c)
{
    return lane_fma(-a, b, -c);
}

/* What a number is comes from the test that includes this; it also takes what is stored. */
static lane lane_load(const double *a);
static void lane_store(double *a, lane x);

// Pairs without an error of their own (error_free.h); that of what is given is at the first.
struct lane2 {
    lane hi, lo;
};

FMB_INLINE lane2 two_sum(lane a, lane b)
{
    double s = a.v + b.v, of_b = s - a.v, of_a = s - of_b;
    return {{s, a.e + b.e}, {(a.v - of_a) + (b.v - of_b), 0}};
}

FMB_INLINE lane2 two_product(lane a, lane b)
{
    double p = a.v * b.v;
    return {{p, product_error(a, b) + 4 * UNDERFLOW}, {std::fma(a.v, b.v, -p), 0}};
}

#endif
