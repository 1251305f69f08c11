/* kind.c: see kind.h. */
#include "fmb/kind.h"

#include <fmb/gmp.h>
#include <fmb/mesh.h>
#include <string.h>
#include <sys/stat.h>

static bool holds_frames(FILE *in)
{
    fmb_frame_reader *r = NULL;
    const fmb_frame_line *line = NULL;
    fmb_where where;
    bool read = fmb_frame_reader_new(in, NULL, &r) == FMB_OK &&
                fmb_frame_reader_next(r, &line, &where) == FMB_OK && line;
    fmb_frame_reader_free(r);
    return read;
}

static bool holds_mesh(FILE *in)
{
    fmb_mesh *m = NULL;
    fmb_where where;
    bool read = fmb_mesh_read(in, FMB_MESH_AUTO, NULL, &m, &where) == FMB_OK;
    fmb_mesh_free(m);
    return read;
}

static bool holds_system(FILE *in)
{
    fmb_system *s = NULL;
    fmb_where where;
    bool read = fmb_system_read(in, NULL, &s, &where) == FMB_OK;
    fmb_system_free(s);
    return read;
}

static bool is_taken_by(bool (*holds)(FILE *in), const char *path)
{
    FILE *in = fopen(path, "rb");
    bool taken = in && holds(in);
    if (in)
        fclose(in);
    return taken;
}

static app_kind kind_of_content(const char *path)
{
    struct stat info;
    if (stat(path, &info) != 0 || !S_ISREG(info.st_mode))
        return APP_KIND_UNKNOWN;
    if (is_taken_by(holds_frames, path))
        return APP_KIND_FRAMES;
    if (is_taken_by(holds_mesh, path))
        return APP_KIND_MESH;
    return is_taken_by(holds_system, path) ? APP_KIND_SYSTEM : APP_KIND_UNKNOWN;
}

static app_kind kind_of_name(const char *path)
{
    const char *dot = strrchr(path, '.');
    if (dot && strcmp(dot, ".jsonl") == 0)
        return APP_KIND_FRAMES;
    if (fmb_mesh_format_of_name(path) != FMB_MESH_AUTO)
        return APP_KIND_MESH;
    return fmb_format_of_name(path) != FMB_FORMAT_AUTO ? APP_KIND_SYSTEM : APP_KIND_UNKNOWN;
}

app_kind app_kind_of(const char *path)
{
    /* Opened anew, standard input from a file begins at its beginning. */
    app_kind kind = kind_of_content(strcmp(path, "-") == 0 ? "/dev/stdin" : path);
    return kind != APP_KIND_UNKNOWN ? kind : kind_of_name(path);
}
