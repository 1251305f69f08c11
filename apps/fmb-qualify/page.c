/* page.c: see page.h. */
#include "fmb-qualify/page.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/base.h>

#include "base/clock.h"
#include "common/json.h"
#include "common/machine.h"
#include "common/message.h"
#include "fmb-qualify/folder.h"
#include "fmb-qualify/render.h"
#include "fmb-qualify/view.h"

enum { WIDTH = 100 }; /* of a text [characters] */

/* The wall-clock time over the processor time beyond which a warning is printed. */
static const double BUSY = 1.1;

struct qualify_page {
    const char *folder;
    bool json;
    json_t *studies; /* array */
    json_t *study;   /* the last of them, borrowed */
    const char *name;
    double began, used; /* by the wall, by the processor [s] */
    int code;           /* of the first error */
};

static void note_mistake(qualify_page *g, int code)
{
    if (g->code == APP_YES)
        g->code = code;
}

qualify_page *qualify_page_open(const char *folder, bool json)
{
    qualify_page *g = app_need(calloc(1, sizeof *g));
    g->folder = folder;
    g->json = json;
    g->studies = app_need(json_array());
    if (folder)
        note_mistake(g, qualify_folder_make(folder));
    if (!qualify_page_is_good(g))
        g->folder = NULL;
    return g;
}

bool qualify_page_is_good(const qualify_page *g)
{
    return g->code == APP_YES;
}

/* ---- files ----------------------------------------------------------------------------------- */

void qualify_page_file(qualify_page *g, const char *name, void (*put)(FILE *f, const void *what),
                       const void *what)
{
    char *file;
    if (asprintf(&file, "%s-%s", g->name, name) < 0)
        app_need(NULL);
    if (g->folder)
        note_mistake(g, qualify_folder_write(g->folder, file, put, what));
    free(file);
}

static void put_json(FILE *f, const void *obj)
{
    if (json_dumpf(obj, f, JSON_INDENT(2)) != 0 && !ferror(f))
        exit(app_status_error(FMB_ERR_MEMORY));
    fputc('\n', f);
}

/* ---- studies --------------------------------------------------------------------------------- */

static double processor_seconds(void)
{
    return fmb_clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
}

static json_t *machine_json(const app_machine *m)
{
    json_t *obj = json_object();
    app_json_set(obj, "cpu", app_json_text(m->cpu));
    app_json_set(obj, "cores", json_integer(m->cores));
    app_json_set(obj, "memory_bytes", json_integer((json_int_t)m->memory));
    app_json_set(obj, "os", app_json_text(m->os));
    app_json_set(obj, "kernel", app_json_text(m->kernel));
    app_json_set(obj, "compiler", app_json_text(m->compiler));
    app_json_set(obj, "flags", app_json_text(m->flags));
    app_json_set(obj, "load", app_json_real(m->load));
    return obj;
}

void qualify_page_begin(qualify_page *g, const char *study, const char *title)
{
    app_machine machine = app_machine_find();
    g->name = study;
    g->study = app_need(json_object());
    app_json_append(g->studies, g->study);
    app_json_set(g->study, "study", json_string(study));
    app_json_set(g->study, "title", json_string(title));
    app_json_set(g->study, "version", json_string(fmb_version()));
    app_json_set(g->study, "commit", app_json_text(machine.commit));
    app_json_set(g->study, "machine", machine_json(&machine));
    app_json_set(g->study, "complete", json_true());
    app_json_set(g->study, "page", json_array());
    g->began = fmb_monotonic_seconds();
    g->used = processor_seconds();
    if (!g->json)
        printf("fmb-qualify %s, fmb %s (%s)\n%s, %ld cores, %.1f GiB, load %.2f\n%s, Linux %s\n"
               "%s, %s\n\n",
               study, fmb_version(), machine.commit, machine.cpu, machine.cores,
               (double)machine.memory / 0x1p30, machine.load, machine.os, machine.kernel,
               machine.compiler, machine.flags);
}

void qualify_page_end(qualify_page *g)
{
    double wall = fmb_monotonic_seconds() - g->began, cpu = processor_seconds() - g->used;
    app_json_set(g->study, "wall_seconds", json_real(wall));
    app_json_set(g->study, "cpu_seconds", json_real(cpu));
    if (wall > BUSY * cpu)
        qualify_page_text(g,
                          "Warning: %.1f s went by, of which this program had the processor for "
                          "%.1f s. The machine was busy; repeat the study when it is not.",
                          wall, cpu);
}

json_t *qualify_page_json(qualify_page *g)
{
    return g->study;
}

void qualify_page_interrupted(qualify_page *g)
{
    app_json_set(g->study, "complete", json_false());
    qualify_page_text(g, "Interrupted: what was not complete is left out.");
}

/* ---- texts and tables ------------------------------------------------------------------------ */

/* Prints a text on standard output, wrapped. */
static void print_wrapped(const char *text)
{
    size_t column = 0;
    while (*text) {
        size_t word = strcspn(text, " ");
        if (column > 0 && column + 1 + word > WIDTH) {
            putchar('\n');
            column = 0;
        } else if (column > 0) {
            putchar(' ');
            column++;
        }
        printf("%.*s", (int)word, text);
        column += word;
        text += word + strspn(text + word, " ");
    }
    fputs("\n\n", stdout);
}

static void add_to_page(qualify_page *g, json_t *part)
{
    app_json_append(json_object_get(g->study, "page"), part);
}

void qualify_page_text(qualify_page *g, const char *format, ...)
{
    char *text;
    va_list args;
    va_start(args, format);
    int length = vasprintf(&text, format, args);
    va_end(args);
    if (length < 0)
        app_need(NULL);
    if (!g->json)
        print_wrapped(text);
    json_t *part = json_object();
    app_json_set(part, "text", app_json_text(text));
    add_to_page(g, part);
    free(text);
}

static json_t *columns_json(const qualify_column *column)
{
    json_t *all = json_array();
    for (; column->key; column++)
        if (column->title)
            app_json_append(all,
                            json_pack("[s, s, s?]", column->key, column->title, column->format));
    return all;
}

void qualify_page_table(qualify_page *g, const char *name, const char *caption,
                        const qualify_column *column, const char *rows)
{
    const qualify_view view = {column, json_object_get(g->study, rows)};
    char *file;
    if (asprintf(&file, "%s.csv", name) < 0)
        app_need(NULL);
    qualify_page_file(g, file, qualify_view_csv, &view);
    free(file);
    if (!caption)
        return;
    json_t *part = json_object();
    app_json_set(part, "table", json_string(name));
    app_json_set(part, "caption", json_string(caption));
    app_json_set(part, "columns", columns_json(column));
    app_json_set(part, "rows", json_string(rows));
    add_to_page(g, part);
    if (g->json)
        return;
    printf("%s\n\n", caption);
    qualify_view_print(&view, stdout);
    putchar('\n');
}

/* ---- the end --------------------------------------------------------------------------------- */

/* [give] The object of the only study, or all of them. */
static json_t *whole_report(const qualify_page *g)
{
    if (json_array_size(g->studies) == 1)
        return json_incref(json_array_get(g->studies, 0));
    json_t *all = json_object();
    app_json_set(all, "studies", json_incref(g->studies));
    return all;
}

int qualify_page_close(qualify_page *g)
{
    json_t *all = whole_report(g);
    size_t studies = json_array_size(g->studies);
    if (g->folder && studies > 0) {
        note_mistake(g, qualify_folder_write(g->folder, "report.json", put_json, all));
        if (qualify_render("report.py", (const char *const[]){g->folder, NULL}) ==
            QUALIFY_NOT_RENDERED)
            note_mistake(g, app_error(APP_INTERNAL,
                                      "report.html and the figures of %s could not be made",
                                      g->folder));
        if (!g->json)
            printf("The report: %s/report.html\n", g->folder);
    }
    if (g->json && studies > 0)
        put_json(stdout, all);
    int code = g->code;
    json_decref(all);
    json_decref(g->studies);
    free(g);
    return code;
}
