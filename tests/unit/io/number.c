/* number.c: the scanner of numbers against a simpler one, on random numerals. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include "io/core/io_private.h"
#include "io/core/short_decimal.h"

/* splitmix64. */
static uint64_t next(uint64_t *seed)
{
    uint64_t z = *seed += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

static size_t put_digits(uint64_t *seed, char *text, size_t most)
{
    static const char favourites[] = "0000000012345555678890000";
    size_t n = (size_t)(next(seed) % (most + 1));
    for (size_t i = 0; i < n; i++)
        text[i] = favourites[next(seed) % (sizeof favourites - 1)];
    text[n] = '\0';
    return n;
}

/* A decimal into text, and its value: digits over a power of ten, cancelled by GMP. */
static void random_decimal(uint64_t *seed, char *text, mpq_t value)
{
    char whole[64], part[64], digits[128];
    size_t behind = put_digits(seed, part, 40);
    if (put_digits(seed, whole, 40) + behind == 0)
        strcpy(whole, "7");
    long exponent = (long)(next(seed) % 101) - 50;
    sprintf(text, "%s%s%s", whole, behind > 0 ? "." : "", part);
    if (next(seed) % 2)
        sprintf(text + strlen(text), "%c%ld", next(seed) % 2 ? 'e' : 'E', exponent);
    else
        exponent = 0;
    sprintf(digits, "%s%s", whole, part);
    mpz_set_str(mpq_numref(value), digits, 10);
    mpz_ui_pow_ui(mpq_denref(value), 10, behind + 50);
    mpq_canonicalize(value);
    mpq_t scale;
    mpq_init(scale);
    mpz_ui_pow_ui(mpq_numref(scale), 10, (unsigned long)(50 + exponent));
    mpq_mul(value, value, scale);
    mpq_clear(scale);
}

static fmb_cursor cursor_on(const char *text, fmb_mem *mem, fmb_where *where, const fmb_reader *how)
{
    return (fmb_cursor){.begin = text,
                        .at = text,
                        .end = text + strlen(text),
                        .mark = text,
                        .line = 1,
                        .budget = 1000000,
                        .how = how,
                        .mem = mem,
                        .where = where};
}

static void check_value(const char *text, const mpq_t value)
{
    fmb_mem mem;
    fmb_where where;
    fmb_reader how = {.size = sizeof how, .warn = NULL};
    fmb_mem_init(&mem, NULL, 0);
    fmb_cursor c = cursor_on(text, &mem, &where, &how);
    mpq_t q;
    mpq_init(q);
    cr_assert(fmb_scan_number(&c, FMB_NUM_ALL, "a number", q) == FMB_OK, "%s", text);
    cr_assert(c.at == c.end, "stopped at %s in %s", c.at, text);
    cr_assert(mpq_equal(q, value), "%s", text); /* also: q is canonical */
    mpq_clear(q);
}

Test(number, random)
{
    mpq_t value, below;
    mpq_inits(value, below, NULL);
    for (uint64_t i = 0; i < 20000; i++) {
        uint64_t seed = i;
        char text[512];
        char *p = text;
        bool minus = next(&seed) % 3 == 0;
        if (minus || next(&seed) % 3 == 0)
            *p++ = minus ? '-' : '+';
        random_decimal(&seed, p, value);
        if (next(&seed) % 2) {
            p += strlen(p);
            *p = '/';
            random_decimal(&seed, p + 1, below);
            if (mpq_sgn(below) != 0)
                mpq_div(value, value, below);
            else
                *p = '\0';
        }
        if (minus)
            mpq_neg(value, value);
        check_value(text, value);
    }
    mpq_clears(value, below, NULL);
}

/* Where a number ends, by what is allowed in it. */
Test(number, ends)
{
    static const struct {
        const char *text;
        int flags;
        size_t length; /* 0: no number */
    } table[] = {
        {"12.5e3/4x", FMB_NUM_ALL, 8},
        {"12.5e3/4x", FMB_NUM_DECIMAL | FMB_NUM_EXPONENT, 6},
        {"12.5e3/4x", FMB_NUM_DECIMAL, 4},
        {"12.5e3/4x", 0, 2},
        {"-1", FMB_NUM_ALL, 2},
        {"-1", 0, 0},
        {"- 1", FMB_NUM_ALL, 0},
        {".", FMB_NUM_ALL, 0},
        {".5", 0, 0},
        {"5.", FMB_NUM_ALL, 2},
        {"1e", FMB_NUM_ALL, 1},
        {"1e+", FMB_NUM_ALL, 1},
        {"1e-7", FMB_NUM_ALL, 4},
        {"1/x", FMB_NUM_ALL, 1},
        {"1/-2", FMB_NUM_ALL, 1},
        {"1/.5", FMB_NUM_ALL, 4},
        {"", FMB_NUM_ALL, 0},
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        fmb_mem mem;
        fmb_where where;
        fmb_reader how = {.size = sizeof how, .warn = NULL};
        fmb_mem_init(&mem, NULL, 0);
        fmb_cursor c = cursor_on(table[i].text, &mem, &where, &how);
        mpq_t q;
        mpq_init(q);
        fmb_status st = fmb_scan_number(&c, table[i].flags, "a number", q);
        cr_expect((st == FMB_OK) == (table[i].length > 0), "%s", table[i].text);
        cr_expect((size_t)(c.at - c.begin) == table[i].length, "%s ends at %s", table[i].text,
                  c.at);
        mpq_clear(q);
    }
}

/* What a number costs of the budget, to the digit: its exponent, of either sign, in either part of
 * a fraction. One digit less, and it is refused; so is an exponent beyond the limit, before any
 * power is formed and however many digits it has, unless the number is 0. */
Test(number, cost_of_exponents)
{
    enum { REFUSED = -1 };
    static const struct {
        const char *text;
        long cost;
    } table[] = {
        {"7", 0},
        {"7e0", 0},
        {"1e5", 5},
        {"1e-5", 5},
        {"1e+00000000000000000000005", 5},
        {"100000e-5", 5},
        {"1.25e100", 100},
        {"1e3/1e4", 7},
        {"-2e-30/7e-12", 42},
        {"1e100000", 100000},
        {"1e-100000", 100000},
        {"3.7e100000/1e-100000", 200000},
        {"0e100000", 0},
        {"0.00e-999999999999999999999999", 0},
        {"1e100001", REFUSED},
        {"1e-100001", REFUSED},
        {"1/1e100001", REFUSED},
        {"1e4294967297", REFUSED},            /* 2^32 + 1 */
        {"1e-18446744073709551617", REFUSED}, /* 2^64 + 1 */
        {"1e99999999999999999999999999999999999999999", REFUSED},
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        fmb_mem mem;
        fmb_where where;
        fmb_reader how = {.size = sizeof how, .warn = NULL};
        mpq_t q;
        mpq_init(q);
        fmb_mem_init(&mem, NULL, 0);
        for (long spare = 0; spare >= (table[i].cost > 0 ? -1 : 0); spare--) {
            fmb_cursor c = cursor_on(table[i].text, &mem, &where, &how);
            bool refused = table[i].cost == REFUSED || spare < 0;
            c.budget = table[i].cost == REFUSED ? SIZE_MAX : (size_t)(table[i].cost + spare);
            fmb_status st = fmb_scan_number(&c, FMB_NUM_ALL, "a number", q);
            cr_expect(st == (refused ? FMB_ERR_PARSE : FMB_OK), "%s with %ld to spare: %s",
                      table[i].text, spare, fmb_status_text(st));
            cr_expect(refused || c.budget == 0, "%s leaves %zu", table[i].text, c.budget);
            cr_expect(!refused ||
                      strstr(where.text,
                             table[i].cost == REFUSED ? "an exponent between" : "smaller numbers"));
        }
        mpq_clear(q);
    }
}

/* Places are found in any order. */
Test(number, places)
{
    fmb_mem mem;
    fmb_where where;
    fmb_reader how = {.size = sizeof how, .warn = NULL};
    fmb_mem_init(&mem, NULL, 0);
    fmb_cursor c = cursor_on("ab\n\ncde\n", &mem, &where, &how);
    static const long places[][3] = {{8, 4, 1}, {6, 3, 3}, {0, 1, 1},
                                     {3, 2, 1}, {2, 1, 3}, {4, 3, 1}};
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        cr_expect(fmb_io_fail(&c, c.begin + places[i][0], "here") == FMB_ERR_PARSE);
        cr_expect(where.line == places[i][1] && where.column == places[i][2], "%ld: %ld:%ld",
                  places[i][0], where.line, where.column);
    }
}

/* ---- numbers of few digits ------------------------------------------------------------------- */

/* A decimal of 19 digits or fewer next to what is half way between two doubles, or to a double. */
static void put_decimal_near_a_middle(uint64_t *seed, char *text)
{
    int shift = (int)(next(seed) % 60);
    double x = ldexp((double)(next(seed) >> 11), -shift);
    long double middle = (long double)x + ldexpl(next(seed) % 2, -shift - 1);
    int digits = 16 + (int)(next(seed) % 4);
    if (next(seed) % 2)
        sprintf(text, "%.*Lg", digits, middle);
    else
        sprintf(text, "%.*Lf", (int)(next(seed) % 19), middle);
}

/* A number of up to 20 digits; every second one lies half way between two doubles, or next to it.
 */
static void put_short_decimal(uint64_t *seed, char *text)
{
    uint64_t m = next(seed) >> next(seed) % 63, half = (next(seed) >> 11 | 1) * 512;
    int exponent = (int)(next(seed) % 61) - 30;
    if (next(seed) % 2)
        sprintf(text, "%s%llu", next(seed) % 2 ? "-" : "",
                (unsigned long long)(half << 1 | 1024) + next(seed) % 3 - 1);
    else if (next(seed) % 2)
        sprintf(text, "%llue%d", (unsigned long long)m, exponent);
    else
        sprintf(text, "%llu.%llu", (unsigned long long)(m % 100000),
                (unsigned long long)(next(seed) % 100000000000000));
}

/* As a double and as a rational, against GMP. */
Test(number, few_digits)
{
    uint64_t seed = 4;
    int answered = 0;
    char text[128];
    fmb_mem mem;
    fmb_where where;
    mpq_t exact, value;
    fmb_mem_init(&mem, NULL, 0);
    mpq_inits(exact, value, NULL);
    for (int i = 0; i < 200000; i++) {
        double x = 0;
        bool is_double, was_double;
        fmb_short_decimal s;
        (i % 2 ? put_short_decimal : put_decimal_near_a_middle)(&seed, text);
        fmb_cursor c = cursor_on(text, &mem, &where, NULL), d = c;
        if (!fmb_scan_short_decimal(&c, false, &s)) {
            cr_assert_eq(c.at, text);
            continue;
        }
        bool near = fmb_short_decimal_nearest(&s, &x);
        cr_assert_eq(near, fmb_short_decimal_value(&s, value, &is_double));
        if (!near)
            continue;
        answered++;
        cr_assert_eq(c.at, c.end);
        cr_assert_eq(fmb_scan_number(&d, FMB_NUM_ALL, "a number", exact), FMB_OK);
        cr_assert_eq(x, fmb_io_nearest(exact, &was_double), "%s: %.17g", text, x);
        cr_assert(mpq_equal(value, exact) && is_double == was_double, "%s", text);
    }
    cr_expect_gt(answered, 150000);
    mpq_clears(exact, value, NULL);
}

static bool is_short(const char *text, bool strictly)
{
    fmb_mem mem;
    fmb_where where;
    fmb_short_decimal d;
    fmb_mem_init(&mem, NULL, 0);
    fmb_cursor c = cursor_on(text, &mem, &where, NULL);
    bool is = fmb_scan_short_decimal(&c, strictly, &d);
    cr_expect(c.at == (is ? c.end : text), "%s", text);
    return is;
}

/* What JSON does not have, and what has too many digits, goes another way. */
Test(number, which_are_of_few_digits)
{
    static const char *const both[] = {"0",
                                       "-0",
                                       "7",
                                       "0.5",
                                       "-12.25e-3",
                                       "1E+5",
                                       "0.0000000000000000000000001234567890123456789",
                                       "1e100",
                                       "12345678",
                                       "1234567890123456789"},
                             *const loose[] = {"+1", ".5", "1.", "01", "00.5", "+.5e1"},
                             *const none[] = {"",
                                              "-",
                                              ".",
                                              "e5",
                                              "1e",
                                              "1e+",
                                              "1e1234",
                                              "--1",
                                              "12345678901234567890",
                                              "1.2345678901234567890",
                                              "x"};
    for (size_t i = 0; i < sizeof both / sizeof *both; i++)
        cr_expect(is_short(both[i], true) && is_short(both[i], false), "%s", both[i]);
    for (size_t i = 0; i < sizeof loose / sizeof *loose; i++)
        cr_expect(!is_short(loose[i], true) && is_short(loose[i], false), "%s", loose[i]);
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        cr_expect(!is_short(none[i], true) && !is_short(none[i], false), "%s", none[i]);
}
