/* page.c: see page.h. The body of the report is kept as text until the end, when the list of its
 * sections is known. */
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <fmb/base.h>

#include "common/json.h"
#include "common/machine.h"
#include "common/message.h"
#include "qualify/html.h"
#include "qualify/page_inside.h"

enum { WIDTH = 100 }; /* of a text [characters] */

/* One that is there is fine; a file is not. */
static void make_folder(qualify_page *g)
{
    struct stat info;
    if (mkdir(g->folder, 0777) == 0)
        return;
    if (errno == EEXIST && stat(g->folder, &info) == 0 && S_ISDIR(info.st_mode))
        return;
    qualify_page_note(g, app_error(APP_CANNOT_WRITE, "%s: %s", g->folder, strerror(errno)));
    g->folder = NULL;
}

qualify_page *qualify_page_open(const char *folder, bool json)
{
    qualify_page *g = app_need(calloc(1, sizeof *g));
    g->folder = folder;
    g->json = json;
    g->studies = app_need(json_array());
    qualify_growing_begin(&g->contents);
    qualify_growing_begin(&g->body);
    if (folder)
        make_folder(g);
    return g;
}

bool qualify_page_is_good(const qualify_page *g)
{
    return g->code == APP_YES;
}

static void put_table(FILE *f, const void *table)
{
    qualify_csv(f, table);
}

static void put_json(FILE *f, const void *obj)
{
    if (json_dumpf(obj, f, JSON_INDENT(2)) != 0 && !ferror(f))
        exit(app_status_error(FMB_ERR_MEMORY));
    fputc('\n', f);
}

/* ---- studies --------------------------------------------------------------------------------- */

void qualify_page_begin(qualify_page *g, const char *study, const char *title)
{
    app_machine machine = app_machine_find();
    g->name = study;
    g->study = app_need(json_object());
    app_json_append(g->studies, g->study);
    app_json_set(g->study, "study", json_string(study));
    app_json_set(g->study, "version", json_string(fmb_version()));
    app_json_set(g->study, "machine", app_json_text(machine.cpu));
    app_json_set(g->study, "compiler", app_json_text(machine.compiler));
    app_json_set(g->study, "flags", app_json_text(machine.flags));
    app_json_set(g->study, "commit", app_json_text(machine.commit));
    app_json_set(g->study, "complete", json_true());
    fprintf(g->contents.f, "<li><a href=\"#%s\">%s</a>: %s</li>\n", study, study, title);
    fprintf(g->body.f, "<h2 id=\"%s\">%s: %s</h2>\n", study, study, title);
    if (!g->json)
        printf("fmb-qualify %s, fmb %s, %s\n\n", study, fmb_version(), machine.cpu);
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

/* On standard output, in lines. */
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
    qualify_html_paragraph(g->body.f, text);
    free(text);
}

void qualify_page_table(qualify_page *g, const char *name, const char *caption, app_table *t)
{
    char *file = qualify_page_name(g, name, ".csv");
    qualify_html_table(g->body.f, caption, t, g->folder ? file : NULL);
    if (g->folder)
        qualify_page_write(g, file, put_table, t);
    free(file);
    if (g->json) {
        app_table_clear(t);
        return;
    }
    printf("%s\n\n", caption);
    app_table_print(t, stdout);
    putchar('\n');
}

/* ---- the end --------------------------------------------------------------------------------- */

static void put_machine(FILE *f)
{
    app_machine m = app_machine_find();
    char *text;
    if (asprintf(&text, "fmb %s (%s), compiler %s, %s, on %s", fmb_version(), m.commit, m.compiler,
                 m.flags, m.cpu) < 0)
        app_need(NULL);
    qualify_html_paragraph(f, text);
    free(text);
}

static void put_report(FILE *f, const void *page)
{
    const qualify_page *g = page;
    qualify_html_head(f, "fmb-qualify");
    put_machine(f);
    if (json_array_size(g->studies) > 1)
        fprintf(f, "<ul>\n%s</ul>\n", g->contents.text);
    fputs(g->body.text, f);
    qualify_html_foot(f);
}

/* Of one study its object alone. */
static json_t *whole(const qualify_page *g)
{
    if (json_array_size(g->studies) == 1)
        return json_incref(g->study);
    json_t *all = app_need(json_object());
    app_json_set(all, "studies", json_incref(g->studies));
    return all;
}

int qualify_page_close(qualify_page *g)
{
    json_t *all = whole(g);
    size_t studies = json_array_size(g->studies);
    qualify_growing_end(&g->contents);
    qualify_growing_end(&g->body);
    if (g->folder && studies > 0) {
        qualify_page_write(g, "report.html", put_report, g);
        qualify_page_write(g, "report.json", put_json, all);
        if (!g->json)
            printf("The report: %s/report.html\n", g->folder);
    }
    if (g->json && studies > 0)
        put_json(stdout, all);
    int code = g->code;
    json_decref(all);
    json_decref(g->studies);
    free(g->contents.text);
    free(g->body.text);
    free(g);
    return code;
}
