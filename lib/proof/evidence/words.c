/* words.c: lines of words; see words.h. */
#include "proof/evidence/words.h"

#include <stdarg.h>
#include <string.h>

#include "proof/evidence/form.h"

enum { BYTES_OF_POLL = 256 };

void fmb_words_init(fmb_words *w, FILE *in, fmb_mem *mem, const fmb_poll *poll, fmb_where *where)
{
    *w = (fmb_words){.in = in, .mem = mem, .poll = poll, .where = where, .at_line = 1, .at = 1};
    w->next = getc(in);
}

void fmb_words_clear(fmb_words *w)
{
    fmb_mem_put(w->mem, w->text, w->capacity, 1);
}

fmb_status fmb_words_expected(fmb_words *w, const char *what, ...)
{
    va_list args;
    *w->where = (fmb_where){.line = w->line, .column = w->column};
    int n = snprintf(w->where->text, sizeof w->where->text, "expected ");
    va_start(args, what);
    vsnprintf(w->where->text + n, sizeof w->where->text - (size_t)n, what, args);
    va_end(args);
    return FMB_ERR_PARSE;
}

/* ---- bytes ----------------------------------------------------------------------------------- */

static int take(fmb_words *w)
{
    int byte = w->next;
    w->is_cut = w->is_cut || (w->bytes++ % BYTES_OF_POLL == 0 && fmb_poll_ask(w->poll) != FMB_OK);
    w->next = w->is_cut ? EOF : getc(w->in);
    w->at++;
    if (byte == '\n') {
        w->at_line++;
        w->at = 1;
    }
    return byte;
}

/* Like fmb_words_expected, but at the next byte. */
static fmb_status expected_here(fmb_words *w, const char *what)
{
    w->line = w->at_line;
    w->column = w->at;
    return fmb_words_expected(w, "%s", what);
}

static fmb_status append(fmb_words *w, int byte)
{
    if (w->size == FMB_PROOF_WORD_MAX)
        return fmb_words_expected(w, "a word of at most %zu bytes", FMB_PROOF_WORD_MAX);
    FMB_TRY(FMB_RESERVE(w->mem, &w->text, &w->capacity, w->size + 2));
    w->text[w->size++] = (char)byte;
    w->text[w->size] = '\0';
    return FMB_OK;
}

bool fmb_words_is_bare(unsigned char byte)
{
    return byte > ' ' && byte != 0x7f && byte != '"' && byte != '#' && byte != '\\';
}

/* ---- words ----------------------------------------------------------------------------------- */

static int hex_digit(int byte)
{
    const char *digits = "0123456789abcdef", *at = byte > 0 ? strchr(digits, byte) : NULL;
    return at ? (int)(at - digits) : -1;
}

/* What follows a backslash. */
static fmb_status read_escape(fmb_words *w)
{
    int byte = w->next;
    if (byte != '"' && byte != '\\' && byte != 'x')
        return expected_here(w, "'\"', '\\' or 'x' after a backslash");
    take(w);
    if (byte != 'x')
        return append(w, byte);
    int value = 0;
    for (int i = 0; i < 2; i++) {
        int digit = hex_digit(w->next);
        if (digit < 0)
            return expected_here(w, "two digits 0-9a-f after \\x");
        value = 16 * value + digit;
        take(w);
    }
    return value ? append(w, value) : fmb_words_expected(w, "a name without NUL");
}

static bool is_control(int byte)
{
    return byte < ' ' || byte == 0x7f; /* EOF too */
}

static fmb_status read_quoted(fmb_words *w)
{
    w->quoted = true;
    take(w);
    while (w->next != '"') {
        if (is_control(w->next))
            return expected_here(w, "a closing '\"'");
        int byte = take(w);
        FMB_TRY(byte == '\\' ? read_escape(w) : append(w, byte));
    }
    take(w);
    return w->size > 0 ? FMB_OK : fmb_words_expected(w, "a name that is not empty");
}

static fmb_status read_bare(fmb_words *w)
{
    while (w->next != EOF && fmb_words_is_bare((unsigned char)w->next))
        FMB_TRY(append(w, take(w)));
    return w->size > 0 ? FMB_OK : expected_here(w, "a word");
}

static bool is_blank(int byte)
{
    return byte == ' ' || byte == '\t' || byte == '\r';
}

static bool ends_line(int byte)
{
    return byte == '\n' || byte == EOF;
}

fmb_status fmb_words_next(fmb_words *w)
{
    while (is_blank(w->next))
        take(w);
    if (w->next == '#')
        while (!ends_line(w->next))
            take(w);
    w->line = w->at_line;
    w->column = w->at;
    w->quoted = false;
    w->size = 0;
    FMB_TRY(FMB_RESERVE(w->mem, &w->text, &w->capacity, 1));
    w->text[0] = '\0';
    if (!ends_line(w->next)) {
        FMB_TRY(w->next == '"' ? read_quoted(w) : read_bare(w));
        if (!is_blank(w->next) && !ends_line(w->next))
            FMB_TRY(expected_here(w, "a blank"));
    }
    return ferror(w->in) ? FMB_ERR_IO : FMB_OK;
}

fmb_status fmb_words_line(fmb_words *w)
{
    fmb_status st;
    do {
        if (w->next == '\n')
            take(w);
        st = fmb_words_next(w);
    } while (st == FMB_OK && w->size == 0 && w->next != EOF);
    return st;
}

fmb_status fmb_words_end(fmb_words *w)
{
    FMB_TRY(fmb_words_next(w));
    return w->size > 0 ? fmb_words_expected(w, "the end of the line") : FMB_OK;
}

bool fmb_words_is(const fmb_words *w, const char *word)
{
    return !w->quoted && w->size > 0 && strcmp(w->text, word) == 0;
}

/* ---- numbers --------------------------------------------------------------------------------- */

/* Number of decimal digits at the beginning of p. */
static size_t digits(const char *p)
{
    return strspn(p, "0123456789");
}

fmb_status fmb_words_count(fmb_words *w, const char *what, size_t max, size_t *out)
{
    size_t value = 0, n = digits(w->text);
    bool good = n > 0 && n == w->size && !w->quoted;
    for (size_t i = 0; good && i < n; i++) {
        size_t digit = (size_t)(w->text[i] - '0');
        good = digit <= max && value <= (max - digit) / 10;
        value = 10 * value + digit;
    }
    if (!good || value == 0)
        return fmb_words_expected(w, "%s from 1 to %zu", what, max);
    *out = value;
    return FMB_OK;
}

fmb_status fmb_words_rational(fmb_words *w, mpq_t out)
{
    size_t sign = w->text[0] == '-', top = digits(w->text + sign), slash = sign + top;
    bool whole = w->text[slash] == '\0';
    size_t bottom = whole ? 0 : digits(w->text + slash + 1);
    bool good = !w->quoted && top > 0;
    if (!whole)
        good = good && w->text[slash] == '/' && bottom > 0 && slash + 1 + bottom == w->size;
    if (!good)
        return fmb_words_expected(w, "an exact number such as 7 or -12/5");
    mpq_set_str(out, w->text, 10);
    if (mpz_sgn(mpq_denref(out)) == 0) {
        mpq_set_ui(out, 0, 1);
        return fmb_words_expected(w, "a denominator that is not zero");
    }
    mpq_canonicalize(out);
    return FMB_OK;
}
