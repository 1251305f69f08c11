/* text.h: the .fmb format while it is read, and what reader and writer agree on.
 *
 * Grammar: docs/formats.md.
 */
#ifndef FMB_IO_TEXT_H
#define FMB_IO_TEXT_H

#include "io/io.h"

/* Parentheses inside parentheses. */
#define FMB_TEXT_DEPTH 200

/* Room for a name or label with its escapes undone. */
typedef struct fmb_text_room {
    char *p;
    size_t capacity;
} fmb_text_room;

typedef struct fmb_text {
    fmb_cursor *c;
    fmb_system *s;
    bool declared;             /* a vars line was there: no other names */
    fmb_draft left, right;     /* the two sides of a link; rhs is the constant on that side */
    fmb_draft row;             /* the link */
    fmb_text_room name, label; /* the last quoted ones */
    int *mark;                 /* variables of project and eliminate lines */
    size_t marks, mark_capacity;
    fmb_span asked; /* "project" or "eliminate"; n == 0: neither */
} fmb_text;

/* Bytes of the character at p if it can stand in a name without quotes (as its first), else 0. */
size_t fmb_text_name_char(const char *p, size_t left, bool first);
/* Is this the name of a line that is not a row? */
bool fmb_text_is_reserved(fmb_span label);

/* The name at c, its escapes undone. The span lives until the next name. Errors: PARSE, MEMORY. */
fmb_status fmb_text_scan_name(fmb_text *t, fmb_span *out);
/* The quoted text at c; lives until room is used again. Errors: PARSE, MEMORY. */
fmb_status fmb_text_scan_quoted(fmb_text *t, fmb_text_room *room, fmb_span *out);
/* The variable of that name, which stands at p. */
fmb_status fmb_text_variable(fmb_text *t, const char *p, fmb_span name, int *index);

/* The linear expression at c, up to what cannot belong to it, into d. */
fmb_status fmb_text_expression(fmb_text *t, fmb_draft *d);

#endif
