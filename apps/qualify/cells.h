/* cells.h: tables: how cells are filled, and what they look like elsewhere than in a text. */
#ifndef QUALIFY_CELLS_H
#define QUALIFY_CELLS_H

#include "common/table.h"

/* Add a cell, as printf. */
void qualify_cell(app_table *t, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The same for a number; "-" if it is not finite. */
void qualify_number_cell(app_table *t, const char *format, double x)
    __attribute__((format(printf, 2, 0)));
/* The first line: a title for each column. */
void qualify_titles(app_table *t, const char *const *title);

/* A field of a line of CSV: any text in quotes. */
void qualify_csv_text(FILE *f, const char *text);
void qualify_csv(FILE *f, const app_table *t);

#endif
