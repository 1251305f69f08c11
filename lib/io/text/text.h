/* text.h: the .fmb format while it is read, and what reader and writer agree on.
 *
 * Grammar: docs/formats.md.
 */
#ifndef FMB_IO_TEXT_H
#define FMB_IO_TEXT_H

#include "io/core/io_private.h"
#include "io/core/number.h"

/* Parentheses inside parentheses. */
#define FMB_TEXT_DEPTH 200

/* What is said of a variable. */
typedef struct fmb_text_use {
    const char *at; /* where first */
    size_t times;
    int near_duplicate; /* scratch of fmb_text_warn_of_near_duplicates */
} fmb_text_use;

typedef struct fmb_text {
    fmb_cursor *c;
    fmb_system *s;
    bool declared;                /* a vars line was there: no other names */
    bool alone;                   /* a form by itself, over the variables of s: declared, too */
    fmb_draft left, right;        /* the two sides of a link; rhs is the constant on that side */
    fmb_draft row;                /* the link */
    const char *blank_product[2]; /* of the last expression: a factor and the first one behind it
                                     that only blanks separate, outside parentheses; or NULL */
    fmb_room name, label;         /* the last quoted ones */
    int *mark;                    /* variables of project and eliminate lines */
    size_t marks, mark_capacity;
    fmb_span asked;    /* "project" or "eliminate"; n == 0: neither */
    fmb_text_use *use; /* one a variable, unless they are declared */
    size_t use_capacity;
} fmb_text;

/* Bytes of the character at p if it can stand in a name without quotes (as its first), else 0. */
size_t fmb_text_name_char(const char *p, size_t left, bool first);
/* Is this the name of a line that is not a row? */
bool fmb_text_is_reserved(fmb_span label);

/* The name at c, its escapes undone. The span lives until the next name. Errors: PARSE, MEMORY. */
fmb_status fmb_text_scan_name(fmb_text *t, fmb_span *out);
/* The variable of that name, which stands at p. */
fmb_status fmb_text_variable(fmb_text *t, const char *p, fmb_span name, int *index);

/* Warns of variables that stand in the text once and look like a slip of another one. */
void fmb_text_warn_of_near_duplicates(const fmb_text *t);

/* Does a label say that a line without a relation is an objective, and which way it goes? NONE: it
 * does not. */
fmb_sense fmb_text_sense(fmb_span label);

/* The linear expression at c, up to what cannot belong to it, into d. */
fmb_status fmb_text_expression(fmb_text *t, fmb_draft *d);

#endif
