/* json.h: a strict JSON reader (RFC 8259) on a cursor, for one value on one line.
 *
 * Objects are read by tables of keys. A key in the table may occur once; other members are skipped.
 * All functions fail with PARSE, at the place of the error, or with the error of a reader in the
 * table.
 */
#ifndef FMB_IO_JSON_H
#define FMB_IO_JSON_H

#include "io/core/io_private.h"

/* The deepest nesting of objects and arrays in skipped values. */
#define FMB_JSON_DEPTH 100

static inline void fmb_json_blanks(fmb_cursor *c)
{
    while (fmb_peek(c) == ' ' || fmb_peek(c) == '\t' || fmb_peek(c) == '\r')
        c->at++;
}

/* Reads one value at c. */
typedef fmb_status fmb_json_read(void *self, fmb_cursor *c);

typedef struct fmb_json_key {
    const char *name; /* ASCII */
    fmb_json_read *read;
} fmb_json_key;

/* {...}: what names it in messages ("a frame"). *seen gets bit k if key[k] was there; n <= 32. */
fmb_status fmb_json_object(fmb_cursor *c, const char *what, const fmb_json_key *key, size_t n,
                           void *self, unsigned *seen);
/* [...] */
fmb_status fmb_json_array(fmb_cursor *c, const char *what, fmb_json_read *item, void *self);

/* "...": the text between the quotes, with its escapes. */
fmb_status fmb_json_string(fmb_cursor *c, const char *what, fmb_span *out);
/* Is text, unescaped, this ASCII word, which has no backslash? */
bool fmb_json_spells(fmb_span text, const char *word);

/* The exact value of a number, or of a rational in a string ("-1/3"). */
fmb_status fmb_json_number(fmb_cursor *c, const char *what, mpq_t out);

/* Is there a null at c? Then move past it. */
bool fmb_json_null(fmb_cursor *c);
/* Skip any value. */
fmb_status fmb_json_skip(fmb_cursor *c);
#endif
