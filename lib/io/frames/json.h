/* json.h: JSON while it is read: one value on one line, strictly (RFC 8259), on a cursor.
 *
 * Objects are read by tables of keys. A key that is in the table may come once; other members are
 * passed over, whatever they hold. All functions fail with PARSE, at the place that is wrong, or
 * with what a reader of the caller's returns.
 */
#ifndef FMB_IO_JSON_H
#define FMB_IO_JSON_H

#include "io/core/io_private.h"

/* Objects and arrays inside each other, where they are passed over. */
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

/* "...": what stands between the quotes, its escapes not undone. */
fmb_status fmb_json_string(fmb_cursor *c, const char *what, fmb_span *out);
/* Does it spell the ASCII word, which has no backslash, with its escapes undone? */
bool fmb_json_spells(fmb_span text, const char *word);

/* The exact value of a number, or of a rational in a string ("-1/3"). */
fmb_status fmb_json_number(fmb_cursor *c, const char *what, mpq_t out);

/* Is null here? c is then past it. */
bool fmb_json_null(fmb_cursor *c);
/* Any value. */
fmb_status fmb_json_skip(fmb_cursor *c);
#endif
