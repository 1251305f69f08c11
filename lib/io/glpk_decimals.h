/* glpk_decimals.h: the numbers of a text, so that GLPK's doubles lead back to what was written.
 *
 * Each number of the text is noted with the double GLPK makes of it. If two numbers of different
 * value have the same double, a look-up of that double fails rather than guess.
 *
 * Invariants: values are not negative (a sign is the caller's); slots is a power of two above twice
 * the number of entries.
 */
#ifndef FMB_IO_GLPK_DECIMALS_H
#define FMB_IO_GLPK_DECIMALS_H

#include "io/io.h"

typedef struct fmb_decimal {
    double value;
    fmb_span text;  /* without sign */
    fmb_span other; /* a number of another value and the same double; p NULL: none */
    bool known;     /* exact is worked out */
    mpq_t exact;
} fmb_decimal;

typedef struct fmb_decimals {
    fmb_cursor *c;
    fmb_decimal *entry;
    size_t entries, capacity;
    size_t *slot; /* entry + 1; 0 = free */
    size_t slots;
} fmb_decimals;

/* The table knows 1, which GLPK sets by itself. Errors: MEMORY. */
fmb_status fmb_decimals_init(fmb_decimals *t, fmb_cursor *c);
void fmb_decimals_clear(fmb_decimals *t);
/* Is the word a number by GLPK's syntax? */
bool fmb_decimals_is_number(fmb_span w);
/* Note a word that is a number. Errors: MEMORY, PARSE (so small that GLPK takes it for 0). */
fmb_status fmb_decimals_note(fmb_decimals *t, fmb_span w);
/* What the text says of this finite double. Errors: MEMORY, PARSE. */
fmb_status fmb_decimals_exact(fmb_decimals *t, double d, mpq_t out);
/* The word is a number of whole value. */
bool fmb_decimals_is_whole(fmb_span w);

#endif
