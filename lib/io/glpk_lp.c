/* glpk_lp.c: a CPLEX LP text checked and made ready for GLPK; see glpk_lp.h.
 *
 * GLPK 5.0 takes a word at the start of a line for a keyword if it is the beginning of one ("e" for
 * "end"), and a word in a bound for infinity or "free" likewise: `x >= -y` would free x. So lines
 * that start with another word than a keyword are moved by a blank, and bounds are checked here.
 */
#include "io/glpk_lp.h"

#include <string.h>

void fmb_lp_edit_init(fmb_lp_edit *e, fmb_cursor *c, fmb_decimals *numbers)
{
    *e = (fmb_lp_edit){.c = c, .numbers = numbers};
}

void fmb_lp_edit_clear(fmb_lp_edit *e)
{
    fmb_mem_put(e->c->mem, e->text, e->capacity, 1);
}

static fmb_status put(fmb_lp_edit *e, const char *p, size_t n)
{
    fmb_status st = fmb_mem_reserve(e->c->mem, (void **)&e->text, &e->capacity, e->size + n, 1);
    if (st == FMB_OK && n > 0) {
        memcpy(e->text + e->size, p, n);
        e->size += n;
    }
    return st;
}

/* ---- tokens ---------------------------------------------------------------------------------- */

static bool is_digit(int b)
{
    return b >= '0' && b <= '9';
}

static bool is_letter(int b)
{
    return (b >= 'a' && b <= 'z') || (b >= 'A' && b <= 'Z');
}

static bool is_name_byte(int b)
{
    return is_letter(b) || is_digit(b) || (b > 0 && strchr("!\"#$%&()/,.;?@_`'{}|~", b));
}

static fmb_span scan_name(fmb_cursor *c)
{
    const char *p = c->at;
    while (is_name_byte(fmb_peek(c)))
        c->at++;
    return (fmb_span){p, (size_t)(c->at - p)};
}

static void skip_digits(fmb_cursor *c)
{
    while (is_digit(fmb_peek(c)))
        c->at++;
}

/* digits [. digits] [e [sign] digits]; what GLPK refuses of it, it may refuse itself. */
static fmb_span scan_number(fmb_cursor *c)
{
    const char *p = c->at;
    skip_digits(c);
    if (fmb_peek(c) == '.') {
        c->at++;
        skip_digits(c);
    }
    if (fmb_peek(c) == 'e' || fmb_peek(c) == 'E') {
        c->at++;
        c->at += fmb_peek(c) == '+' || fmb_peek(c) == '-';
        skip_digits(c);
    }
    return (fmb_span){p, (size_t)(c->at - p)};
}

/* ---- bounds ---------------------------------------------------------------------------------- */

typedef enum token { NAME, NUMBER, SIGN, REL, OTHER } token;

static bool is_infinity(fmb_span w)
{
    return fmb_span_is_nocase(w, "inf") || fmb_span_is_nocase(w, "infinity");
}

/* The state after a token; FMB_LP_START also where the token belongs to the next bound. False if it
 * cannot follow. */
static bool step(fmb_lp_state *s, token t, fmb_span w)
{
    bool value = t == NUMBER || (t == NAME && is_infinity(w));
    switch (*s) {
    case FMB_LP_BETWEEN:
        *s = t == REL ? FMB_LP_HIGH_REL : FMB_LP_START;
        return t == REL || step(s, t, w);
    case FMB_LP_START:
        *s = t == SIGN ? FMB_LP_LOW_SIGN : t == NUMBER ? FMB_LP_LOW : FMB_LP_NAME;
        return t == SIGN || t == NUMBER || t == NAME;
    case FMB_LP_LOW_SIGN:
        *s = FMB_LP_LOW;
        return value;
    case FMB_LP_LOW:
        *s = FMB_LP_LOW_REL;
        return t == REL;
    case FMB_LP_LOW_REL:
        *s = FMB_LP_BETWEEN;
        return t == NAME;
    case FMB_LP_NAME:
        *s = t == REL ? FMB_LP_HIGH_REL : FMB_LP_START;
        return t == REL || (t == NAME && fmb_span_is_nocase(w, "free"));
    case FMB_LP_HIGH_REL:
        *s = t == SIGN ? FMB_LP_HIGH_SIGN : FMB_LP_START;
        return t == SIGN || t == NUMBER;
    case FMB_LP_HIGH_SIGN:
        *s = FMB_LP_START;
        return value;
    }
    return false;
}

static fmb_status check_bound(fmb_lp_edit *e, token t, fmb_span w)
{
    if (!e->bounds || step(&e->state, t, w))
        return FMB_OK;
    char buf[FMB_QUOTE];
    return fmb_io_fail(e->c, w.p,
                       "expected a bound: 'x <= 1', '-inf <= x <= 1' or 'x free', "
                       "found %s",
                       fmb_quote(e->c, w.p, buf));
}

/* A section ends: its last bound must be complete. */
static fmb_status leave_bounds(fmb_lp_edit *e)
{
    bool open = e->bounds && e->state != FMB_LP_START && e->state != FMB_LP_BETWEEN;
    e->bounds = false;
    e->state = FMB_LP_START;
    return open ? fmb_io_fail(e->c, e->c->at, "expected the rest of a bound") : FMB_OK;
}

/* ---- the text -------------------------------------------------------------------------------- */

static bool is_keyword(fmb_span w)
{
    static const char *const words[] = {
        "minimize", "minimum",  "min", "maximize", "maximum",  "max",     "subject",  "such",
        "st",       "s.t.",     "st.", "bounds",   "bound",    "general", "generals", "gen",
        "integer",  "integers", "int", "binary",   "binaries", "bin",     "end"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (fmb_span_is_nocase(w, words[i]))
            return true;
    return false;
}

/* A word at the start of a line. */
static fmb_status edit_first_word(fmb_lp_edit *e)
{
    fmb_cursor ahead = *e->c;
    fmb_span w = scan_name(&ahead);
    if (!is_keyword(w))
        return put(e, " ", 1);
    fmb_status st = leave_bounds(e);
    e->bounds = fmb_span_is_nocase(w, "bounds") || fmb_span_is_nocase(w, "bound");
    e->c->at = ahead.at;
    return st;
}

static fmb_status edit_token(fmb_lp_edit *e)
{
    fmb_cursor *c = e->c;
    int b = fmb_peek(c);
    fmb_span w = {c->at, 1};
    if (is_digit(b) || b == '.') {
        w = scan_number(c);
        fmb_status st = fmb_decimals_is_number(w) ? fmb_decimals_note(e->numbers, w) : FMB_OK;
        return st == FMB_OK ? check_bound(e, NUMBER, w) : st;
    }
    if (is_name_byte(b))
        return check_bound(e, NAME, scan_name(c));
    if (b >= 128) {
        char buf[FMB_QUOTE];
        return fmb_io_fail(c, w.p, "expected ASCII letters in names, found %s",
                           fmb_quote(c, w.p, buf));
    }
    c->at++;
    if (b == '<' || b == '>' || b == '=') {
        b = fmb_peek(c);
        c->at += b == '<' || b == '>' || b == '=';
        return check_bound(e, REL, w);
    }
    return check_bound(e, b == '+' || b == '-' ? SIGN : OTHER, w);
}

/* A line without its comment: GLPK wants nothing at all behind a right side. */
static fmb_status edit_line(fmb_lp_edit *e)
{
    fmb_cursor *c = e->c;
    const char *start = c->at;
    fmb_status st = is_letter(fmb_peek(c)) ? edit_first_word(e) : FMB_OK;
    for (fmb_skip_blanks(c); st == FMB_OK; fmb_skip_blanks(c)) {
        if (fmb_peek(c) < 0 || fmb_peek(c) == '\n' || fmb_peek(c) == '\\')
            break;
        st = edit_token(e);
    }
    if (st == FMB_OK)
        st = put(e, start, (size_t)(c->at - start));
    fmb_next_line(c);
    return st == FMB_OK ? put(e, "\n", 1) : st;
}

fmb_status fmb_lp_edit_run(fmb_lp_edit *e)
{
    fmb_status st = FMB_OK;
    e->c->at = e->c->begin;
    while (st == FMB_OK && e->c->at < e->c->end)
        st = edit_line(e);
    return st == FMB_OK ? leave_bounds(e) : st;
}
