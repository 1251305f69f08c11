/* shortest.c: see shortest.h. Doubles from 10^-4 up to 10^15 are written in whole numbers of 128
 * bits, all others by printf.
 *
 * Let |d| = m 2^e, m of 53 bits, 10^x <= |d| < 10^(x + 1), and k = 16 - x: then |d| 10^k, which is
 * m 5^k 2^(e + k), has 17 digits in front of its point. Here -4 <= x <= 14, and x may be guessed 1
 * too small: 2 <= k <= 21, 5^k has at most 49 bits, m 5^k 102. `scaled` is |d| 10^k 2^s with
 * s = max(0, -(e + k)), an integer, and `step` what one unit of m is there. As |d| 10^k < 2^60 and
 * s <= 46, a few times `scaled` is less than 2^128.
 *
 * A decimal is read as d if it is nearer to d than to the neighbours, or just between, and m even.
 * The neighbour below a power of two is half as far away as others.
 */
#include "fmb/shortest.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/need.h"
#include "num/int128.h"

enum { FEWEST = 15, MOST = 17, ROOM = 32 };

static const uint64_t most_in_front = 100000000000000000; /* 10^17 */

/* |d| as above. */
typedef struct scaled_double {
    uint64_t m;
    fmb_u128 scaled, step;
    int s, x;
} scaled_double;

/* ---- by printf ------------------------------------------------------------------------------- */

static void print_until_read_again(double d, char *text)
{
    int digits = FEWEST;
    do
        snprintf(text, ROOM, "%.*g", digits, d);
    while (++digits <= MOST && strtod(text, NULL) != d);
}

/* ---- in whole numbers ------------------------------------------------------------------------ */

static scaled_double scale_by_power_of_ten(double size, int x)
{
    int e, k = 16 - x;
    scaled_double a = {.m = (uint64_t)ldexp(frexp(size, &e), 53), .step = fmb_u128_of(1), .x = x};
    int power = e - 53 + k;
    for (int i = 0; i < k; i++)
        a.step = fmb_u128_times(a.step, fmb_u128_of(5));
    a.s = power < 0 ? -power : 0;
    a.step = fmb_u128_left(a.step, power > 0 ? power : 0);
    a.scaled = fmb_u128_times(fmb_u128_of(a.m), a.step);
    return a;
}

/* The digits in front of the point; their number is less than 2^64. */
static uint64_t in_front(const scaled_double *a)
{
    return fmb_u128_low(fmb_u128_right(a->scaled, a->s));
}

/* With 2^b <= size < 2^(b + 1), -14 <= b <= 49, b log10 2 <= log10 size < b log10 2 + 0.302. For
 * log10 2 stands 1233 / 4096, which is less by under 2^-17; where b < 0, no b log10 2 is nearer to
 * an integer than 2^-7. So the guess is right or 1 too small. */
static scaled_double scale_double(double size)
{
    int b, whole = 64;
    frexp(size, &b);
    int x = (--b * 1233 + whole * 4096) / 4096 - whole; /* rounded down */
    scaled_double a = scale_by_power_of_ten(size, x);
    return in_front(&a) < most_in_front ? a : scale_by_power_of_ten(size, x + 1);
}

/* The nearest multiple of `unit`, ties to an even one, in front of the point. */
static uint64_t round_to_unit(const scaled_double *a, uint64_t unit)
{
    fmb_u128 each = fmb_u128_left(fmb_u128_of(unit), a->s);
    uint64_t times = in_front(a) / unit;
    fmb_u128 rest = fmb_u128_minus(a->scaled, fmb_u128_times(fmb_u128_of(times), each));
    int order = fmb_u128_compare(fmb_u128_left(rest, 1), each);
    times += order > 0 || (order == 0 && (times & 1));
    return times * unit;
}

static bool is_read_again(const scaled_double *a, uint64_t decimal)
{
    fmb_u128 there = fmb_u128_left(fmb_u128_of(decimal), a->s);
    bool below = fmb_u128_is_less(there, a->scaled), narrow = below && a->m == (uint64_t)1 << 52;
    fmb_u128 off = below ? fmb_u128_minus(a->scaled, there) : fmb_u128_minus(there, a->scaled);
    int order = fmb_u128_compare(fmb_u128_left(off, narrow ? 2 : 1), a->step);
    return order < 0 || (order == 0 && (a->m & 1) == 0);
}

/* decimal 10^(x - 16), of 17 digits, -4 <= x <= 14, without zeros behind its point. */
static void write_decimal(uint64_t decimal, int x, char *to)
{
    char digit[MOST];
    int n = MOST;
    for (int i = MOST - 1; i >= 0; i--, decimal /= 10)
        digit[i] = (char)('0' + decimal % 10);
    while (n > x + 1 && n > 1 && digit[n - 1] == '0')
        n--;
    int before = x < 0 ? 0 : x + 1;
    memcpy(to, x < 0 ? "0" : digit, x < 0 ? 1 : (size_t)before);
    to += x < 0 ? 1 : before;
    if (n > before)
        *to++ = '.';
    for (int i = -1; i > x; i--)
        *to++ = '0';
    memcpy(to, digit + before, (size_t)(n - before));
    to[n - before] = '\0';
}

static void write_scaled(const scaled_double *a, char *to)
{
    static const uint64_t unit[] = {100, 10, 1};
    uint64_t decimal = 0;
    for (int i = 0; i < 3 && (i == 0 || !is_read_again(a, decimal)); i++)
        decimal = round_to_unit(a, unit[i]);
    bool carried = decimal == most_in_front;
    write_decimal(carried ? decimal / 10 : decimal, a->x + carried, to);
}

char *app_shortest(double d)
{
    char *text = app_need(malloc(ROOM));
    double size = fabs(d);
    if (size >= 1e-4 && size < 1e15 - 1) {
        scaled_double a = scale_double(size);
        *text = '-';
        write_scaled(&a, text + (d < 0));
    } else {
        print_until_read_again(d, text);
    }
    return text;
}
