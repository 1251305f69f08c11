/* page.h: what studies found: one JSON object a study, and views of it.
 *
 * A study puts its numbers into its object; texts and tables, which show rows of that object, go to
 * standard output as they come. With a folder there are report.json, STUDY-NAME.csv for each table,
 * and what report.py makes of report.json: report.html, which holds all of it and nothing outside
 * itself, and the figures. Mistakes are reported at once, and remembered for the end.
 */
#ifndef QUALIFY_PAGE_H
#define QUALIFY_PAGE_H

#include <stdbool.h>
#include <stdio.h>

#include <jansson.h>

typedef struct qualify_page qualify_page;

/* folder may be NULL; it is made if it is not there. json: standard output gets nothing but one
 * JSON object, at the end. Never NULL. */
qualify_page *qualify_page_open(const char *folder, bool json);
/* Nothing went wrong so far. */
bool qualify_page_is_good(const qualify_page *g);
/* Write what is left to write; an exit code. */
int qualify_page_close(qualify_page *g);

/* What follows belongs to that study, until it ends. */
void qualify_page_begin(qualify_page *g, const char *study, const char *title);
/* How long it took; says so where the wall clock and the time of the processor differ. */
void qualify_page_end(qualify_page *g);
/* The JSON object of the study, which has "study", "title", "version", "commit", "machine" and
 * "page", the list of its texts and tables. */
json_t *qualify_page_json(qualify_page *g);
/* The study did not come to its end; key "complete" of its object. */
void qualify_page_interrupted(qualify_page *g);

/* A paragraph, as printf. */
void qualify_page_text(qualify_page *g, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* A column of a table. */
typedef struct qualify_column {
    const char *key;    /* of the rows, "fmb_over_sat.low" is within another: the name in CSV */
    const char *title;  /* elsewhere; NULL: only in CSV */
    const char *format; /* of a number, as printf takes a double; NULL: a text */
} qualify_column;

/* Show the array `rows` of the study's object, NULL ends the columns. Without a caption it is shown
 * as CSV alone. */
void qualify_page_table(qualify_page *g, const char *name, const char *caption,
                        const qualify_column *column, const char *rows);
/* One more file, STUDY-NAME, written by put(f, what); nothing without a folder. */
void qualify_page_file(qualify_page *g, const char *name, void (*put)(FILE *f, const void *what),
                       const void *what);

/* A field of a line of CSV: any text in quotes. */
void qualify_csv_text(FILE *f, const char *text);

#endif
