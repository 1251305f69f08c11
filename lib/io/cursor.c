/* cursor.c: moving over the text, and saying where it goes wrong; see io.h. */
#include <stdarg.h>
#include <string.h>

#include "io/io.h"

static bool is_blank(int b)
{
    return b == ' ' || b == '\t' || b == '\r' || b == '\f' || b == '\v';
}

void fmb_skip_blanks(fmb_cursor *c)
{
    while (is_blank(fmb_peek(c)))
        c->at++;
}

void fmb_skip_space(fmb_cursor *c)
{
    while (is_blank(fmb_peek(c)) || fmb_peek(c) == '\n')
        c->at++;
}

void fmb_skip_line(fmb_cursor *c)
{
    if (c->at == c->end)
        return;
    const char *p = memchr(c->at, '\n', (size_t)(c->end - c->at));
    c->at = p ? p : c->end;
}

void fmb_next_line(fmb_cursor *c)
{
    fmb_skip_line(c);
    c->at += c->at < c->end;
}

bool fmb_accept(fmb_cursor *c, const char *word)
{
    size_t n = strlen(word);
    if ((size_t)(c->end - c->at) < n || memcmp(c->at, word, n) != 0)
        return false;
    c->at += n;
    return true;
}

/* ---- words ----------------------------------------------------------------------------------- */

fmb_span fmb_scan_word(fmb_cursor *c)
{
    const char *p = c->at;
    while (fmb_peek(c) >= 0 && fmb_peek(c) != '\n' && !is_blank(fmb_peek(c)))
        c->at++;
    return (fmb_span){p, (size_t)(c->at - p)};
}

bool fmb_span_is(fmb_span w, const char *word)
{
    return strlen(word) == w.n && memcmp(w.p, word, w.n) == 0;
}

static int lower(int b)
{
    return b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b;
}

bool fmb_span_is_nocase(fmb_span w, const char *word)
{
    size_t i = 0;
    while (i < w.n && word[i] && lower(w.p[i]) == lower(word[i]))
        i++;
    return i == w.n && !word[i];
}

const char *fmb_quote(const fmb_cursor *c, const char *p, char buf[FMB_QUOTE])
{
    if (p >= c->end)
        return strcpy(buf, "end of file");
    if (*p == '\n' || *p == '\r')
        return strcpy(buf, "end of line");
    size_t n = 0, most = FMB_QUOTE - 6;
    buf[n++] = '\'';
    do
        buf[n++] = *p++;
    while (p < c->end && *p != '\n' && !is_blank(*p) && n < most);
    bool more = p < c->end && *p != '\n' && !is_blank(*p);
    while (more && n > 2 && ((unsigned char)*p & 0xC0) == 0x80) /* cut between characters */
        p--, n--;
    strcpy(buf + n, more ? "...'" : "'");
    return buf;
}

/* ---- places and messages --------------------------------------------------------------------- */

/* Line and column of p. The last line found is remembered: places asked for in order cost one pass
 * over the text in all. */
static void locate(fmb_cursor *c, const char *p, fmb_where *w)
{
    if (p < c->mark) {
        c->mark = c->begin;
        c->line = 1;
    }
    const char *eol;
    while (p > c->mark && (eol = memchr(c->mark, '\n', (size_t)(p - c->mark))) != NULL) {
        c->mark = eol + 1;
        c->line++;
    }
    w->line = c->line;
    w->column = (long)(p - c->mark) + 1;
}

static void describe(fmb_cursor *c, const char *p, fmb_where *w, const char *format, va_list args)
{
    *w = (fmb_where){0};
    if (p)
        locate(c, p, w);
    vsnprintf(w->text, sizeof w->text, format, args);
}

fmb_status fmb_io_fail(fmb_cursor *c, const char *p, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    describe(c, p, c->where, format, args);
    va_end(args);
    return FMB_ERR_PARSE;
}

fmb_status fmb_io_fail_whole(fmb_cursor *c, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    describe(c, NULL, c->where, format, args);
    va_end(args);
    return FMB_ERR_PARSE;
}

void fmb_io_warn(fmb_cursor *c, const char *p, const char *format, ...)
{
    if (!c->how->warn)
        return;
    fmb_where w;
    va_list args;
    va_start(args, format);
    describe(c, p, &w, format, args);
    va_end(args);
    c->how->warn(c->how->self, &w);
}

fmb_status fmb_io_charge(fmb_cursor *c, const char *p, size_t digits)
{
    if (digits > c->budget)
        return fmb_io_fail(c, p,
                           "expected smaller numbers: written out exactly, those up to here "
                           "need far more digits than the text has");
    c->budget -= digits;
    return FMB_OK;
}

size_t fmb_io_digits(mpq_srcptr q)
{
    size_t limbs = mpz_size(mpq_numref(q)) + mpz_size(mpq_denref(q));
    return limbs <= 2 ? 0 : limbs * (size_t)GMP_NUMB_BITS * 3 / 10;
}
