/* number.h: exact numbers from and to text, and quoted texts. */
#ifndef FMB_IO_NUMBER_H
#define FMB_IO_NUMBER_H

#include "io/core/cursor.h"

enum {
    FMB_NUM_SIGN = 1,     /* "-1", "+1" */
    FMB_NUM_DECIMAL = 2,  /* "1.5", ".5", "1." */
    FMB_NUM_EXPONENT = 4, /* "1e3", "1E-3": only where digits follow the e */
    FMB_NUM_FRACTION = 8, /* "1/2": no blanks around '/', both parts as the other flags say, the
                             sign only in front; only where a digit follows the '/' */
    FMB_NUM_ALL = 15,
    FMB_NUM_FORTRAN = 16 /* the e of an exponent may be a d: "1.0D3" */
};

/* The exact value of the number at c, canonical; c is then past it. what names it in messages ("a
 * coefficient"). Errors: PARSE (no number here, zero denominator, too many digits). */
fmb_status fmb_scan_number(fmb_cursor *c, int flags, const char *what, mpq_t out);
/* The double nearest to q, ties to even; infinite beyond the largest. *exact: it equals q. */
double fmb_io_nearest(mpq_srcptr q, bool *exact);
/* The double nearest to the number at c, with sign, point and exponent. Errors: PARSE (as above,
 * beyond all doubles). */
fmb_status fmb_scan_nearest(fmb_cursor *c, const char *what, double *out);
/* Read a count or index, at most max. Errors: PARSE. */
fmb_status fmb_scan_count(fmb_cursor *c, size_t max, const char *what, size_t *out);
/* Write q: "3", "-1/2". */
void fmb_print_q(FILE *out, mpq_srcptr q);

/* ---- names and labels in quotes ----------------------------------------------------------------
 *
 * \" is a quote, \\ a backslash, \x41 a byte other than 0. So any text can be written on one line,
 * in UTF-8 that is safe on a terminal. */

/* A buffer for an unescaped text; the owner frees p. */
typedef struct fmb_room {
    char *p;
    size_t capacity;
} fmb_room;

/* The quoted text at c, on one line; it lives until room is used again. Errors: PARSE, MEMORY. */
fmb_status fmb_scan_quoted(fmb_cursor *c, fmb_room *room, fmb_span *out);
/* Write text in quotes; quotes, backslashes, control characters and invalid UTF-8 are escaped. */
void fmb_print_quoted(const char *text, FILE *out);

#endif
