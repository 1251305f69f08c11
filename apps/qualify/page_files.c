/* page_files.c: the files of a page's folder; see page_inside.h. */
#include <stdlib.h>

#include "common/file.h"
#include "common/message.h"
#include "qualify/page_inside.h"

void qualify_growing_begin(qualify_growing *g)
{
    g->f = app_need(open_memstream(&g->text, &g->size));
}

void qualify_growing_end(qualify_growing *g)
{
    if (fclose(g->f) != 0)
        app_need(NULL);
}

void qualify_page_note(qualify_page *g, int code)
{
    if (g->code == APP_YES)
        g->code = code;
}

char *qualify_page_path(const qualify_page *g, const char *file)
{
    char *path;
    if (asprintf(&path, "%s/%s", g->folder, file) < 0)
        app_need(NULL);
    return path;
}

char *qualify_page_name(const qualify_page *g, const char *name, const char *ending)
{
    char *file;
    if (asprintf(&file, "%s-%s%s", g->name, name, ending) < 0)
        app_need(NULL);
    return file;
}

void qualify_page_write(qualify_page *g, const char *file, void (*put)(FILE *f, const void *what),
                        const void *what)
{
    FILE *f = NULL;
    char *path = qualify_page_path(g, file);
    int code = app_file_create(path, &f);
    if (code == APP_YES) {
        put(f, what);
        code = app_file_close(f, path);
    }
    qualify_page_note(g, code);
    free(path);
}

void qualify_page_file(qualify_page *g, const char *name, void (*put)(FILE *f, const void *what),
                       const void *what)
{
    char *file = qualify_page_name(g, name, "");
    if (g->folder)
        qualify_page_write(g, file, put, what);
    free(file);
}
