/* table.c: see table.h. */
#include "common/table.h"

#include <stdlib.h>

#include "common/message.h"
#include "common/text.h"

/* ---- cells ----------------------------------------------------------------------------------- */

static size_t begin_of_cell(const app_table *t, size_t i)
{
    return i > 0 ? t->cell[i - 1].end : 0;
}

void app_table_end_cell(app_table *t)
{
    if (t->cells == t->capacity) {
        t->capacity = t->capacity ? 2 * t->capacity : 64;
        t->cell = app_need(realloc(t->cell, t->capacity * sizeof *t->cell));
    }
    size_t begin = begin_of_cell(t, t->cells);
    size_t width = begin < t->text.size ? app_text_width(t->text.text + begin) : 0;
    t->cell[t->cells++] = (app_cell){t->text.size, width};
}

void app_table_put(app_table *t, const char *text)
{
    app_buffer_put(&t->text, text);
    app_table_end_cell(t);
}

void app_table_add(app_table *t, char *text)
{
    app_table_put(t, text);
    free(text);
}

/* ---- printing -------------------------------------------------------------------------------- */

static size_t column_width(const app_table *t, size_t column)
{
    size_t widest = 0;
    for (size_t i = column; i < t->cells; i += t->columns)
        widest = t->cell[i].width > widest ? t->cell[i].width : widest;
    return widest;
}

static void spaces(size_t n, FILE *out)
{
    static const char some[] = "                                ";
    for (size_t now; n > 0; n -= now) {
        now = n < sizeof some - 1 ? n : sizeof some - 1;
        fwrite_unlocked(some, 1, now, out);
    }
}

/* One line. Spaces are owed until there is something to print behind them. */
static void print_row(const app_table *t, size_t first, const size_t *width, FILE *out)
{
    size_t owed = 0;
    for (size_t c = 0; c < t->columns; c++) {
        size_t begin = begin_of_cell(t, first + c), bytes = t->cell[first + c].end - begin;
        size_t fill = width[c] - t->cell[first + c].width;
        if (t->align[c] == 'r')
            owed += fill;
        if (bytes > 0) {
            spaces(owed, out);
            owed = 0;
            fwrite_unlocked(t->text.text + begin, 1, bytes, out);
        }
        owed += 1 + (t->align[c] == 'l' ? fill : 0);
    }
    putc_unlocked('\n', out);
}

void app_table_print(app_table *t, FILE *out)
{
    size_t *width = app_need(malloc(t->columns * sizeof *width));
    for (size_t c = 0; c < t->columns; c++)
        width[c] = column_width(t, c);
    for (size_t i = 0; i < t->cells; i += t->columns)
        print_row(t, i, width, out);
    free(width);
    app_table_clear(t);
}

void app_table_clear(app_table *t)
{
    free(t->cell);
    free(t->text.text);
    *t = (app_table){.columns = t->columns, .align = t->align};
}
