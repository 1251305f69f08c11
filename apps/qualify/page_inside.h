/* page_inside.h: a page, for the files that fill it. */
#ifndef QUALIFY_PAGE_INSIDE_H
#define QUALIFY_PAGE_INSIDE_H

#include "qualify/page.h"

/* A text that grows. */
typedef struct qualify_growing {
    FILE *f;
    char *text;
    size_t size;
} qualify_growing;

struct qualify_page {
    const char *folder;
    bool json, gnuplot_missed;
    qualify_growing contents, body;
    json_t *studies; /* array */
    json_t *study;   /* the last of them, borrowed */
    const char *name;
    int code; /* of the first mistake */
};

void qualify_growing_begin(qualify_growing *g);
void qualify_growing_end(qualify_growing *g);

/* Remember the exit code of the first mistake. */
void qualify_page_note(qualify_page *g, int code);
/* [give, free()] Where a file of the report is; "STUDY-NAME.ENDING". */
char *qualify_page_path(const qualify_page *g, const char *file);
char *qualify_page_name(const qualify_page *g, const char *name, const char *ending);
/* Write a file of the folder by put(f, what). */
void qualify_page_write(qualify_page *g, const char *file, void (*put)(FILE *f, const void *what),
                        const void *what);

#endif
