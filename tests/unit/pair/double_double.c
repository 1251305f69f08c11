/* double_double.c: sums, products and quotients of double-doubles against exact ones: errors within
 * the bounds of docs/error-bounds.md, and sometimes larger than an eighth of them. (One pair at a
 * time: products by splitting, which round most.) */
#include <gmp.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "pair/kernels/lane/double_double.h"

enum { OPERATIONS = 3, ROUNDS = 100000 };

static const char *const NAME[OPERATIONS] = {"sum", "product", "quotient"};

static uint64_t state = 1;

static uint64_t draw(void)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return state >> 11;
}

/* Of 53 bits, often all ones or few: those round worst. */
static double some_double(void)
{
    uint64_t bits = draw();
    if (draw() % 4 == 0)
        bits |= UINT64_C(0x1fffffffffffff) >> draw() % 53;
    double x = (double)(bits | 1) * 0x1p-53;
    return draw() % 2 ? x : -x;
}

/* With a lower half as large as it may be, or none. */
static lane2 some_pair(void)
{
    double hi = some_double(), lo = some_double() * hi * 0x1p-53;
    lane2 x = {lane_of(hi), lane_of(draw() % 8 ? lo : 0)};
    return two_sum(x.hi, x.lo);
}

static void value_of(lane2 x, mpq_t out)
{
    double part[2][FMB_LANES];
    mpq_t lo;
    mpq_init(lo);
    lane_store(part[0], x.hi);
    lane_store(part[1], x.lo);
    mpq_set_d(out, part[0][0]);
    mpq_set_d(lo, part[1][0]);
    mpq_add(out, out, lo);
    mpq_clear(lo);
}

/* |is - exact|, as a part of bound times |scale|. */
static double part_of(const mpq_t is, const mpq_t exact, const mpq_t scale, double bound)
{
    mpq_t off;
    mpq_init(off);
    mpq_sub(off, is, exact);
    if (mpq_sgn(off) != 0)
        mpq_div(off, off, scale);
    double part = fabs(mpq_get_d(off)) / bound;
    mpq_clear(off);
    return part;
}

static void try_one(double most[OPERATIONS])
{
    static const double bound[OPERATIONS] = {3 * 0x1p-106, 8 * 0x1p-106, 32 * 0x1p-106};
    lane2 a = some_pair(), b = some_pair();
    mpq_t x, y, is, exact, scale;
    mpq_inits(x, y, is, exact, scale, NULL);
    value_of(a, x);
    value_of(b, y);
    value_of(lane2_add(true, a, b), is);
    mpq_add(exact, x, y);
    mpq_abs(scale, x);
    mpq_abs(y, y);
    mpq_add(scale, scale, y);
    most[0] = fmax(most[0], part_of(is, exact, scale, bound[0]));
    value_of(b, y);
    value_of(lane2_times(true, a, b), is);
    mpq_mul(exact, x, y);
    most[1] = fmax(most[1], part_of(is, exact, exact, bound[1]));
    value_of(lane2_over(true, a, b, lane_of(1) / b.hi), is);
    mpq_div(exact, x, y);
    most[2] = fmax(most[2], part_of(is, exact, exact, bound[2]));
    mpq_clears(x, y, is, exact, scale, NULL);
}

int main(void)
{
    double most[OPERATIONS] = {0};
    bool good = true;
    for (int i = 0; i < ROUNDS; i++)
        try_one(most);
    for (int i = 0; i < OPERATIONS; i++) {
        printf("%-8s %.3f of the bound\n", NAME[i], most[i]);
        good &= most[i] <= 1 && most[i] > 1.0 / 8;
    }
    return good ? 0 : 1;
}
