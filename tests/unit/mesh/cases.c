/* cases.c: the collected meshes have the numbers of vertices and cells of answers.json, and the
 * pairs of cells listed there meet, or do not, as several exact tools agree. */
#include <criterion/criterion.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/gmp.h>
#include <fmb/mesh.h>
#include <fmb/solve.h>

#include "property/random/rows.h"

static FILE *open_case(const char *key, const char *ending)
{
    char path[1024];
    const char *dot = strrchr(key, '.');
    snprintf(path, sizeof path, CASES "/%.*s%s", (int)(dot - key), key, ending ? ending : dot);
    FILE *in = fopen(path, "rb");
    cr_assert(in, "%s is missing", path);
    return in;
}

static fmb_mesh *read_case(const char *key)
{
    fmb_where w = {0};
    fmb_mesh *m = NULL;
    bool is_tetgen = strstr(key, ".node");
    FILE *in = open_case(key, NULL), *cells = is_tetgen ? open_case(key, ".ele") : NULL;
    fmb_status st = is_tetgen ? fmb_mesh_read_tetgen(in, cells, NULL, &m, &w, NULL)
                              : fmb_mesh_read(in, fmb_mesh_format_of_name(key), NULL, &m, &w);
    cr_assert(st == FMB_OK, "%s:%ld:%ld: %s", key, w.line, w.column, w.text);
    fclose(in);
    if (cells)
        fclose(cells);
    return m;
}

static size_t whole(const json_t *row, size_t i)
{
    return (size_t)json_integer_value(json_array_get(row, i));
}

static bool is_sat(const json_t *row, size_t i)
{
    return strcmp(json_string_value(json_array_get(row, i)), "sat") == 0;
}

/* The cells with these faces, as meshes of their own; a face may be several triangles. How the
 * first and the second meet, at worst. */
static fmb_mesh_how ask_faces(const fmb_mesh *m, size_t a, size_t b)
{
    fmb_mesh *part[2] = {NULL, NULL};
    fmb_mesh_answer answer = {.size = sizeof answer};
    fmb_mesh_how worst = FMB_MESH_APART;
    size_t corners = (size_t)fmb_mesh_corners(m);
    for (int k = 0; k < 2; k++) {
        size_t from = 0, n = 0;
        while (fmb_mesh_face(m, from) < (k ? b : a))
            from++;
        while (from + n < fmb_mesh_cells(m) && fmb_mesh_face(m, from + n) == (k ? b : a))
            n++;
        uint32_t index[4 * 64];
        double point[3 * 4 * 64];
        cr_assert(n > 0 && n <= 64);
        for (size_t i = 0; i < n * corners; i++) {
            size_t v = fmb_mesh_indices(m)[from * corners + i];
            memcpy(point + 3 * i, fmb_mesh_points(m) + 3 * v, 3 * sizeof *point);
            index[i] = (uint32_t)i;
        }
        must(fmb_mesh_new((int)corners, n * corners, point, n, index, NULL, &part[k]));
    }
    must(fmb_mesh_meet(part[0], part[1],
                       &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .neighbours = true},
                       &answer));
    for (size_t i = 0; i < answer.hits; i++)
        worst = answer.hit[i].how > worst ? answer.hit[i].how : worst;
    fmb_mesh_answer_clear(&answer);
    fmb_mesh_free(part[0]);
    fmb_mesh_free(part[1]);
    return worst;
}

/* Rows of faces: [a, b, closed]; of tetrahedra: [shared, a, b, closed, open]. */
static size_t check_pairs(const char *key, const fmb_mesh *m, const json_t *said)
{
    const json_t *rows = json_object_get(json_object_get(said, "pairs"), "rows"), *row;
    size_t i, at = fmb_mesh_corners(m) == 4;
    json_array_foreach(rows, i, row)
    {
        size_t a = whole(row, at), b = whole(row, at + 1);
        fmb_mesh_how how = ask_faces(m, a, b);
        cr_expect((how != FMB_MESH_APART) == is_sat(row, at + 2), "%s: %zu %zu %s", key, a, b,
                  fmb_mesh_how_text(how));
        if (at)
            cr_expect((how == FMB_MESH_CROSS) == is_sat(row, 4), "%s: %zu %zu", key, a, b);
    }
    return json_array_size(rows);
}

static size_t count(const json_t *said, const char *key)
{
    return (size_t)json_integer_value(json_object_get(said, key));
}

Test(cases, meshes)
{
    const char *key;
    json_t *said, *answers = json_load_file(CASES "/geom/answers.json", 0, NULL);
    size_t meshes = 0, pairs = 0;
    if (!answers)
        cr_skip_test("no collected cases here");
    json_object_foreach(answers, key, said)
    {
        if (!json_object_get(said, "vertices"))
            continue;
        fmb_mesh *m = read_case(key);
        size_t tets = count(said, "tets"), last = fmb_mesh_face(m, fmb_mesh_cells(m) - 1);
        cr_expect(fmb_mesh_vertices(m) == count(said, "vertices"), "%s", key);
        cr_expect(last + 1 == (tets ? tets : count(said, "faces")), "%s: %zu", key, last);
        cr_expect((fmb_mesh_corners(m) == 4) == (tets > 0));
        pairs += check_pairs(key, m, said);
        fmb_mesh_free(m);
        meshes++;
    }
    cr_expect(meshes == 25 && pairs >= 2500, "%zu %zu", meshes, pairs);
    json_decref(answers);
}

/* Hulls of points, as the lines that fmb intersect reads. */
static void check_hulls(const char *name, bool *found)
{
    char path[1024], *text = NULL;
    snprintf(path, sizeof path, CASES "/geom/hulls_%s.json", name);
    json_t *said = json_load_file(path, 0, NULL);
    *found = said != NULL;
    if (!said)
        return;
    char *p = json_dumps(json_object_get(said, "P"), JSON_COMPACT);
    char *q = json_dumps(json_object_get(said, "Q"), JSON_COMPACT);
    cr_assert(asprintf(&text,
                       "{\"A\": {\"type\": \"hull\", \"points\": %s}, \"B\": {\"points\": %s, "
                       "\"type\": \"hull\"}}\n",
                       p, q) > 0);
    FILE *in = fmemopen(text, strlen(text), "r");
    fmb_frame_reader *r = NULL;
    const fmb_frame_line *line = NULL;
    fmb_system *s = NULL;
    fmb_solver *v = NULL;
    fmb_result result = {.size = sizeof result};
    must(fmb_frame_reader_new(in, NULL, &r));
    must(fmb_frame_reader_next(r, &line, NULL));
    must(fmb_system_from_line(line, FMB_CONTACT_CLOSED, NULL, &s));
    must(fmb_solver_new(NULL, NULL, &v));
    must(fmb_solve(v, s, &result));
    cr_expect((result.verdict == FMB_FEASIBLE) == json_is_true(json_object_get(said, "expected")),
              "%s", name);
    fmb_solver_free(v);
    fmb_system_free(s);
    fmb_frame_reader_free(r);
    fclose(in);
    free(text);
    free(p);
    free(q);
    json_decref(said);
}

Test(cases, hulls)
{
    static const char *const name[] = {"kroitor-i6a", "kroitor-i6b", "opengjk-userPQ"};
    bool found = true;
    for (int i = 0; found && i < 3; i++)
        check_hulls(name[i], &found);
    if (!found)
        cr_skip_test("no collected cases here");
}
