/* shortest.c: doubles in few digits, as printf writes and strtod reads them. */
#include "fmb/shortest.h"

#include <criterion/criterion.h>
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void expect_as_printf(double d)
{
    char plain[32], *text = app_shortest(d);
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(plain, sizeof plain, "%.*g", digits, d);
        if (strtod(plain, NULL) == d)
            break;
    }
    cr_assert_str_eq(text, plain, "%a", d);
    free(text);
}

/* And its neighbours, and all of that negative. */
static void expect_around(double d)
{
    const double near[] = {d, nextafter(d, 0), nextafter(d, INFINITY)};
    for (int i = 0; i < 3; i++) {
        expect_as_printf(near[i]);
        expect_as_printf(-near[i]);
    }
}

static uint64_t next_random(uint64_t *state)
{
    *state = *state * 6364136223846793005 + 1442695040888963407;
    return *state >> 11;
}

Test(shortest, ends_and_zeros)
{
    const double some[] = {0, DBL_MIN, DBL_TRUE_MIN, DBL_MAX, 1e-4, 1e15, 1e16, 999999999999999.5};
    for (size_t i = 0; i < sizeof some / sizeof *some; i++)
        expect_around(some[i]);
    expect_as_printf(INFINITY);
    expect_as_printf(-INFINITY);
}

Test(shortest, powers_of_two_and_ten)
{
    for (int e = -40; e <= 70; e++)
        expect_around(ldexp(1, e));
    for (int e = -8; e <= 18; e++)
        expect_around(pow(10, e));
}

/* Halves of the last digit: ties of what is rounded. */
Test(shortest, ties)
{
    uint64_t state = 1;
    for (int i = 0; i < 20000; i++) {
        double whole = (double)(next_random(&state) >> 3 >> i % 40);
        for (int e = 0; e < 6; e++)
            expect_as_printf(ldexp(whole, -e));
    }
}

Test(shortest, any_size)
{
    uint64_t state = 2;
    for (int i = 0; i < 60000; i++) {
        double share = (double)next_random(&state) * 0x1p-53;
        expect_as_printf(ldexp(share - 0.5, (int)(next_random(&state) % 80) - 24));
    }
}

Test(shortest, few_digits)
{
    uint64_t state = 3;
    for (int i = 0; i < 20000; i++) {
        double few = (double)(next_random(&state) % 100000000);
        expect_around(few / pow(10, (double)(next_random(&state) % 12)));
    }
}
