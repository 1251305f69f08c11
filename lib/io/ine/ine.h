/* ine.h: the state of reading a cddlib/lrslib file: the options of its lines are kept until all
 * rows have been read.
 */
#ifndef FMB_IO_INE_H
#define FMB_IO_INE_H

#include "io/core/io_private.h"

/* A number of a list, and its place in the text. */
typedef struct fmb_ine_item {
    size_t index; /* from 1 */
    const char *at;
} fmb_ine_item;

typedef struct fmb_ine_list {
    fmb_ine_item *item;
    size_t size, capacity;
} fmb_ine_list;

typedef struct fmb_ine {
    fmb_cursor *c;
    fmb_system *s;
    fmb_ine_list linear, strict; /* rows */
    fmb_ine_list marks;          /* variables of the project or eliminate line */
    const char *asked;           /* the place of that line, or NULL */
    const char *matrix;          /* the line "begin" */
    bool marks_keep;             /* that line was project */
    bool generators;             /* rows are vertices and rays: (1, x) and (0, x) */
    fmb_sense sense;
    const char *objective; /* after the word maximize or minimize; NULL: there is none */
} fmb_ine;

/* Reads the line at c if it is an option in the table; *known: it was. c is then at the start of a
 * line. */
fmb_status fmb_ine_option(fmb_ine *f, bool *known);
/* Read the whole text; a row (b, a) of the matrix becomes -a.x <= b, or = where it is on the
 * linearity line. */
fmb_status fmb_ine_read(fmb_ine *f);
/* Read a number that ends at a blank or an end. Errors: PARSE. */
fmb_status fmb_ine_number(fmb_cursor *c, mpq_t out);
/* Skip the arguments of an option: the rest of this line, and lines of numbers. */
void fmb_ine_skip_arguments(fmb_cursor *c);
/* Read names and labels from comments before the matrix, once rows and variables are known. Errors:
 * MEMORY. */
fmb_status fmb_ine_take_names(fmb_ine *f);
/* Apply the options that were read, once rows and variables are known. */
fmb_status fmb_ine_finish(fmb_ine *f);
void fmb_ine_clear(fmb_ine *f);

#endif
