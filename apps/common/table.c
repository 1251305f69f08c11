/* table.c: see table.h. */
#include "common/table.h"

#include <stdlib.h>

#include "common/message.h"
#include "common/text.h"

void app_table_add(app_table *t, char *text)
{
    if (t->cells == t->capacity) {
        t->capacity = t->capacity ? 2 * t->capacity : 64;
        t->cell = app_need(realloc(t->cell, t->capacity * sizeof *t->cell));
    }
    t->cell[t->cells++] = text;
}

static size_t column_width(const app_table *t, size_t column)
{
    size_t widest = 0;
    for (size_t i = column; i < t->cells; i += t->columns) {
        size_t width = app_text_width(t->cell[i]);
        widest = width > widest ? width : widest;
    }
    return widest;
}

static void spaces(size_t n, FILE *out)
{
    while (n-- > 0)
        fputc(' ', out);
}

/* One line. Spaces are owed until there is something to print behind them. */
static void print_row(const app_table *t, char **cell, const size_t *width, FILE *out)
{
    size_t owed = 0;
    for (size_t c = 0; c < t->columns; c++) {
        size_t fill = width[c] - app_text_width(cell[c]);
        if (t->align[c] == 'r')
            owed += fill;
        if (*cell[c]) {
            spaces(owed, out);
            owed = 0;
        }
        fputs(cell[c], out);
        owed += 1 + (t->align[c] == 'l' ? fill : 0);
    }
    fputc('\n', out);
}

void app_table_print(app_table *t, FILE *out)
{
    size_t *width = app_need(malloc(t->columns * sizeof *width));
    for (size_t c = 0; c < t->columns; c++)
        width[c] = column_width(t, c);
    for (size_t i = 0; i < t->cells; i += t->columns)
        print_row(t, t->cell + i, width, out);
    free(width);
    app_table_clear(t);
}

void app_table_clear(app_table *t)
{
    for (size_t i = 0; i < t->cells; i++)
        free(t->cell[i]);
    free(t->cell);
    *t = (app_table){.columns = t->columns, .align = t->align};
}
