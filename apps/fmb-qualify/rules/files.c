/* files.c: see files.h. */
#include "fmb-qualify/rules/files.h"

#include <fmb/io.h>
#include <stdlib.h>

#include "common/file.h"
#include "common/message.h"
#include "common/source.h"

/* K of a comment `* keep K` (the benchmark problems of .ine files carry one), or 0. */
static int kept_by_comment(const char *path)
{
    FILE *f = fopen(path, "rb");
    char *line = NULL;
    size_t size = 0;
    int kept = 0;
    while (f && kept == 0 && getline(&line, &size, f) > 0)
        if (sscanf(line, "* keep %d", &kept) != 1)
            kept = 0;
    free(line);
    if (f)
        fclose(f);
    return kept;
}

/* [give] The variables to keep: as the file asks; else the last one. */
static int *kept_variables(const char *path, const fmb_system *s, int *kept)
{
    int n = fmb_system_dim(s), first = kept_by_comment(path);
    int *keep = app_need(malloc((size_t)(n + 1) * sizeof *keep));
    bool asks = fmb_system_asks_projection(s);
    *kept = 0;
    for (int j = 0; j < n; j++)
        if (asks ? fmb_system_is_kept(s, j) : first > 0 ? j < first : j == n - 1)
            keep[(*kept)++] = j;
    return keep;
}

int qualify_files_add(study_grid *g, const char *path, bool read)
{
    app_source source = {.file = path, .quiet = true};
    fmb_system *s = NULL;
    int kept = 0, code = read ? app_source_read(&source, &s) : APP_YES;
    if (code != APP_YES)
        return code;
    int *keep = read ? kept_variables(path, s, &kept) : NULL;
    study_sample sample = {.file = path};
    if (study_sample_put(&sample, s, keep, kept) != FMB_OK || study_grid_add(g, &sample) != FMB_OK)
        app_need(NULL);
    return APP_YES;
}

char *qualify_system_text(fmb_system *s, const study_case *c)
{
    size_t length = 0;
    for (int j = 0; j < c->kept; j++)
        fmb_system_set_kept(s, c->keep[j], true);
    if (fmb_system_print(s, FMB_FORMAT_TEXT, NULL, 0, &length) != FMB_OK)
        app_need(NULL);
    char *text = app_need(malloc(length + 1));
    if (fmb_system_print(s, FMB_FORMAT_TEXT, text, length + 1, &length) != FMB_OK)
        app_need(NULL);
    return text;
}
