/* decimal.c: see decimal.h. All is computed in integers: floor(|q| 10^k), with k such that this has
 * all required digits and one more, and whether there is a remainder. */
#include "common/decimal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "common/value.h"

enum { KEY_DECIMAL = 0x400, USUAL = 6, MOST = 10000, LEAST_EXPONENT = -4, END_EXPONENT = 15 };

/* ---- the option ------------------------------------------------------------------------------ */

static const struct argp_option options[] = {
    {"decimal", KEY_DECIMAL, "N", OPTION_ARG_OPTIONAL,
     "Print decimals of N significant digits (default 6) in place of fractions; rounded ones begin "
     "with ~, ends of intervals are rounded outward; in JSON beside the exact number",
     2},
    {0}};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    int *digits = state->input;
    if (key != KEY_DECIMAL)
        return ARGP_ERR_UNKNOWN;
    *digits = arg ? (int)app_value_whole("--decimal", arg, 1, MOST, state) : USUAL;
    return 0;
}

const struct argp app_decimal_argp = {.options = options, .parser = parse};

/* ---- digits ---------------------------------------------------------------------------------- */

/* A size: digit[0].digit[1]... times 10^exponent, and perhaps a rest below the last digit. */
typedef struct long_decimal {
    char *digit; /* from malloc */
    size_t n;
    long exponent;
    bool rest;
} long_decimal;

/* The size of q with at least `digits` digits and one more: mpz_sizeinbase may be 1 too large, so
 * |q| lies between 10^(a - b - 2) and 10^(a - b + 1) for the sizes a and b of its parts. */
static long_decimal find_digits(mpq_srcptr q, int digits)
{
    long a = (long)mpz_sizeinbase(mpq_numref(q), 10), b = (long)mpz_sizeinbase(mpq_denref(q), 10);
    long k = digits - (a - b - 2);
    long_decimal d = {0};
    mpz_t size, unit, rest;
    mpz_inits(size, unit, rest, NULL);
    mpz_ui_pow_ui(unit, 10, (unsigned long)labs(k));
    mpz_abs(size, mpq_numref(q));
    if (k > 0)
        mpz_mul(size, size, unit);
    if (k > 0)
        mpz_set(unit, mpq_denref(q));
    else
        mpz_mul(unit, unit, mpq_denref(q));
    mpz_tdiv_qr(size, rest, size, unit);
    d.digit = app_need(mpz_get_str(NULL, 10, size));
    d.n = strlen(d.digit);
    d.exponent = (long)d.n - 1 - k;
    d.rest = mpz_sgn(rest) != 0;
    mpz_clears(size, unit, rest, NULL);
    return d;
}

/* Add one unit in the last place of the kept digits; 999 becomes 1000. */
static void step_away(long_decimal *d)
{
    size_t i = d->n;
    while (i > 0 && d->digit[i - 1] == '9')
        d->digit[--i] = '0';
    if (i > 0) {
        d->digit[i - 1]++;
        return;
    }
    d->digit[0] = '1';
    d->exponent++;
}

/* Are the digits after the first `keep` more than half a unit, or exactly half after an odd digit?
 */
static bool is_nearer_away(const long_decimal *d, size_t keep)
{
    bool more = d->rest || strspn(d->digit + keep + 1, "0") < d->n - keep - 1;
    return d->digit[keep] > '5' ||
           (d->digit[keep] == '5' && (more || (d->digit[keep - 1] - '0') % 2 != 0));
}

/* Round to `keep` digits; false if only zeros were removed. */
static bool cut_digits(long_decimal *d, size_t keep, app_rounding way, int sign)
{
    bool exact = !d->rest && strspn(d->digit + keep, "0") == d->n - keep;
    bool away = way == APP_NEAREST ? is_nearer_away(d, keep) : (way == APP_UP) == (sign > 0);
    d->n = keep;
    d->rest = false;
    if (!exact && away)
        step_away(d);
    while (d->n > 1 && d->digit[d->n - 1] == '0')
        d->n--;
    return !exact;
}

/* ---- text ------------------------------------------------------------------------------------ */

static void put_zeros(FILE *out, long n)
{
    while (n-- > 0)
        fputc('0', out);
}

static void put_plain(FILE *out, const long_decimal *d)
{
    long front = d->exponent + 1, n = (long)d->n;
    if (front <= 0) {
        fputs("0.", out);
        put_zeros(out, -front);
        fwrite(d->digit, 1, d->n, out);
        return;
    }
    fwrite(d->digit, 1, (size_t)(n < front ? n : front), out);
    put_zeros(out, front - n);
    if (n > front)
        fprintf(out, ".%.*s", (int)(n - front), d->digit + front);
}

static void put_scientific(FILE *out, const long_decimal *d)
{
    fprintf(out, d->n > 1 ? "%c.%.*s" : "%c%.*s", d->digit[0], (int)d->n - 1, d->digit + 1);
    fprintf(out, "e%+03ld", d->exponent);
}

static void put_decimal(FILE *out, mpq_srcptr q, int digits, app_rounding way, bool *exact)
{
    long_decimal d = find_digits(q, digits > END_EXPONENT ? digits : END_EXPONENT);
    bool plain = d.exponent < END_EXPONENT && d.exponent >= digits;
    size_t keep = plain ? (size_t)d.exponent + 1 : (size_t)digits;
    *exact = !cut_digits(&d, keep, way, mpq_sgn(q));
    fputs(mpq_sgn(q) < 0 ? "-" : "", out);
    if (d.exponent >= LEAST_EXPONENT && d.exponent < END_EXPONENT)
        put_plain(out, &d);
    else
        put_scientific(out, &d);
    free(d.digit);
}

char *app_decimal(mpq_srcptr q, int digits, app_rounding way, bool *exact)
{
    char *text = NULL;
    size_t size;
    FILE *out = app_need(open_memstream(&text, &size));
    *exact = true;
    if (mpq_sgn(q) == 0)
        fputc('0', out);
    else
        put_decimal(out, q, digits, way, exact);
    fclose(out);
    return app_need(text);
}

char *app_number(mpq_srcptr q, int digits, app_rounding way)
{
    if (digits == 0)
        return app_need(mpq_get_str(NULL, 10, q));
    bool exact;
    char *text = app_decimal(q, digits, way, &exact), *marked;
    if (exact)
        return text;
    marked = app_need(malloc(strlen(text) + 2));
    marked[0] = '~';
    strcpy(marked + 1, text);
    free(text);
    return marked;
}
