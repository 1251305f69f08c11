/* text_name.c: names of the .fmb format; see text.h.
 *
 * A name is letters, digits and _ . [ ] ' and may hold any UTF-8 character that is not punctuation
 * or an operator; any other name stands in quotes.
 */
#include <string.h>

#include "io/text.h"
#include "io/utf8.h"

static bool is_letter(int b)
{
    return (b >= 'a' && b <= 'z') || (b >= 'A' && b <= 'Z') || b == '_';
}

/* Punctuation and operators beyond ASCII that could be mistaken for parts of a name: U+0080-U+00BF,
 * the signs of multiplication and division, U+2000-U+203F, arrows and operators U+2180-U+22FF. */
static bool is_operator(const char *s)
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
        size_t n = fmb_utf8_length(p, left);
        return n > 0 && !is_operator(p) ? n : 0;
    }
    if (is_letter(*p))
        return 1;
    return !first && *p != '\0' && strchr("0123456789.[]'", *p) ? 1 : 0;
}

bool fmb_text_is_reserved(fmb_span label)
{
    return fmb_span_is(label, "vars") || fmb_span_is(label, "project") ||
           fmb_span_is(label, "eliminate");
}

static int hex(int b)
{
    return b >= '0' && b <= '9'   ? b - '0'
           : b >= 'a' && b <= 'f' ? b - 'a' + 10
           : b >= 'A' && b <= 'F' ? b - 'A' + 10
                                  : -1;
}

/* One byte of a quoted text, after a backslash. */
static fmb_status scan_escape(fmb_cursor *c, char *out)
{
    const char *p = c->at - 1;
    int b = fmb_peek(c);
    if (b == '"' || b == '\\') {
        *out = *c->at++;
        return FMB_OK;
    }
    if (b == 'x' && c->end - c->at >= 3) {
        int high = hex(c->at[1]), low = hex(c->at[2]);
        if (high >= 0 && low >= 0 && high + low > 0) {
            c->at += 3;
            *out = (char)(unsigned char)(16 * high + low);
            return FMB_OK;
        }
    }
    return fmb_io_fail(c, p, "expected \\\", \\\\ or \\x and two hexadecimal digits, not both 0");
}

fmb_status fmb_text_scan_quoted(fmb_text *t, fmb_text_room *room, fmb_span *out)
{
    fmb_cursor *c = t->c;
    const char *start = c->at++;
    size_t n = 0;
    for (;;) {
        int b = fmb_peek(c);
        if (b < 0 || b == '\n')
            return fmb_io_fail(c, start, "expected a closing quote on the same line");
        c->at++;
        if (b == '"')
            break;
        fmb_status st = fmb_mem_reserve(c->mem, (void **)&room->p, &room->capacity, n + 1, 1);
        char byte = (char)(unsigned char)b;
        if (st == FMB_OK && b == '\\')
            st = scan_escape(c, &byte);
        if (st != FMB_OK)
            return st;
        room->p[n++] = byte;
    }
    *out = (fmb_span){n > 0 ? room->p : start, n};
    return FMB_OK;
}

fmb_status fmb_text_scan_name(fmb_text *t, fmb_span *out)
{
    fmb_cursor *c = t->c;
    char found[FMB_QUOTE];
    const char *p = c->at;
    if (fmb_peek(c) == '"') {
        fmb_status st = fmb_text_scan_quoted(t, &t->name, out);
        return st == FMB_OK && out->n == 0 ? fmb_io_fail(c, p, "expected a name between the quotes")
                                           : st;
    }
    size_t n;
    while ((n = fmb_text_name_char(c->at, (size_t)(c->end - c->at), c->at == p)) > 0)
        c->at += n;
    if (c->at == p)
        return fmb_io_fail(c, p, "expected the name of a variable, found %s",
                           fmb_quote(c, p, found));
    *out = (fmb_span){p, (size_t)(c->at - p)};
    return FMB_OK;
}

fmb_status fmb_text_variable(fmb_text *t, const char *p, fmb_span name, int *index)
{
    char found[FMB_QUOTE];
    int j = -1;
    if (!t->declared)
        return fmb_span_variable(t->c, name, t->s, index);
    fmb_status st = fmb_span_find(t->c, name, t->s, &j);
    if (st == FMB_OK && j < 0)
        st = fmb_io_fail(t->c, p, "expected a variable of the vars line, found %s",
                         fmb_quote(t->c, p, found));
    if (st == FMB_OK)
        *index = j;
    return st;
}
