/* name.c: names of the .fmb format; see text.h.
 *
 * A name is letters, digits and _ . [ ] ' and may hold any UTF-8 character that is not punctuation,
 * an operator or invisible; any other name stands in quotes.
 */
#include <string.h>

#include "io/core/cursor.h"
#include "io/core/utf8.h"
#include "io/text/text.h"

static bool is_name_letter(int b)
{
    return (b >= 'a' && b <= 'z') || (b >= 'A' && b <= 'Z') || b == '_';
}

/* Punctuation and operators beyond ASCII that could be mistaken for parts of a name: U+0080-U+00BF,
 * the signs of multiplication and division, U+2000-U+203F, arrows and operators U+2180-U+22FF. */
static bool is_unicode_operator(const char *s)
{
    const unsigned char *p = (const unsigned char *)s;
    return p[0] == 0xC2 || (p[0] == 0xC3 && (p[1] == 0x97 || p[1] == 0xB7)) ||
           (p[0] == 0xE2 && (p[1] == 0x80 || (p[1] >= 0x86 && p[1] <= 0x8B)));
}

size_t fmb_text_name_char(const char *p, size_t left, bool first)
{
    if (left == 0)
        return 0;
    if ((unsigned char)*p >= 128) {
        size_t n = fmb_utf8_printable(p, left);
        return n > 0 && !is_unicode_operator(p) ? n : 0;
    }
    if (is_name_letter(*p))
        return 1;
    return !first && *p != '\0' && strchr("0123456789.[]'", *p) ? 1 : 0;
}

bool fmb_text_is_reserved(fmb_span label)
{
    return fmb_span_is(label, "vars") || fmb_span_is(label, "project") ||
           fmb_span_is(label, "eliminate") || fmb_span_is(label, "integer");
}

fmb_status fmb_text_scan_name(fmb_text *t, fmb_span *out)
{
    fmb_cursor *c = t->c;
    const char *p = c->at;
    if (fmb_peek(c) == '"') {
        FMB_TRY(fmb_scan_quoted(c, &t->name, out));
        return out->n == 0 ? fmb_io_fail(c, p, "expected a name between the quotes") : FMB_OK;
    }
    size_t n;
    while ((n = fmb_text_name_char(c->at, (size_t)(c->end - c->at), c->at == p)) > 0)
        c->at += n;
    if (c->at == p)
        return fmb_io_expected(c, p, "the name of a variable");
    *out = (fmb_span){p, (size_t)(c->at - p)};
    return FMB_OK;
}

static fmb_status note_use_of_variable(fmb_text *t, const char *p, int j)
{
    size_t known = t->use_capacity;
    FMB_TRY(FMB_RESERVE(t->c->mem, &t->use, &t->use_capacity, (size_t)j + 1));
    memset(t->use + known, 0, (t->use_capacity - known) * sizeof *t->use);
    if (t->use[j].times++ == 0)
        t->use[j].at = p;
    return FMB_OK;
}

fmb_status fmb_text_variable(fmb_text *t, const char *p, fmb_span name, int *index)
{
    int j = -1;
    if (!t->declared) {
        FMB_TRY(fmb_span_variable(t->c, name, t->s, index));
        return note_use_of_variable(t, p, *index);
    }
    FMB_TRY(fmb_span_find(t->c, name, t->s, &j));
    if (j < 0)
        return fmb_io_expected(t->c, p, "a variable of the %s", t->alone ? "system" : "vars line");
    *index = j;
    return FMB_OK;
}
