/* decimal.c: rationals as decimals, read back and compared with what they stand for. */
#include "common/decimal.h"

#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

/* "-12.5e-3" */
static void read_decimal(const char *text, mpq_t out)
{
    size_t n = 0, behind = 0, i = text[0] == '-';
    char *digits = calloc(strlen(text) + 1, 1);
    bool point = false;
    for (; text[i] && text[i] != 'e'; i++) {
        behind += point;
        point = point || text[i] == '.';
        if (text[i] != '.')
            digits[n++] = text[i];
    }
    long power = (text[i] == 'e' ? atol(text + i + 1) : 0) - (long)behind;
    mpz_t ten;
    mpz_init(ten);
    mpz_ui_pow_ui(ten, 10, (unsigned long)labs(power));
    cr_assert_eq(mpz_set_str(mpq_numref(out), digits, 10), 0, "%s", text);
    mpz_set_ui(mpq_denref(out), 1);
    mpz_ptr part = power < 0 ? mpq_denref(out) : mpq_numref(out);
    mpz_mul(part, part, ten);
    mpq_canonicalize(out);
    if (text[0] == '-')
        mpq_neg(out, out);
    mpz_clear(ten);
    free(digits);
}

static void expect_text(const char *fraction, int digits, app_rounding way, const char *expected)
{
    mpq_t q;
    mpq_init(q);
    cr_assert_eq(mpq_set_str(q, fraction, 10), 0);
    mpq_canonicalize(q);
    char *text = app_number(q, digits, way);
    cr_assert_str_eq(text, expected, "%s", fraction);
    free(text);
    mpq_clear(q);
}

/* How many digits stand in front of the exponent, zeros at the beginning not counted. */
static size_t count_digits(const char *text)
{
    size_t n = 0;
    for (text += strspn(text, "-0."); *text && *text != 'e'; text++)
        n += *text != '.';
    return n;
}

/* Down <= q <= up, the nearest is one of both and no farther than the other; an exact one is q. */
static void expect_good(mpq_t q, int digits)
{
    mpq_t value[3], off[2];
    mpq_inits(value[0], value[1], value[2], off[0], off[1], NULL);
    bool exact[3];
    for (app_rounding way = APP_NEAREST; way <= APP_UP; way++) {
        char *text = app_decimal(q, digits, way, &exact[way]);
        read_decimal(text, value[way]);
        bool plain = !strchr(text, 'e') && !strchr(text, '.');
        cr_assert(plain || count_digits(text) <= (size_t)digits, "%s", text);
        cr_assert_eq(exact[way], mpq_equal(value[way], q) != 0, "%s", text);
        free(text);
    }
    cr_assert(mpq_cmp(value[APP_DOWN], q) <= 0 && mpq_cmp(value[APP_UP], q) >= 0);
    cr_assert(exact[0] == exact[1] && exact[1] == exact[2]);
    mpq_sub(off[0], q, value[APP_DOWN]);
    mpq_sub(off[1], value[APP_UP], q);
    int order = mpq_cmp(off[0], off[1]);
    if (order != 0)
        cr_assert(mpq_equal(value[APP_NEAREST], value[order < 0 ? APP_DOWN : APP_UP]));
    else
        cr_assert(mpq_equal(value[APP_NEAREST], value[APP_DOWN]) ||
                  mpq_equal(value[APP_NEAREST], value[APP_UP]));
    mpq_clears(value[0], value[1], value[2], off[0], off[1], NULL);
}

Test(decimal, texts)
{
    expect_text("1/2", 0, APP_NEAREST, "1/2");
    expect_text("0", 6, APP_UP, "0");
    expect_text("1/2", 6, APP_NEAREST, "0.5");
    expect_text("-1/3", 6, APP_NEAREST, "~-0.333333");
    expect_text("-1/3", 6, APP_DOWN, "~-0.333334");
    expect_text("1/3", 6, APP_UP, "~0.333334");
    expect_text("2/3", 1, APP_DOWN, "~0.6");
    expect_text("999999/1000", 3, APP_NEAREST, "~1000");
    expect_text("1/10000", 2, APP_NEAREST, "0.0001");
    expect_text("1/100000", 2, APP_NEAREST, "1e-05");
    expect_text("99996/1000000000", 4, APP_NEAREST, "~0.0001");
}

/* All that stands in front of the point is printed, up to 15 digits; halves go to even digits. */
Test(decimal, whole_parts_and_ties)
{
    expect_text("123456789012345", 3, APP_NEAREST, "123456789012345");
    expect_text("1234567890123456", 3, APP_NEAREST, "~1.23e+15");
    expect_text("1999999999999999/2", 3, APP_NEAREST, "~1e+15");
    expect_text("24691357/2", 3, APP_NEAREST, "~12345678");
    expect_text("1000000000000000000000", 6, APP_NEAREST, "1e+21");
    expect_text("5/4", 2, APP_NEAREST, "~1.2");
    expect_text("27/20", 2, APP_NEAREST, "~1.4");
    expect_text("-5/4", 2, APP_NEAREST, "~-1.2");
}

Test(decimal, far_from_one)
{
    static const unsigned long power[] = {399, 400, 99999};
    for (size_t i = 0; i < sizeof power / sizeof *power; i++) {
        mpq_t q;
        mpq_init(q);
        mpq_set_ui(q, 1, 3);
        mpz_ui_pow_ui(mpq_numref(q), 10, power[i]);
        expect_good(q, 6);
        mpq_inv(q, q);
        expect_good(q, 6);
        bool exact;
        char *text = app_decimal(q, 6, APP_NEAREST, &exact), expected[32];
        snprintf(expected, sizeof expected, "3e-%lu", power[i]);
        cr_assert_str_eq(text, expected);
        cr_assert(exact);
        free(text);
        mpq_clear(q);
    }
}

Test(decimal, random_rationals)
{
    static const int digits[] = {1, 2, 6, 15, 16, 40};
    gmp_randstate_t random;
    mpq_t q;
    gmp_randinit_default(random);
    mpq_init(q);
    for (unsigned i = 0; i < 20000; i++) {
        mpz_urandomb(mpq_numref(q), random, 1 + i % 97);
        mpz_urandomb(mpq_denref(q), random, 1 + i % 89);
        mpz_add_ui(mpq_denref(q), mpq_denref(q), 1);
        if (i % 3 == 0) /* many that end */
            mpz_ui_pow_ui(mpq_denref(q), 10, i % 40);
        if (i % 2 == 0)
            mpz_neg(mpq_numref(q), mpq_numref(q));
        mpq_canonicalize(q);
        expect_good(q, digits[i % 6]);
    }
    mpq_clear(q);
    gmp_randclear(random);
}
