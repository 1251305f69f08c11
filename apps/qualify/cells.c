/* cells.c: see cells.h. */
#include "qualify/cells.h"

#include <math.h>
#include <stdarg.h>

#include "common/message.h"

void qualify_cell(app_table *t, const char *format, ...)
{
    char *text;
    va_list args;
    va_start(args, format);
    int length = vasprintf(&text, format, args);
    va_end(args);
    app_table_add(t, app_need(length < 0 ? NULL : text));
}

void qualify_number_cell(app_table *t, const char *format, double x)
{
    if (isfinite(x))
        qualify_cell(t, format, x);
    else
        qualify_cell(t, "-");
}

void qualify_titles(app_table *t, const char *const *title)
{
    for (size_t i = 0; i < t->columns; i++)
        qualify_cell(t, "%s", title[i]);
}

void qualify_csv_text(FILE *f, const char *text)
{
    fputc('"', f);
    for (; *text; text++) {
        if (*text == '"')
            fputc('"', f);
        fputc(*text, f);
    }
    fputc('"', f);
}

void qualify_csv(FILE *f, const app_table *t)
{
    for (size_t i = 0; i < t->cells; i++) {
        qualify_csv_text(f, t->cell[i]);
        fputc((i + 1) % t->columns == 0 ? '\n' : ',', f);
    }
}
