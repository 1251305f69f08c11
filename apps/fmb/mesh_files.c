/* mesh_files.c: reading meshes, and writing them to a file with the meeting cells marked. */
#include <stdlib.h>
#include <string.h>

#include "common/budget.h"
#include "common/file.h"
#include "common/message.h"
#include "common/need.h"
#include "common/source.h"
#include "fmb/mesh_ask.h"
#include "fmb/scene.h"

/* [give, free()] "a/b.node" or "a/b.ele" with the ending of the other; NULL: neither. */
static char *partner_of_tetgen(const char *path, bool *is_node)
{
    size_t n = strlen(path);
    *is_node = n > 5 && strcmp(path + n - 5, ".node") == 0;
    bool is_ele = n > 4 && strcmp(path + n - 4, ".ele") == 0;
    if (!*is_node && !is_ele)
        return NULL;
    char *other = app_need(malloc(n + 2));
    memcpy(other, path, n);
    strcpy(other + n - (*is_node ? 5 : 4), *is_node ? ".ele" : ".node");
    return other;
}

static int read_tetgen(const mesh_ask *ask, const char *node, const char *ele, fmb_mesh **out)
{
    fmb_reader how = {.size = sizeof how, .mem = app_budget_alloc(), .max_bytes = ask->max_input};
    fmb_where where = {0};
    bool in_cells = false;
    FILE *points = NULL, *cells = NULL;
    int code = app_file_open(node, &points);
    if (code == APP_YES)
        code = app_file_open(ele, &cells);
    if (code == APP_YES) {
        fmb_status st = fmb_mesh_read_tetgen(points, cells, &how, out, &where, &in_cells);
        code = app_source_outcome_of(APP_KIND_MESH, st, in_cells ? ele : node, &where);
    }
    if (points)
        app_file_close_input(points);
    if (cells)
        app_file_close_input(cells);
    return code;
}

static int read_one_file(const mesh_ask *ask, const char *path, fmb_mesh **out)
{
    fmb_mesh_format f = ask->format != FMB_MESH_AUTO ? ask->format : fmb_mesh_format_of_name(path);
    fmb_reader how = {.size = sizeof how, .mem = app_budget_alloc(), .max_bytes = ask->max_input};
    fmb_where where = {0};
    FILE *in;
    int code = app_file_open(path, &in);
    if (code != APP_YES)
        return code;
    fmb_status st = fmb_mesh_read(in, f, &how, out, &where);
    app_file_close_input(in);
    return app_source_outcome_of(APP_KIND_MESH, st, path, &where);
}

/* The reader for a scene file of this name; NULL: it is no scene. */
static scene_reader *scene_reader_of_name(const char *path)
{
    static const struct {
        const char *ending;
        scene_reader *read;
    } KNOWN[] = {
        {".gltf", scene_gltf_as_obj}, {".glb", scene_gltf_as_obj}, {".3mf", scene_3mf_as_obj}};
    const char *dot = strrchr(path, '.');
    for (size_t i = 0; dot && i < sizeof KNOWN / sizeof *KNOWN; i++)
        if (strcasecmp(dot, KNOWN[i].ending) == 0)
            return KNOWN[i].read;
    return NULL;
}

/* Read a scene through its OBJ text, which is longer than the file. */
static int read_scene(const mesh_ask *ask, const char *path, scene_reader *as_obj, fmb_mesh **out)
{
    scene_file file = {path, ask->max_input ? ask->max_input : FMB_READER_MAX_BYTES, {NULL, 0}};
    fmb_reader how = {.size = sizeof how, .mem = app_budget_alloc(), .max_bytes = SIZE_MAX};
    fmb_where where = {0};
    char *text = NULL;
    size_t size = 0;
    int code = scene_read_bytes(path, file.most, &file.all);
    FILE *obj = app_need(open_memstream(&text, &size));
    if (code == APP_YES)
        code = as_obj(&file, obj);
    fclose(obj);
    app_need(text);
    if (code == APP_YES) {
        fmb_status st = fmb_mesh_parse(text, size, FMB_MESH_OBJ, &how, out, &where);
        code = app_source_outcome_of(APP_KIND_MESH, st, path, &where);
    }
    free(text);
    free(file.all.p);
    return code;
}

int mesh_file_read(const mesh_ask *ask, const char *path, fmb_mesh **out)
{
    bool is_node = false;
    scene_reader *as_obj = ask->format == FMB_MESH_AUTO ? scene_reader_of_name(path) : NULL;
    if (as_obj)
        return read_scene(ask, path, as_obj, out);
    char *other = ask->format == FMB_MESH_AUTO ? partner_of_tetgen(path, &is_node) : NULL;
    int code = !other    ? read_one_file(ask, path, out)
               : is_node ? read_tetgen(ask, path, other, out)
                         : read_tetgen(ask, other, path, out);
    free(other);
    return code;
}

int mesh_file_place(const mesh_ask *ask, fmb_mesh **m)
{
    fmb_mesh_place place = ask->place;
    fmb_mesh *placed = NULL;
    for (int j = 0; j < 3; j++)
        place.scale[j] = ask->mirror[j] ? -ask->scale[j] : ask->scale[j];
    fmb_status st = fmb_mesh_placed(*m, &place, NULL, &placed);
    if (st == FMB_ERR_ARG)
        return app_error(APP_USAGE, "--scale, --move: a coordinate is beyond all doubles");
    if (st != FMB_OK)
        return app_status_error(st);
    fmb_mesh_free(*m);
    *m = placed;
    return APP_YES;
}

/* ---- marks ----------------------------------------------------------------------------------- */

static const int face_of_tetrahedron[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

static size_t count_triangles(const fmb_mesh *m)
{
    return fmb_mesh_cells(m) * (fmb_mesh_corners(m) == 4 ? 4 : 1);
}

static void write_points(FILE *out, const fmb_mesh *m)
{
    const double *p = fmb_mesh_points(m);
    for (size_t i = 0; i < fmb_mesh_vertices(m); i++, p += 3)
        fprintf(out, "%.17g %.17g %.17g\n", p[0], p[1], p[2]);
}

/* first: the number of the mesh's first vertex in the file. */
static void write_cells(FILE *out, const fmb_mesh *m, const bool *marked, size_t first,
                        const char *colour)
{
    size_t corners = (size_t)fmb_mesh_corners(m);
    for (size_t c = 0; c < fmb_mesh_cells(m); c++)
        for (int k = 0; k < (corners == 4 ? 4 : 1); k++) {
            const uint32_t *v = fmb_mesh_indices(m) + c * corners;
            const int *of = corners == 4 ? face_of_tetrahedron[k] : (const int[3]){0, 1, 2};
            fprintf(out, "3 %zu %zu %zu %s\n", first + v[of[0]], first + v[of[1]], first + v[of[2]],
                    marked[c] ? "213 94 0" : colour);
        }
}

/* b may be NULL. */
static void write_marked(FILE *out, const fmb_mesh *a, const fmb_mesh *b,
                         const fmb_mesh_answer *answer)
{
    bool *mark[2] = {app_need(calloc(fmb_mesh_cells(a) + 1, sizeof(bool))),
                     app_need(calloc(fmb_mesh_cells(b) + 1, sizeof(bool)))};
    for (size_t i = 0; i < answer->hits; i++) {
        mark[0][answer->hit[i].a] = true;
        mark[b ? 1 : 0][answer->hit[i].b] = true;
    }
    fprintf(out,
            "ply\nformat ascii 1.0\nelement vertex %zu\nproperty double x\nproperty double y\n"
            "property double z\nelement face %zu\nproperty list uchar uint vertex_indices\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
            fmb_mesh_vertices(a) + fmb_mesh_vertices(b), count_triangles(a) + count_triangles(b));
    write_points(out, a);
    write_points(out, b);
    write_cells(out, a, mark[0], 0, "170 200 230");
    write_cells(out, b, mark[1], fmb_mesh_vertices(a), "170 220 190");
    free(mark[0]);
    free(mark[1]);
}

int mesh_mark(const mesh_ask *ask, const fmb_mesh *a, const fmb_mesh *b,
              const fmb_mesh_answer *answer, int code)
{
    FILE *out;
    int trouble = app_file_create(ask->marked, &out);
    if (trouble != APP_YES)
        return trouble;
    write_marked(out, a, b, answer);
    trouble = app_file_close(out, ask->marked);
    return trouble != APP_YES ? trouble : code;
}
