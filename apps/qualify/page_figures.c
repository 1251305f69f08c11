/* page_figures.c: the figures of a page; see page.h. */
#include <stdlib.h>

#include "common/message.h"
#include "qualify/gnuplot.h"
#include "qualify/html.h"
#include "qualify/page_inside.h"

static void put_text(FILE *f, const void *text)
{
    fputs(text, f);
}

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
    path = qualify_page_path(g, svg);
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
        qualify_page_note(g, APP_INTERNAL);
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
    qualify_growing script;
    char *base = qualify_page_name(g, name, ""), *data = qualify_page_name(g, name, ".dat"),
         *commands = qualify_page_name(g, name, ".gp");
    qualify_growing_begin(&script);
    put_script(script.f, base, f->script_text);
    qualify_growing_end(&script);
    qualify_page_write(g, data, put_text, f->data_text);
    qualify_page_write(g, commands, put_text, script.text);
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
