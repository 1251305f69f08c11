/* cursor.h: a position in a text, with errors and warnings that name line and column.
 *
 * The text has been checked before (fmb_io_check): valid UTF-8, no NUL, no control bytes but blanks
 * and line ends. It need not end in NUL: read c->at only while c->at < c->end (fmb_peek does).
 *
 * Budget: a short text must not take much memory. A number is charged with the digits that its
 * exponent adds, a row with those that its common denominator adds; the sum is bounded by
 * c->budget, a multiple of the size of the text, and a text that exceeds it is malformed.
 */
#ifndef FMB_IO_CURSOR_H
#define FMB_IO_CURSOR_H

#include <fmb/gmp.h>
#include <fmb/io.h>

#include "base/mem.h"
#include <stdbool.h>

/* ---- bytes, whatever the locale -------------------------------------------------------------- */

static inline bool fmb_is_digit(int b)
{
    return b >= '0' && b <= '9';
}

/* Value of a hexadecimal digit, or -1. */
static inline int fmb_hex_value(int b)
{
    int letter = b | 32;
    return fmb_is_digit(b) ? b - '0' : letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : -1;
}

/* Can a signed number begin with this byte? */
static inline bool fmb_starts_number(int b)
{
    return fmb_is_digit(b) || b == '+' || b == '-' || b == '.';
}

/* at may be moved freely within [begin, end]; line and column are found only when they are asked
 * for. */
typedef struct fmb_cursor {
    const char *begin, *at, *end;
    const char *mark; /* start of line number `line`, at or before the last place looked up */
    long line;
    size_t tokens; /* read so far, by a lexer that counts them */
    size_t budget; /* decimal digits that the text may still grow by */
    const fmb_reader *how;
    fmb_mem *mem;     /* scratch of the reader */
    fmb_where *where; /* never NULL */
} fmb_cursor;

/* The budget for the numbers of a text of so many bytes [digits]. */
size_t fmb_io_budget(size_t size);
/* A cursor at the start of a text, after a byte order mark if there is one. */
fmb_cursor fmb_io_cursor(const char *text, size_t size, const fmb_reader *how, fmb_mem *mem,
                         fmb_where *where);
/* The size limit of a reader, which may be NULL; an error that the text is longer (PARSE). */
size_t fmb_io_max_bytes(const fmb_reader *how);
fmb_status fmb_io_fail_too_long(fmb_cursor *c, const char *p);
/* Check that it is text as described above. Errors: PARSE. */
fmb_status fmb_io_check(fmb_cursor *c);

/* Next byte, or -1 at the end. */
static inline int fmb_peek(const fmb_cursor *c)
{
    return c->at < c->end ? (unsigned char)*c->at : -1;
}

/* Skip blanks within the line (space, tab, CR, FF, VT); line ends too. */
void fmb_skip_blanks(fmb_cursor *c);
void fmb_skip_space(fmb_cursor *c);
/* Move to the next line end (not past it). Below: past it. */
void fmb_skip_line(fmb_cursor *c);
void fmb_next_line(fmb_cursor *c);

/* If the text at c starts with this word, move past it. Case matters. */
bool fmb_accept(fmb_cursor *c, const char *word);

/* A piece of the text. */
typedef struct fmb_span {
    const char *p;
    size_t n;
} fmb_span;

/* Bytes up to the next blank, line end or end (n may be 0). */
fmb_span fmb_scan_word(fmb_cursor *c);
/* Is the span this word? The second function ignores case. */
bool fmb_span_is(fmb_span w, const char *word);
bool fmb_span_is_nocase(fmb_span w, const char *word);
/* The quotation of the text at p for a message: the word there, shortened, or "end of file", "end
 * of line". Returns buf. */
#define FMB_QUOTE 48
const char *fmb_quote(const fmb_cursor *c, const char *p, char buf[FMB_QUOTE]);
/* Like the function above, for a name. */
const char *fmb_quote_name(const char *name, char buf[FMB_QUOTE]);

/* Malformed at p (NULL: as a whole): fills *c->where and returns FMB_ERR_PARSE. The second function
 * completes "a relation" to "expected a relation, found 'x'". */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
fmb_status
fmb_io_fail(fmb_cursor *c, const char *p, const char *format, ...);
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
fmb_status
fmb_io_expected(fmb_cursor *c, const char *p, const char *format, ...);
/* Returns ARG; *where (may be NULL) gets the reason. */
fmb_status fmb_io_refuse_argument(fmb_where *where, const char *error);
/* Copy the given reader, or the default one. Errors: ARG, with the reason in *where. */
fmb_status fmb_io_take_reader(const fmb_reader *how, fmb_reader *ours, fmb_where *where);
/* Charge the budget with so many decimal digits for the text at p. Errors: PARSE (exceeded). */
fmb_status fmb_io_charge(fmb_cursor *c, const char *p, size_t digits);
/* Roughly the decimal digits of a rational; 0 if it fits two machine words. */
size_t fmb_io_digits(mpq_srcptr q);
/* Warn through how->warn that something at p (NULL: in the whole text) is ignored. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
void fmb_io_warn(fmb_cursor *c, const char *p, const char *format, ...);

#endif
