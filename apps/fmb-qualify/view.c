/* view.c: see view.h. */
#include "fmb-qualify/view.h"

#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "common/table.h"
#include "common/text.h"

/* The value of a row that "outer.inner" names, NULL if there is none; names are short. */
static const json_t *value_at(const json_t *row, const char *key)
{
    char outer[40];
    for (const char *dot; (dot = strchr(key, '.')) != NULL; key = dot + 1) {
        snprintf(outer, sizeof outer, "%.*s", (int)(dot - key), key);
        row = json_object_get(row, outer);
    }
    return json_object_get(row, key);
}

/* ---- for people ------------------------------------------------------------------------------ */

/* [give, free()] */
static char *cell_text(const json_t *value, const char *format)
{
    char *text = NULL;
    int length = 0;
    if (json_is_string(value))
        return app_text(json_string_value(value), APP_TEXT_TERMINAL);
    if (json_is_number(value) && format)
        length = asprintf(&text, format, json_number_value(value));
    else
        length = asprintf(&text, "%s",
                          json_is_true(value)    ? "yes"
                          : json_is_false(value) ? "no"
                                                 : "-");
    return app_need(length < 0 ? NULL : text);
}

void qualify_view_print(const qualify_view *view, FILE *out)
{
    char align[64];
    app_table t = {.align = align};
    for (const qualify_column *c = view->column; c->key; c++)
        if (c->title) {
            align[t.columns++] = c->format ? 'r' : 'l';
            app_table_add(&t, app_need(strdup(c->title)));
        }
    for (size_t i = 0; i < json_array_size(view->rows); i++)
        for (const qualify_column *c = view->column; c->key; c++)
            if (c->title)
                app_table_add(
                    &t, cell_text(value_at(json_array_get(view->rows, i), c->key), c->format));
    app_table_print(&t, out);
}

/* ---- for programs ---------------------------------------------------------------------------- */

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

static void put_field(FILE *f, const json_t *value)
{
    if (json_is_string(value))
        qualify_csv_text(f, json_string_value(value));
    else if (json_is_integer(value))
        fprintf(f, "%" JSON_INTEGER_FORMAT, json_integer_value(value));
    else if (json_is_real(value))
        fprintf(f, "%.9g", json_real_value(value));
    else if (json_is_boolean(value))
        fputs(json_is_true(value) ? "yes" : "no", f);
}

void qualify_view_csv(FILE *f, const void *self)
{
    const qualify_view *view = self;
    for (const qualify_column *c = view->column; c->key; c++)
        fprintf(f, "%s%s", c == view->column ? "" : ",", c->key);
    fputc('\n', f);
    for (size_t i = 0; i < json_array_size(view->rows); i++) {
        for (const qualify_column *c = view->column; c->key; c++) {
            fputs(c == view->column ? "" : ",", f);
            put_field(f, value_at(json_array_get(view->rows, i), c->key));
        }
        fputc('\n', f);
    }
}
