/* quote.h: names and labels in quotes: \" is a quote, \\ a backslash, \x41 a byte other than 0. Any
 * text can be written so on one line, in UTF-8 that a terminal may show.
 */
#ifndef FMB_IO_QUOTE_H
#define FMB_IO_QUOTE_H

#include "io/core/cursor.h"

/* Room for a text with its escapes undone; the owner frees p. */
typedef struct fmb_room {
    char *p;
    size_t capacity;
} fmb_room;

/* The quoted text at c, on one line; it lives until room is used again. Errors: PARSE, MEMORY. */
fmb_status fmb_scan_quoted(fmb_cursor *c, fmb_room *room, fmb_span *out);
/* text in quotes, with escapes for quotes, backslashes, control characters and what is not UTF-8.
 */
void fmb_print_quoted(const char *text, FILE *out);

#endif
