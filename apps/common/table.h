/* table.h: text in aligned columns. */
#ifndef APP_TABLE_H
#define APP_TABLE_H

#include <stddef.h>
#include <stdio.h>

#include "common/buffer.h"

/* The end of a cell in the text of all cells, and its width. */
typedef struct app_cell {
    size_t end, width;
} app_cell;

/* A column is left-aligned ('l') or right-aligned ('r'). Zero-initialise, but for columns and
 * align. */
typedef struct app_table {
    size_t columns;
    const char *align;
    app_cell *cell; /* row by row */
    size_t cells, capacity;
    app_buffer text; /* of all cells, one after another */
} app_table;

/* Append one cell; takes over text, which comes from malloc. */
void app_table_add(app_table *t, char *text);
/* End a cell that was appended to the text. Below: append a text and end the cell. */
void app_table_end_cell(app_table *t);
void app_table_put(app_table *t, const char *text);
/* Print and clear. Columns are one space apart; lines carry no trailing spaces. */
void app_table_print(app_table *t, FILE *out);
/* Free all cells. */
void app_table_clear(app_table *t);

#endif
