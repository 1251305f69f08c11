/* html.h: the pieces of a report that a browser shows. They need no other file. */
#ifndef QUALIFY_HTML_H
#define QUALIFY_HTML_H

#include <stdbool.h>

#include "common/table.h"

void qualify_html_head(FILE *f, const char *title);
void qualify_html_foot(FILE *f);

/* Any text, so that it stands for itself. */
void qualify_html_text(FILE *f, const char *text);
void qualify_html_paragraph(FILE *f, const char *text);
/* The first line of t are the titles. csv: the name of a file beside the report with the same, or
 * NULL. */
void qualify_html_table(FILE *f, const char *caption, const app_table *t, const char *csv);
/* The picture at path; name is that of the .svg and .png beside the report. Whether it could be
 * read. */
bool qualify_html_figure(FILE *f, const char *caption, const char *path, const char *name);

#endif
