/* json.c: see json.h. Source: RFC 8259. */
#include "io/frames/json.h"

#include <string.h>

#include "io/core/cursor.h"
#include "io/core/number.h"

static fmb_status fail_expecting_json(fmb_cursor *c, const char *what)
{
    return fmb_io_expected(c, c->at, "%s", what);
}

/* ---- strings --------------------------------------------------------------------------------- */

/* Bytes of the escape at p, 0 if it is none. */
static size_t escape_length(const char *p, const char *end)
{
    if (end - p < 2 || !memchr("\"\\/bfnrtu", p[1], 9))
        return 0;
    if (p[1] != 'u')
        return 2;
    for (int i = 2; i < 6; i++)
        if (p + i >= end || fmb_hex_value(p[i]) < 0)
            return 0;
    return 6;
}

fmb_status fmb_json_string(fmb_cursor *c, const char *what, fmb_span *out)
{
    fmb_json_blanks(c);
    if (fmb_peek(c) != '"')
        return fail_expecting_json(c, what);
    const char *start = ++c->at;
    while (fmb_peek(c) != '"') {
        size_t n = fmb_peek(c) == '\\' ? escape_length(c->at, c->end) : fmb_peek(c) >= 32;
        if (n == 0)
            return fail_expecting_json(c, fmb_peek(c) == '\\' ? "an escape of JSON"
                                                              : "a character or '\"'");
        c->at += n;
    }
    *out = (fmb_span){start, (size_t)(c->at++ - start)};
    return FMB_OK;
}

/* The character at p if it is ASCII, else -1; escapes have been checked. */
static int decode_ascii_character(const char *p)
{
    static const char letters[] = "bfnrt\"\\/", meanings[] = "\b\f\n\r\t\"\\/";
    if (*p != '\\')
        return (unsigned char)*p < 128 ? *p : -1;
    if (p[1] != 'u')
        return meanings[strchr(letters, p[1]) - letters];
    int code = 0;
    for (int i = 2; i < 6; i++)
        code = 16 * code + fmb_hex_value(p[i]);
    return code < 128 ? code : -1;
}

bool fmb_json_spells(fmb_span text, const char *word)
{
    const char *p = text.p, *end = text.p + text.n;
    for (; p < end && *word && (*p == *word || decode_ascii_character(p) == *word); word++)
        p += *p == '\\' ? escape_length(p, end) : 1;
    return p == end && !*word;
}

/* ---- numbers --------------------------------------------------------------------------------- */

static const char *find_end_of_digits(const fmb_cursor *c, const char *p)
{
    while (p < c->end && fmb_is_digit(*p))
        p++;
    return p;
}

/* The end of the number at c, NULL if there is none. JSON is stricter than other formats: no sign
 * but '-', digits on both sides of the point and behind an e, no zeros in front. */
static const char *find_end_of_number(const fmb_cursor *c)
{
    const char *p = c->at + (fmb_peek(c) == '-'), *q = find_end_of_digits(c, p);
    if (q == p || (*p == '0' && q > p + 1))
        return NULL;
    p = q;
    if (p < c->end && *p == '.') {
        q = find_end_of_digits(c, ++p);
        if (q == p)
            return NULL;
        p = q;
    }
    if (p < c->end && (*p == 'e' || *p == 'E')) {
        p++;
        p += p < c->end && (*p == '+' || *p == '-');
        q = find_end_of_digits(c, p);
        if (q == p)
            return NULL;
    }
    return q;
}

static fmb_status scan_quoted_rational(fmb_cursor *c, const char *what, mpq_t out)
{
    c->at++;
    FMB_TRY(fmb_scan_number(c, FMB_NUM_ALL, what, out));
    if (fmb_peek(c) != '"')
        return fail_expecting_json(c, "'\"' behind a number");
    c->at++;
    return FMB_OK;
}

fmb_status fmb_json_number(fmb_cursor *c, const char *what, mpq_t out)
{
    fmb_json_blanks(c);
    if (fmb_peek(c) == '"')
        return scan_quoted_rational(c, what, out);
    if (!find_end_of_number(c))
        return fail_expecting_json(c, what);
    return fmb_scan_number(c, FMB_NUM_SIGN | FMB_NUM_DECIMAL | FMB_NUM_EXPONENT, what, out);
}

/* ---- arrays and objects ---------------------------------------------------------------------- */

/* Items between an opening and a closing byte, with commas between them. */
static fmb_status read_bracketed_list(fmb_cursor *c, const char *what, const char brackets[2],
                                      fmb_json_read *item, void *self)
{
    fmb_json_blanks(c);
    if (fmb_peek(c) != brackets[0])
        return fail_expecting_json(c, what);
    c->at++;
    fmb_json_blanks(c);
    bool more = fmb_peek(c) != brackets[1];
    while (more) {
        FMB_TRY(item(self, c));
        fmb_json_blanks(c);
        more = fmb_peek(c) == ',';
        c->at += more;
    }
    if (fmb_peek(c) != brackets[1])
        return fail_expecting_json(c, brackets[1] == ']' ? "',' or ']'" : "',' or '}'");
    c->at++;
    return FMB_OK;
}

fmb_status fmb_json_array(fmb_cursor *c, const char *what, fmb_json_read *item, void *self)
{
    return read_bracketed_list(c, what, "[]", item, self);
}

typedef struct members {
    const fmb_json_key *key;
    size_t n;
    void *self;
    unsigned *seen;
} members;

/* A key and its colon. */
static fmb_status read_key_and_colon(fmb_cursor *c, fmb_span *name)
{
    FMB_TRY(fmb_json_string(c, "a key in quotes", name));
    fmb_json_blanks(c);
    if (fmb_peek(c) != ':')
        return fail_expecting_json(c, "':'");
    c->at++;
    return FMB_OK;
}

static fmb_status read_known_member(void *self, fmb_cursor *c)
{
    const members *m = self;
    fmb_span name;
    fmb_json_blanks(c);
    const char *p = c->at;
    FMB_TRY(read_key_and_colon(c, &name));
    size_t k = 0;
    while (k < m->n && !fmb_json_spells(name, m->key[k].name))
        k++;
    if (k == m->n)
        return fmb_json_skip(c);
    if (*m->seen >> k & 1)
        return fmb_io_fail(c, p, "expected one \"%s\", found another", m->key[k].name);
    *m->seen |= 1u << k;
    fmb_json_blanks(c);
    return m->key[k].read(m->self, c);
}

fmb_status fmb_json_object(fmb_cursor *c, const char *what, const fmb_json_key *key, size_t n,
                           void *self, unsigned *seen)
{
    members m = {key, n, self, seen};
    *seen = 0;
    return read_bracketed_list(c, what, "{}", read_known_member, &m);
}

/* ---- values that do not count ---------------------------------------------------------------- */

bool fmb_json_null(fmb_cursor *c)
{
    fmb_json_blanks(c);
    return fmb_accept(c, "null");
}

static fmb_status skip_json_value(void *self, fmb_cursor *c);

/* Any member of an object at this depth. */
static fmb_status skip_member_value(void *self, fmb_cursor *c)
{
    fmb_span name;
    FMB_TRY(read_key_and_colon(c, &name));
    return skip_json_value(self, c);
}

/* self points to the depth. */
static fmb_status skip_json_value(void *self, fmb_cursor *c)
{
    int depth = *(const int *)self + 1;
    fmb_span text;
    fmb_json_blanks(c);
    int b = fmb_peek(c);
    if ((b == '{' || b == '[') && depth > FMB_JSON_DEPTH)
        return fmb_io_fail(c, c->at, "expected at most %d brackets inside each other",
                           FMB_JSON_DEPTH);
    if (b == '{')
        return read_bracketed_list(c, "an object", "{}", skip_member_value, &depth);
    if (b == '[')
        return read_bracketed_list(c, "an array", "[]", skip_json_value, &depth);
    if (b == '"')
        return fmb_json_string(c, "a string", &text);
    if (fmb_accept(c, "true") || fmb_accept(c, "false") || fmb_accept(c, "null"))
        return FMB_OK;
    const char *end = find_end_of_number(c);
    if (!end)
        return fail_expecting_json(c, "a value");
    c->at = end;
    return FMB_OK;
}

fmb_status fmb_json_skip(fmb_cursor *c)
{
    int depth = 0;
    return skip_json_value(&depth, c);
}
