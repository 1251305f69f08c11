/* page.c: see page.h. The body of the report is kept as text until the end, when the list of its
 * sections is known. */
#include "qualify/page.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <fmb/base.h>

#include "common/file.h"
#include "common/json.h"
#include "common/machine.h"
#include "common/message.h"
#include "qualify/gnuplot.h"
#include "qualify/html.h"

enum { WIDTH = 100 }; /* of a text [characters] */

/* A text that grows. */
typedef struct growing {
    FILE *f;
    char *text;
    size_t size;
} growing;

struct qualify_page {
    const char *folder;
    bool json, gnuplot_missed;
    growing contents, body;
    json_t *studies; /* array */
    json_t *study;   /* the last of them, borrowed */
    const char *name;
    int code; /* of the first mistake */
};

static void growing_begin(growing *g)
{
    g->f = app_need(open_memstream(&g->text, &g->size));
}

static void growing_end(growing *g)
{
    if (fclose(g->f) != 0)
        app_need(NULL);
}

static void note_code(qualify_page *g, int code)
{
    if (g->code == APP_YES)
        g->code = code;
}

static void make_folder(qualify_page *g)
{
    if (mkdir(g->folder, 0777) == 0 || errno == EEXIST)
        return;
    note_code(g, app_error(APP_CANNOT_WRITE, "%s: %s", g->folder, strerror(errno)));
    g->folder = NULL;
}

qualify_page *qualify_page_open(const char *folder, bool json)
{
    qualify_page *g = app_need(calloc(1, sizeof *g));
    g->folder = folder;
    g->json = json;
    g->studies = app_need(json_array());
    growing_begin(&g->contents);
    growing_begin(&g->body);
    if (folder)
        make_folder(g);
    return g;
}

/* ---- files ----------------------------------------------------------------------------------- */

/* [give, free()] Where a file of the report is. */
static char *path_of(const qualify_page *g, const char *file)
{
    char *path;
    if (asprintf(&path, "%s/%s", g->folder, file) < 0)
        app_need(NULL);
    return path;
}

/* [give, free()] "STUDY-NAME.ENDING" */
static char *file_of(const qualify_page *g, const char *name, const char *ending)
{
    char *file;
    if (asprintf(&file, "%s-%s%s", g->name, name, ending) < 0)
        app_need(NULL);
    return file;
}

static void write_file(qualify_page *g, const char *file, void (*put)(FILE *f, const void *what),
                       const void *what)
{
    FILE *f = NULL;
    char *path = path_of(g, file);
    int code = app_file_create(path, &f);
    if (code == APP_YES) {
        put(f, what);
        code = app_file_close(f, path);
    }
    note_code(g, code);
    free(path);
}

static void put_text(FILE *f, const void *text)
{
    fputs(text, f);
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

void qualify_page_file(qualify_page *g, const char *name, void (*put)(FILE *f, const void *what),
                       const void *what)
{
    char *file = file_of(g, name, "");
    if (g->folder)
        write_file(g, file, put, what);
    free(file);
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
    char *file = file_of(g, name, ".csv");
    qualify_html_table(g->body.f, caption, t, g->folder ? file : NULL);
    if (g->folder)
        write_file(g, file, put_table, t);
    free(file);
    if (g->json) {
        app_table_clear(t);
        return;
    }
    printf("%s\n\n", caption);
    app_table_print(t, stdout);
    putchar('\n');
}

/* ---- figures --------------------------------------------------------------------------------- */

void qualify_figure_begin(qualify_figure *f)
{
    *f = (qualify_figure){0};
    f->data = app_need(open_memstream(&f->data_text, &f->data_size));
    f->script = app_need(open_memstream(&f->script_text, &f->script_size));
}

static void missing(qualify_page *g, const char *caption, const char *why)
{
    fputs("<p class=\"missing\">", g->body.f);
    qualify_html_text(g->body.f, caption);
    fprintf(g->body.f, " <strong>Not drawn: %s.</strong></p>\n", why);
}

static void show_picture(qualify_page *g, const char *file, const char *caption)
{
    char *svg, *path;
    if (asprintf(&svg, "%s.svg", file) < 0)
        app_need(NULL);
    path = path_of(g, svg);
    if (!qualify_html_figure(g->body.f, caption, path, file))
        missing(g, caption, "the picture cannot be read");
    free(path);
    free(svg);
}

static void draw(qualify_page *g, const char *script, const char *file, const char *caption)
{
    switch (qualify_gnuplot(g->folder, script)) {
    case QUALIFY_DRAWN:
        show_picture(g, file, caption);
        break;
    case QUALIFY_NO_GNUPLOT:
        if (!g->gnuplot_missed)
            app_error(0,
                      "gnuplot is not installed: the pictures are missing; with it, `gnuplot *.gp` "
                      "in %s makes them",
                      g->folder);
        g->gnuplot_missed = true;
        missing(g, caption, "gnuplot is not installed");
        break;
    default:
        note_code(g, APP_INTERNAL);
        missing(g, caption, "gnuplot failed");
    }
}

/* The same commands for both pictures. */
static void put_script(FILE *f, const char *name, const char *commands)
{
    fprintf(f,
            "# gnuplot %s.gp\ndata = '%s.dat'\nset datafile missing '-'\n"
            "set terminal svg size 900,540 dynamic background 'white'\nset output '%s.svg'\n%s"
            "set output\nreset\nset datafile missing '-'\nset terminal png size 900,540\n"
            "set output '%s.png'\n%sset output\n",
            name, name, name, commands, name, commands);
}

static void write_figure(qualify_page *g, const char *name, const char *caption,
                         const qualify_figure *f)
{
    growing script;
    char *base = file_of(g, name, ""), *data = file_of(g, name, ".dat"),
         *commands = file_of(g, name, ".gp");
    growing_begin(&script);
    put_script(script.f, base, f->script_text);
    growing_end(&script);
    write_file(g, data, put_text, f->data_text);
    write_file(g, commands, put_text, script.text);
    draw(g, commands, base, caption);
    free(script.text);
    free(base);
    free(data);
    free(commands);
}

void qualify_page_figure(qualify_page *g, const char *name, const char *caption, qualify_figure *f)
{
    if (fclose(f->data) != 0 || fclose(f->script) != 0)
        app_need(NULL);
    if (g->folder)
        write_figure(g, name, caption, f);
    free(f->data_text);
    free(f->script_text);
}

/* ---- the end --------------------------------------------------------------------------------- */

static void put_report(FILE *f, const void *page)
{
    const qualify_page *g = page;
    qualify_html_head(f, "fmb-qualify");
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
    growing_end(&g->contents);
    growing_end(&g->body);
    if (g->folder) {
        write_file(g, "report.html", put_report, g);
        write_file(g, "report.json", put_json, all);
        if (!g->json)
            printf("The report: %s/report.html\n", g->folder);
    }
    if (g->json)
        put_json(stdout, all);
    int code = g->code;
    json_decref(all);
    json_decref(g->studies);
    free(g->contents.text);
    free(g->body.text);
    free(g);
    return code;
}
