/* text.h: the state of reading the .fmb format, and rules that its reader and writer share.
 *
 * Grammar: docs/formats.md.
 */
#ifndef FMB_IO_TEXT_H
#define FMB_IO_TEXT_H

#include "io/core/io_private.h"
#include "io/core/number.h"

/* The deepest nesting of parentheses. */
#define FMB_TEXT_DEPTH 200

/* The uses of a variable in the text. */
typedef struct fmb_text_use {
    const char *at; /* the first one */
    size_t times;
    int near_duplicate; /* scratch of fmb_text_warn_of_near_duplicates */
} fmb_text_use;

typedef struct fmb_text {
    fmb_cursor *c;
    fmb_system *s;
    bool declared;                /* after a vars line: no other names are allowed */
    bool alone;                   /* a single form over the variables of s, which are declared */
    fmb_draft left, right;        /* the two sides of a link; rhs is the constant on that side */
    fmb_draft row;                /* the link */
    const char *blank_product[2]; /* in the last expression, outside parentheses: the first two
                                     factors with only blanks between them; or NULL */
    fmb_room name, label;         /* the last quoted ones */
    int *mark;                    /* variables of project and eliminate lines */
    size_t marks, mark_capacity;
    fmb_span asked;    /* "project" or "eliminate"; n == 0: neither */
    fmb_text_use *use; /* one per variable, unless they are declared */
    size_t use_capacity;
} fmb_text;

/* Bytes of the character at p if it can stand in a name without quotes (as its first), else 0. */
size_t fmb_text_name_char(const char *p, size_t left, bool first);
/* Does a name begin at c? */
static inline bool fmb_text_is_at_name(const fmb_cursor *c)
{
    return fmb_peek(c) == '"' || fmb_text_name_char(c->at, (size_t)(c->end - c->at), true) > 0;
}
/* Is this the name of a line that is not a row? */
bool fmb_text_is_reserved(fmb_span label);

/* The name at c, unescaped. The span is valid until the next name. Errors: PARSE, MEMORY. */
fmb_status fmb_text_scan_name(fmb_text *t, fmb_span *out);
/* The variable with this name, read at p. */
fmb_status fmb_text_variable(fmb_text *t, const char *p, fmb_span name, int *index);

/* Warns of variables that occur once in the text and look like a misspelling of another one. */
void fmb_text_warn_of_near_duplicates(const fmb_text *t);

/* The sense, if this label marks a line without a relation as an objective; else NONE. */
fmb_sense fmb_text_sense(fmb_span label);

/* Read the linear expression at c, up to the first text that cannot belong to it, into d. */
fmb_status fmb_text_expression(fmb_text *t, fmb_draft *d);

#endif
