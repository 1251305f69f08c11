/* table.h: text in aligned columns. */
#ifndef APP_TABLE_H
#define APP_TABLE_H

#include <stddef.h>
#include <stdio.h>

/* A column is left-aligned ('l') or right-aligned ('r'); before is printed in front of each of its
 * cells. Zero-initialise, but for columns and align. */
typedef struct app_table {
    size_t columns;
    const char *align;
    char **cell; /* row by row, owned */
    size_t cells, capacity;
} app_table;

/* Append one cell; takes over text, which comes from malloc. */
void app_table_add(app_table *t, char *text);
/* Print and clear. Columns are one space apart; lines carry no trailing spaces. */
void app_table_print(app_table *t, FILE *out);
/* Free all cells. */
void app_table_clear(app_table *t);

#endif
