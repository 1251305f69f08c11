/* page.h: the results of studies: one JSON object for each study, and views of it.
 *
 * A study puts its numbers into its object; texts and tables, which show rows of that object, go to
 * standard output at once. With a folder, report.json, STUDY-NAME.csv for each table, and from
 * report.json, by report.py, a self-contained report.html and the figures are written. Errors are
 * reported at once, and remembered for the exit code.
 */
#ifndef QUALIFY_PAGE_H
#define QUALIFY_PAGE_H

#include <stdbool.h>
#include <stdio.h>

#include <jansson.h>

typedef struct qualify_page qualify_page;

/* folder may be NULL; it is made if it does not exist. json: standard output gets only one JSON
 * object, at the end. Never NULL. */
qualify_page *qualify_page_open(const char *folder, bool json);
/* Nothing went wrong so far. */
bool qualify_page_is_good(const qualify_page *g);
/* Write the remaining files; an exit code. */
int qualify_page_close(qualify_page *g);

/* Begin a study: all following calls add to it, until qualify_page_end. */
void qualify_page_begin(qualify_page *g, const char *study, const char *title);
/* End the study: add its times, and a warning if the processor was busy with other work. */
void qualify_page_end(qualify_page *g);
/* The JSON object of the study, which has "study", "title", "version", "commit", "machine" and
 * "page", the list of its texts and tables. */
json_t *qualify_page_json(qualify_page *g);
/* The study was interrupted: sets the key "complete" of its object. */
void qualify_page_interrupted(qualify_page *g);

/* A paragraph, formatted as by printf. */
void qualify_page_text(qualify_page *g, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* A column of a table. */
typedef struct qualify_column {
    const char *key;    /* of the rows, "fmb_over_sat.low" is within another: the name in CSV */
    const char *title;  /* in other views; NULL: only in CSV */
    const char *format; /* of a number, as printf takes a double; NULL: a text */
} qualify_column;

/* Show the array `rows` of the study's object; NULL ends the columns. Without a caption it is
 * written as CSV only. */
void qualify_page_table(qualify_page *g, const char *name, const char *caption,
                        const qualify_column *column, const char *rows);
/* An additional file, STUDY-NAME, written by put(f, what); no file without a folder. */
void qualify_page_file(qualify_page *g, const char *name, void (*put)(FILE *f, const void *what),
                       const void *what);

/* Write a field of a line of CSV: any text, quoted. */
void qualify_csv_text(FILE *f, const char *text);

#endif
