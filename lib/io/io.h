/* io.h: inside of reading and writing: a cursor over the text, exact numbers, rows on their way in,
 * and the table of formats.
 *
 * A reader gets a cursor at the start of a text and an empty system, and returns FMB_OK,
 * FMB_ERR_MEMORY or FMB_ERR_PARSE (through fmb_io_fail, which says where and what was expected).
 * The text has been checked before: valid UTF-8, no NUL, no control bytes but blanks and line ends.
 * It need not end in NUL: look at c->at only while c->at < c->end (fmb_peek does).
 *
 * Cost: a short text must not become much memory. A number costs the digits that its exponent adds,
 * a row those that its common denominator adds; the sum is bounded by c->budget, a multiple of the
 * size of the text, and a text that spends more is malformed.
 */
#ifndef FMB_IO_IO_H
#define FMB_IO_IO_H

#include <fmb/gmp.h>
#include <fmb/io.h>

#include "base/mem.h"

/* ---- cursor ---------------------------------------------------------------------------------- */

/* at may be moved freely within [begin, end]; line and column are found only when they are asked
 * for. */
typedef struct fmb_cursor {
    const char *begin, *at, *end;
    const char *mark; /* start of line number `line`, at or before the last place asked for */
    long line;
    size_t budget; /* decimal digits that the text may still grow by */
    const fmb_reader *how;
    fmb_mem *mem;     /* scratch of the reader */
    fmb_where *where; /* never NULL */
} fmb_cursor;

/* A cursor at the start of a text, behind a byte order mark. */
fmb_cursor fmb_io_cursor(const char *text, size_t size, const fmb_reader *how, fmb_mem *mem,
                         fmb_where *where);
/* Is it text, as said above? Errors: PARSE. */
fmb_status fmb_io_check(fmb_cursor *c);

/* Next byte, or -1 at the end. */
static inline int fmb_peek(const fmb_cursor *c)
{
    return c->at < c->end ? (unsigned char)*c->at : -1;
}

/* Skip blanks within the line (space, tab, CR, FF, VT); line ends too. */
void fmb_skip_blanks(fmb_cursor *c);
void fmb_skip_space(fmb_cursor *c);
/* To the next line end (not past it); past it. */
void fmb_skip_line(fmb_cursor *c);
void fmb_next_line(fmb_cursor *c);

/* The text at c starts with this word / is now past it. Case matters. */
bool fmb_accept(fmb_cursor *c, const char *word);

/* A piece of the text. */
typedef struct fmb_span {
    const char *p;
    size_t n;
} fmb_span;

/* Bytes up to the next blank, line end or end (n may be 0). */
fmb_span fmb_scan_word(fmb_cursor *c);
/* The span is this word (case matters; or not). */
bool fmb_span_is(fmb_span w, const char *word);
bool fmb_span_is_nocase(fmb_span w, const char *word);
/* What a message quotes of a text at p: the word there, cut short, or "end of file", "end of line".
 * buf is returned. */
#define FMB_QUOTE 48
const char *fmb_quote(const fmb_cursor *c, const char *p, char buf[FMB_QUOTE]);

/* Malformed at p: fills *c->where and returns FMB_ERR_PARSE. Say what was expected, then what was
 * found: "expected a relation, found 'x'". */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
fmb_status
fmb_io_fail(fmb_cursor *c, const char *p, const char *format, ...);
/* The text as a whole (line and column 0). */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
fmb_status
fmb_io_fail_whole(fmb_cursor *c, const char *format, ...);
/* The text at p grows by that many decimal digits. Errors: PARSE (beyond the budget). */
fmb_status fmb_io_charge(fmb_cursor *c, const char *p, size_t digits);
/* Decimal digits of a rational, at least roughly; 0 for those that fit two machine words. */
size_t fmb_io_digits(mpq_srcptr q);
/* Something at p (NULL: the text as a whole) is ignored: tells how->warn. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
void fmb_io_warn(fmb_cursor *c, const char *p, const char *format, ...);

/* ---- numbers --------------------------------------------------------------------------------- */

enum {
    FMB_NUM_SIGN = 1,     /* "-1", "+1" */
    FMB_NUM_DECIMAL = 2,  /* "1.5", ".5", "1." */
    FMB_NUM_EXPONENT = 4, /* "1e3", "1E-3": only where digits follow the e */
    FMB_NUM_FRACTION = 8, /* "1/2": no blanks around '/', both parts as the other flags say, the
                             sign only in front; only where a digit follows the '/' */
    FMB_NUM_ALL = 15
};

/* The exact value of the number at c, canonical; c is then past it. what names it in messages ("a
 * coefficient"). Errors: PARSE (no number here, zero denominator, too many digits). */
fmb_status fmb_scan_number(fmb_cursor *c, int flags, const char *what, mpq_t out);
/* Digits of a count or index, at most max. Errors: PARSE. */
fmb_status fmb_scan_count(fmb_cursor *c, size_t max, const char *what, size_t *out);
/* Write q: "3", "-1/2". */
void fmb_print_q(FILE *out, mpq_srcptr q);

/* ---- rows on their way in -------------------------------------------------------------------- */

/* sum coef[k] x_var[k] REL rhs. coef[0..capacity) are initialised. */
typedef struct fmb_draft {
    int *var;
    mpq_t *coef;
    size_t n, capacity;
    mpq_t rhs;
    fmb_mem *mem;
} fmb_draft;

void fmb_draft_init(fmb_draft *d, fmb_mem *mem);
void fmb_draft_clear(fmb_draft *d);
/* No terms, right side 0. */
void fmb_draft_reset(fmb_draft *d);
/* Room for one more term: *slot is its coefficient (old value undefined), to be set by the caller;
 * equal variables are added up in the end. Errors: MEMORY. */
fmb_status fmb_draft_term(fmb_draft *d, int var, mpq_ptr *slot);
void fmb_draft_negate(fmb_draft *d);
/* Append the row to s; p is the place to blame if it outgrows the budget. Errors: MEMORY, PARSE. */
fmb_status fmb_draft_append(fmb_cursor *c, const char *p, const fmb_draft *d, fmb_rel rel,
                            fmb_system *s);

/* Append a variable, or find it, by a name that is a piece of text. Errors: MEMORY. */
fmb_status fmb_span_variable(fmb_cursor *c, fmb_span name, fmb_system *s, int *index);
/* Index of the variable of that name, or -1 in *index. Errors: MEMORY. */
fmb_status fmb_span_find(fmb_cursor *c, fmb_span name, const fmb_system *s, int *index);
/* Label of row i from a piece of text. Errors: MEMORY. */
fmb_status fmb_span_label(fmb_cursor *c, fmb_span label, fmb_system *s, size_t i);

/* A header may declare at most this many variables beyond one for each byte of the text. */
#define FMB_IO_FREE_VARIABLES 100000
/* n variables with default names, as a header at p declares. Errors: MEMORY, PARSE. */
fmb_status fmb_io_declare(fmb_cursor *c, const char *p, size_t n, fmb_system *s);

/* ---- formats --------------------------------------------------------------------------------- */

typedef fmb_status fmb_read_fn(fmb_cursor *c, fmb_system *s);
typedef fmb_status fmb_write_fn(const fmb_system *s, FILE *out);

/* One format. To add one: a line in formats.c. */
typedef struct fmb_codec {
    fmb_format format;
    const char *name;                   /* as in --format; ".name" is its ending */
    fmb_read_fn *read;                  /* NULL: this build lacks it, see needs */
    fmb_write_fn *write;                /* NULL: reading only */
    bool (*sniff)(const fmb_cursor *c); /* does the text look like it? c is at the start */
    const char *needs;                  /* what a build without read lacks: "GLPK" */
} fmb_codec;

/* Entry of a format; NULL for AUTO and nonsense. */
const fmb_codec *fmb_codec_of(fmb_format f);
/* By content; text for people (.fmb) if nothing else fits. */
const fmb_codec *fmb_codec_guess(const fmb_cursor *c);

fmb_read_fn fmb_read_text, fmb_read_ine, fmb_read_ieq;
fmb_write_fn fmb_write_text, fmb_write_ine;
/* smt2_*.c, write_smt2.c; glpk_*.c (only where FMB_HAVE_GLPK is defined) */
fmb_read_fn fmb_read_smt2, fmb_read_mps, fmb_read_lp;
fmb_write_fn fmb_write_smt2;

#endif
