/* page.h: what studies found, in all its forms at once.
 *
 * A study adds texts, tables, figures and numbers. Texts and tables go to standard output as they
 * come, numbers into one JSON object a study. With a folder there are report.html, which holds all
 * of it and nothing outside itself, report.json, STUDY-NAME.csv for each table, and STUDY-NAME.dat,
 * .gp, .svg and .png for each figure. Mistakes are reported at once, and remembered for the end.
 */
#ifndef QUALIFY_PAGE_H
#define QUALIFY_PAGE_H

#include <stdbool.h>
#include <stdio.h>

#include <jansson.h>

#include "qualify/cells.h"

typedef struct qualify_page qualify_page;

/* folder may be NULL; it is made if it is not there. json: standard output gets nothing but one
 * JSON object, at the end. Never NULL. */
qualify_page *qualify_page_open(const char *folder, bool json);
/* Nothing went wrong so far. */
bool qualify_page_is_good(const qualify_page *g);
/* Write what is left to write; an exit code. */
int qualify_page_close(qualify_page *g);

/* What follows belongs to that study, until the next one begins. */
void qualify_page_begin(qualify_page *g, const char *study, const char *title);
/* The JSON object of the study, which has "study", "version", "machine", "compiler", "flags" and
 * "commit". */
json_t *qualify_page_json(qualify_page *g);
/* The study did not come to its end; key "complete" of its object. */
void qualify_page_interrupted(qualify_page *g);

/* A paragraph, as printf. */
void qualify_page_text(qualify_page *g, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
/* The first line of t are the titles. Clears t. */
void qualify_page_table(qualify_page *g, const char *name, const char *caption, app_table *t);

/* A figure: lines of data, missing numbers written "-", and the gnuplot commands that plot them;
 * there, the string variable `data` is the name of the file that holds them. */
typedef struct qualify_figure {
    FILE *data, *script; /* to be written to */
    char *data_text, *script_text;
    size_t data_size, script_size;
} qualify_figure;

void qualify_figure_begin(qualify_figure *f);
/* Ends f. Without a folder nothing is drawn; what cannot be drawn is said. */
void qualify_page_figure(qualify_page *g, const char *name, const char *caption, qualify_figure *f);
/* One more file, STUDY-NAME, written by put(f, what); nothing without a folder. */
void qualify_page_file(qualify_page *g, const char *name, void (*put)(FILE *f, const void *what),
                       const void *what);

#endif
