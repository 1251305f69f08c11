/* number.c: the scanner of numbers against a plainer way to the same value, on random numerals. */
#include <criterion/criterion.h>
#include <string.h>

#include "io/core/io.h"

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
    fmb_reader how = {.warn = NULL};
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
        fmb_reader how = {.warn = NULL};
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
        fmb_reader how = {.warn = NULL};
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
    fmb_reader how = {.warn = NULL};
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

/* ---- the nearest double of few digits -------------------------------------------------------- */

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

Test(number, nearest_of_few_digits)
{
    uint64_t seed = 4;
    int answered = 0;
    char text[64];
    fmb_mem mem;
    fmb_where where;
    mpq_t exact;
    fmb_mem_init(&mem, NULL, 0);
    mpq_init(exact);
    for (int i = 0; i < 100000; i++) {
        double x = 0;
        bool ignored;
        put_short_decimal(&seed, text);
        fmb_cursor c = cursor_on(text, &mem, &where, NULL), d = c;
        if (!fmb_scan_short_nearest(&c, c.end, &x)) {
            cr_assert_eq(c.at, text);
            continue;
        }
        answered++;
        cr_assert_eq(c.at, c.end);
        cr_assert_eq(fmb_scan_number(&d, FMB_NUM_ALL, "a number", exact), FMB_OK);
        cr_assert_eq(x, fmb_io_nearest(exact, &ignored), "%s: %.17g", text, x);
    }
    cr_expect_gt(answered, 80000);
    mpq_clear(exact);
}
