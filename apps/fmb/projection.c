/* projection.c: see projection.h. */
#include "fmb/projection.h"

#include <stdlib.h>

#include "common/exit_code.h"
#include "common/json.h"
#include "common/message.h"
#include "common/table.h"
#include "fmb/show.h"
#include "fmb/verdict.h"

typedef struct classes {
    const fmb_system *projection;
    size_t *first; /* [rows] of the class of each */
    size_t *size;  /* [rows] of the class that begins there, else 0 */
    size_t count;
} classes;

/* ---- text ------------------------------------------------------------------------------------ */

static void print_classes(const classes *c, int digits)
{
    app_table table = {.columns = 3, .align = "rll"};
    size_t rows = fmb_system_rows(c->projection);
    for (size_t i = 0; i < rows; i++)
        if (c->size[i] > 0) {
            app_table_add(&table, app_print("%zu", c->size[i]));
            app_table_put(&table, c->size[i] == 1 ? "row" : "rows");
            app_put_row(&table.text, c->projection, i, digits);
            app_table_end_cell(&table);
        }
    app_table_print(&table, stdout);
    printf("%zu class%s, %zu row%s\n", c->count, c->count == 1 ? "" : "es", rows,
           rows == 1 ? "" : "s");
}

/* ---- JSON ------------------------------------------------------------------------------------ */

/* [{"size": n, "rows": [i, ...]}]: of the rows of the answer, from 1. */
static json_t *classes_json(const classes *c)
{
    json_t *list = app_need(json_array());
    size_t rows = fmb_system_rows(c->projection);
    for (size_t i = 0; i < rows; i++) {
        if (c->size[i] == 0)
            continue;
        json_t *one = app_need(json_object()), *members = app_need(json_array());
        for (size_t k = i; k < rows; k++)
            if (c->first[k] == i)
                app_json_append(members, json_integer((json_int_t)k + 1));
        app_json_set(one, "size", json_integer((json_int_t)c->size[i]));
        app_json_set(one, "rows", members);
        app_json_append(list, one);
    }
    return list;
}

static void report_json(const app_session *s, const fmb_system *projection, const classes *c)
{
    json_t *obj = app_verdict_json(s);
    if (s->result.stop != FMB_STOP_DONE)
        app_json_set(obj, "outer", json_true());
    if (projection)
        app_json_set_system(obj, projection, s->ask->digits);
    if (c)
        app_json_set(obj, "classes", classes_json(c));
    app_json_set_stats(obj, &s->result.stats);
    app_json_print(obj);
}

/* ---- reports --------------------------------------------------------------------------------- */

static int exit_code(const app_session *s, const fmb_system *projection)
{
    if (s->proof && s->evidence && *fmb_solver_trouble(s->solver))
        app_session_note(s, "%s is outward only: %s", s->ask->proof, fmb_solver_trouble(s->solver));
    if (s->result.stop == FMB_STOP_DONE)
        return app_session_verdict_code(s);
    return app_session_undecided(s, projection ? "an outer projection" : NULL);
}

int app_projection_report(const app_session *s, const fmb_system *projection, fmb_format to)
{
    int code = APP_YES;
    if (s->ask->json)
        report_json(s, projection, NULL);
    else if (projection && app_session_reports(s))
        code = app_source_write(projection, to);
    return code == APP_YES ? exit_code(s, projection) : code;
}

int app_classes_report(const app_session *s, const fmb_system *projection,
                       const fmb_permutations *symmetries, const int *keep, int n)
{
    size_t rows = fmb_system_rows(projection);
    classes c = {.projection = projection,
                 .first = app_need(calloc(rows + 1, sizeof *c.first)),
                 .size = app_need(calloc(rows + 1, sizeof *c.size))};
    for (size_t i = 0; i < rows; i++)
        c.first[i] = i;
    fmb_status st =
        symmetries ? fmb_rows_classes(projection, symmetries, keep, n, c.first) : FMB_OK;
    for (size_t i = 0; i < rows; i++)
        c.count += c.size[c.first[i]]++ == 0;
    if (st == FMB_OK && s->ask->json)
        report_json(s, projection, &c);
    else if (st == FMB_OK && app_session_reports(s))
        print_classes(&c, s->ask->digits);
    free(c.first);
    free(c.size);
    return st == FMB_OK ? exit_code(s, projection) : app_status_error(st);
}
