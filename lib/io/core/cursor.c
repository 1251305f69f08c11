/* cursor.c: moving over the text, and saying where it goes wrong; see cursor.h. */
#include <stdarg.h>
#include <string.h>

#include "base/sized.h"
#include "io/core/cursor.h"
#include "io/core/utf8.h"

/* Digits that any text may grow by, and more for each byte of it. */
#define BUDGET_BASE     30000000
#define BUDGET_PER_BYTE 100

/* ---- a text ---------------------------------------------------------------------------------- */

size_t fmb_io_budget(size_t size)
{
    bool fits = size < (SIZE_MAX - BUDGET_BASE) / BUDGET_PER_BYTE;
    return BUDGET_BASE + (fits ? BUDGET_PER_BYTE * size : 0);
}

fmb_cursor fmb_io_cursor(const char *text, size_t size, const fmb_reader *how, fmb_mem *mem,
                         fmb_where *where)
{
    fmb_cursor c = {.begin = text, .end = text + size, .how = how, .mem = mem, .where = where};
    if (size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0)
        c.begin += 3;
    c.at = c.mark = c.begin;
    c.line = 1;
    c.budget = fmb_io_budget(size);
    return c;
}

size_t fmb_io_max_bytes(const fmb_reader *how)
{
    return how && how->max_bytes > 0 ? how->max_bytes : FMB_READER_MAX_BYTES;
}

fmb_status fmb_io_fail_too_long(fmb_cursor *c, const char *p)
{
    return fmb_io_fail(c, p, "expected at most %zu bytes, the limit on what is read",
                       fmb_io_max_bytes(c->how));
}

/* Are all eight bytes from p on in 32 to 126? If so, their highest bits are 0, also after adding 1
 * to each, and setting the highest bit and subtracting 32 keeps it set; no byte borrows. */
static inline bool are_eight_plain(const char *p)
{
    const uint64_t each = 0x0101010101010101, high = 0x80 * each;
    uint64_t w;
    memcpy(&w, p, sizeof w);
    return ((w | (w + each) | ~((w | high) - 0x20 * each)) & high) == 0;
}

/* UTF-8 without NUL and control bytes other than tab and line ends. */
fmb_status fmb_io_check(fmb_cursor *c)
{
    for (const char *p = c->begin; p < c->end;) {
        if (c->end - p >= 8 && are_eight_plain(p)) {
            p += 8;
            continue;
        }
        unsigned char b = (unsigned char)*p;
        if (b == 0)
            return fmb_io_fail(c, p, "expected text, found a NUL byte");
        if ((b < 32 && (b < '\t' || b > '\r')) || b == 127)
            return fmb_io_fail(c, p, "expected text, found control byte 0x%02x", b);
        size_t n = b < 128 ? 1 : fmb_utf8_length(p, (size_t)(c->end - p));
        if (n == 0)
            return fmb_io_fail(c, p, "expected UTF-8 text, found byte 0x%02x", b);
        p += n;
    }
    return FMB_OK;
}

/* ---- moving ---------------------------------------------------------------------------------- */

static bool is_blank_in_line(int b)
{
    return b == ' ' || b == '\t' || b == '\r' || b == '\f' || b == '\v';
}

void fmb_skip_blanks(fmb_cursor *c)
{
    while (is_blank_in_line(fmb_peek(c)))
        c->at++;
}

void fmb_skip_space(fmb_cursor *c)
{
    while (is_blank_in_line(fmb_peek(c)) || fmb_peek(c) == '\n')
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
    while (fmb_peek(c) >= 0 && fmb_peek(c) != '\n' && !is_blank_in_line(fmb_peek(c)))
        c->at++;
    return (fmb_span){p, (size_t)(c->at - p)};
}

bool fmb_span_is(fmb_span w, const char *word)
{
    return strlen(word) == w.n && memcmp(w.p, word, w.n) == 0;
}

static int lower_ascii_letter(int b)
{
    return b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b;
}

bool fmb_span_is_nocase(fmb_span w, const char *word)
{
    size_t i = 0;
    while (i < w.n && word[i] && lower_ascii_letter(w.p[i]) == lower_ascii_letter(word[i]))
        i++;
    return i == w.n && !word[i];
}

/* The characters of [p, end) in quotes, cut short; '?' for what a terminal could obey. */
static const char *quote_cut_short(const char *p, const char *end, char buf[FMB_QUOTE])
{
    size_t n = 0, most = FMB_QUOTE - 6;
    buf[n++] = '\'';
    while (p < end) {
        size_t bytes = fmb_utf8_length(p, (size_t)(end - p));
        bool shown = fmb_utf8_printable(p, (size_t)(end - p)) > 0;
        bytes = bytes > 0 ? bytes : 1;
        if (n + bytes > most)
            break;
        for (size_t i = 0; i < bytes; i++)
            buf[n++] = shown ? p[i] : '?';
        p += bytes;
    }
    strcpy(buf + n, p < end ? "...'" : "'");
    return buf;
}

const char *fmb_quote(const fmb_cursor *c, const char *p, char buf[FMB_QUOTE])
{
    if (p >= c->end)
        return strcpy(buf, "end of file");
    if (*p == '\n' || *p == '\r')
        return strcpy(buf, "end of line");
    const char *end = p + 1;
    while (end < c->end && *end != '\n' && !is_blank_in_line(*end))
        end++;
    return quote_cut_short(p, end, buf);
}

const char *fmb_quote_name(const char *name, char buf[FMB_QUOTE])
{
    return quote_cut_short(name, name + strlen(name), buf);
}

/* ---- places and messages --------------------------------------------------------------------- */

/* Find line and column of p. The last line found is kept: looking up places in order takes one pass
 * over the text in total. */
static void find_line_and_column(fmb_cursor *c, const char *p, fmb_where *w)
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

static void fill_place_and_text(fmb_cursor *c, const char *p, fmb_where *w, const char *format,
                                va_list args)
{
    *w = (fmb_where){0};
    if (p)
        find_line_and_column(c, p, w);
    vsnprintf(w->text, sizeof w->text, format, args);
}

fmb_status fmb_io_fail(fmb_cursor *c, const char *p, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    fill_place_and_text(c, p, c->where, format, args);
    va_end(args);
    return FMB_ERR_PARSE;
}

fmb_status fmb_io_expected(fmb_cursor *c, const char *p, const char *format, ...)
{
    char found[FMB_QUOTE];
    fmb_where w;
    va_list args;
    va_start(args, format);
    vsnprintf(w.text, sizeof w.text, format, args);
    va_end(args);
    return fmb_io_fail(c, p, "expected %s, found %s", w.text, fmb_quote(c, p, found));
}

fmb_status fmb_io_take_reader(const fmb_reader *how, fmb_reader *ours, fmb_where *where)
{
    char why[sizeof where->text];
    return fmb_sized_take(ours, sizeof *ours, how, "how", why, sizeof why)
               ? FMB_OK
               : fmb_io_refuse_argument(where, why);
}

fmb_status fmb_io_refuse_argument(fmb_where *where, const char *error)
{
    if (where) {
        *where = (fmb_where){0};
        snprintf(where->text, sizeof where->text, "%s", error);
    }
    return FMB_ERR_ARG;
}

void fmb_io_warn(fmb_cursor *c, const char *p, const char *format, ...)
{
    if (!c->how->warn)
        return;
    fmb_where w;
    va_list args;
    va_start(args, format);
    fill_place_and_text(c, p, &w, format, args);
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
