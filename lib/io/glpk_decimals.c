/* glpk_decimals.c: from doubles back to the decimals they were; see glpk_decimals.h.
 *
 * The caller has set the C locale: GLPK and this file use strtod.
 */
#include "io/glpk_decimals.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool is_digit(int b)
{
    return b >= '0' && b <= '9';
}

static size_t digits_at(fmb_span w, size_t i)
{
    size_t n = 0;
    while (i + n < w.n && is_digit(w.p[i + n]))
        n++;
    return n;
}

static size_t sign_at(fmb_span w, size_t i)
{
    return i < w.n && (w.p[i] == '+' || w.p[i] == '-');
}

/* [sign] (digits [. [digits]] | . digits) [e [sign] digits] */
bool fmb_decimals_is_number(fmb_span w)
{
    size_t i = sign_at(w, 0), before = digits_at(w, i), after = 0;
    i += before;
    if (i < w.n && w.p[i] == '.') {
        after = digits_at(w, ++i);
        i += after;
    }
    if (before + after == 0)
        return false;
    if (i < w.n && (w.p[i] == 'e' || w.p[i] == 'E')) {
        i += 1 + sign_at(w, i + 1);
        size_t n = digits_at(w, i);
        i += n;
        if (n == 0)
            return false;
    }
    return i == w.n;
}

/* ---- equal values ---------------------------------------------------------------------------- */

/* 0.d1 d2 ... dk * 10^power with d1 and dk not 0; zero has no digits. */
typedef struct scientific {
    const char *first; /* d1; a point may stand between the digits */
    size_t digits;
    long power;
} scientific;

#define POWER_MAX 1000000000L

static long exponent_of(const char *p, const char *end)
{
    bool minus = p < end && *p == '-';
    long e = 0;
    for (p += p < end && (*p == '-' || *p == '+'); p < end; p++)
        e = e < POWER_MAX ? 10 * e + (*p - '0') : POWER_MAX;
    return minus ? -e : e;
}

static scientific normal_form(fmb_span w)
{
    scientific s = {0};
    const char *p = w.p + sign_at(w, 0), *end = w.p + w.n;
    bool point = false;
    size_t seen = 0;
    for (; p < end && *p != 'e' && *p != 'E'; p++) {
        if (*p == '.') {
            point = true;
            continue;
        }
        if (s.first || *p != '0') {
            s.first = s.first ? s.first : p;
            seen++;
            s.digits = *p != '0' ? seen : s.digits;
            s.power += !point;
        } else {
            s.power -= point;
        }
    }
    if (p < end)
        s.power += exponent_of(p + 1, end);
    return s;
}

static bool same_value(fmb_span v, fmb_span w)
{
    scientific a = normal_form(v), b = normal_form(w);
    if (a.digits != b.digits || (a.digits > 0 && a.power != b.power))
        return false;
    for (size_t i = 0; i < a.digits; i++, a.first++, b.first++) {
        a.first += *a.first == '.';
        b.first += *b.first == '.';
        if (*a.first != *b.first)
            return false;
    }
    return true;
}

bool fmb_decimals_is_whole(fmb_span w)
{
    scientific s = normal_form(w);
    return s.digits == 0 || (s.power > 0 && s.digits <= (size_t)s.power);
}

/* ---- the table ------------------------------------------------------------------------------- */

static size_t slot_of(const fmb_decimals *t, double d)
{
    uint64_t bits;
    memcpy(&bits, &d, sizeof bits);
    bits = (bits ^ bits >> 32) * 0x9E3779B97F4A7C15u; /* short numbers differ in high bits only */
    size_t i = (size_t)(bits ^ bits >> 32) & (t->slots - 1);
    while (t->slot[i] > 0 && t->entry[t->slot[i] - 1].value != d)
        i = (i + 1) & (t->slots - 1);
    return i;
}

static fmb_status reserve_slots(fmb_decimals *t)
{
    size_t slots = t->slots ? t->slots : 64;
    while (slots <= 2 * (t->entries + 1))
        slots *= 2;
    if (slots == t->slots)
        return FMB_OK;
    size_t *slot = fmb_mem_zero(t->c->mem, slots, sizeof *slot);
    if (!slot)
        return fmb_mem_status(t->c->mem);
    fmb_mem_put(t->c->mem, t->slot, t->slots, sizeof *t->slot);
    t->slot = slot;
    t->slots = slots;
    for (size_t k = 0; k < t->entries; k++)
        t->slot[slot_of(t, t->entry[k].value)] = k + 1;
    return FMB_OK;
}

static fmb_status insert(fmb_decimals *t, double d, fmb_span text)
{
    fmb_status st = reserve_slots(t);
    if (st != FMB_OK)
        return st;
    size_t i = slot_of(t, d);
    if (t->slot[i] > 0) {
        fmb_decimal *e = &t->entry[t->slot[i] - 1];
        if (!e->other.p && !same_value(e->text, text))
            e->other = text;
        return FMB_OK;
    }
    st = fmb_mem_reserve(t->c->mem, (void **)&t->entry, &t->capacity, t->entries + 1,
                         sizeof *t->entry);
    if (st != FMB_OK)
        return st;
    t->entry[t->entries] = (fmb_decimal){.value = d, .text = text};
    mpq_init(t->entry[t->entries].exact);
    t->slot[i] = ++t->entries;
    return FMB_OK;
}

fmb_status fmb_decimals_init(fmb_decimals *t, fmb_cursor *c)
{
    *t = (fmb_decimals){.c = c};
    return insert(t, 1, (fmb_span){"1", 1});
}

void fmb_decimals_clear(fmb_decimals *t)
{
    for (size_t k = 0; k < t->entries; k++)
        mpq_clear(t->entry[k].exact);
    fmb_mem_put(t->c->mem, t->entry, t->capacity, sizeof *t->entry);
    fmb_mem_put(t->c->mem, t->slot, t->slots, sizeof *t->slot);
}

/* The double of a word without sign. */
static fmb_status to_double(fmb_decimals *t, fmb_span w, double *out)
{
    char small[64], *text = w.n < sizeof small ? small : fmb_mem_get(t->c->mem, w.n + 1, 1);
    if (!text)
        return fmb_mem_status(t->c->mem);
    memcpy(text, w.p, w.n);
    text[w.n] = '\0';
    *out = strtod(text, NULL);
    if (text != small)
        fmb_mem_put(t->c->mem, text, w.n + 1, 1);
    return FMB_OK;
}

fmb_status fmb_decimals_note(fmb_decimals *t, fmb_span w)
{
    double d;
    size_t sign = sign_at(w, 0);
    w = (fmb_span){w.p + sign, w.n - sign};
    fmb_status st = to_double(t, w, &d);
    if (st != FMB_OK || isinf(d) || normal_form(w).digits == 0)
        return st;
    if (d < DBL_MIN)
        return fmb_io_fail(t->c, w.p,
                           "expected a number of at least 1e-307: GLPK takes smaller "
                           "ones for 0");
    return insert(t, d, w);
}

static fmb_status work_out(fmb_decimals *t, fmb_decimal *e)
{
    fmb_cursor at = *t->c;
    at.at = e->text.p;
    at.end = e->text.p + e->text.n;
    fmb_status st = fmb_scan_number(&at, FMB_NUM_DECIMAL | FMB_NUM_EXPONENT, "a number", e->exact);
    t->c->budget = at.budget;
    e->known = st == FMB_OK;
    return st;
}

fmb_status fmb_decimals_exact(fmb_decimals *t, double d, mpq_t out)
{
    fmb_status st = FMB_OK;
    if (d == 0) {
        mpq_set_ui(out, 0, 1);
        return FMB_OK;
    }
    size_t i = slot_of(t, fabs(d));
    if (t->slot[i] == 0)
        return fmb_io_fail_whole(t->c, "GLPK makes %.17g of a number: it cannot be read exactly",
                                 d);
    fmb_decimal *e = &t->entry[t->slot[i] - 1];
    if (e->other.p)
        return fmb_io_fail(t->c, e->other.p,
                           "expected numbers that differ as doubles: GLPK does not tell this one "
                           "from %.*s",
                           (int)(e->text.n < 40 ? e->text.n : 40), e->text.p);
    if (!e->known)
        st = work_out(t, e);
    if (st == FMB_OK)
        mpq_set(out, e->exact);
    if (st == FMB_OK && d < 0)
        mpq_neg(out, out);
    return st;
}
