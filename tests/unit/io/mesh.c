/* mesh.c: meshes from texts and bytes: the meshes read, the errors and their places. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include <fmb/mesh.h>

#include "support/must.h"

static fmb_mesh *read_bytes(const char *text, size_t size, fmb_mesh_format f)
{
    fmb_mesh *m = NULL;
    fmb_where w = {0};
    fmb_status st = fmb_mesh_parse(text, size, f, NULL, &m, &w);
    cr_assert(st == FMB_OK, "%ld:%ld: %s in:\n%s", w.line, w.column, w.text, text);
    return m;
}

static fmb_mesh *read_text(const char *text, fmb_mesh_format f)
{
    return read_bytes(text, strlen(text), f);
}

static void expect_mesh(fmb_mesh *m, int corners, size_t vertices, size_t cells,
                        const uint32_t *corner, const size_t *face)
{
    cr_assert(fmb_mesh_corners(m) == corners && fmb_mesh_vertices(m) == vertices &&
                  fmb_mesh_cells(m) == cells,
              "%d %zu %zu", fmb_mesh_corners(m), fmb_mesh_vertices(m), fmb_mesh_cells(m));
    for (size_t i = 0; i < cells * (size_t)corners; i++)
        cr_expect(fmb_mesh_indices(m)[i] == corner[i], "corner %zu", i);
    for (size_t i = 0; face && i < cells; i++)
        cr_expect(fmb_mesh_face(m, i) == face[i], "face %zu", i);
    fmb_mesh_free(m);
}

static const uint32_t FAN[] = {0, 1, 2, 0, 2, 3, 1, 2, 3};
static const size_t FACE[] = {0, 0, 1};

Test(mesh, off)
{
    static const char *const text[] = {
        "OFF\n4 2 0\n0 0 0\n1 0 0 0.5 colour\n1 1 0\n0 1 1 # last\n4 0 1 2 3 255 0 0\n3 1 2 3\n",
        "# free\nCOFF 4 2 9 0 0 0\n1 0 0\n1. +1 0\n.0 1e0 10e-1\n\n4 0 1 2 3\n3 1 2 3",
        "4 2 0\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 1\r\n4 0 1 2 3\r\n3 1 2 3\r\n",
        "OFF 4 2 0 0 0 0 1 0 0 1 1 0 0\n1\n1 4 0 1 2 3\n3 1 2 3\n", /* points are words */
        "NOFF\n4 2 0\n0 0 0 9 9 9 1 0 0\n9 9 9 # and\n1 1 0 9 9 9\n0 1 1 9 9 9 4 0 1 2 3 1\n3 1 2 "
        "3\n",
        "COFF\n4 2 0\n0 0 0 .5 .5 .5 1 1 0 0 9 9 9 9\n1 1 0 9 9 9 9\n0 1 1 9 9 9 9\n4\n0 1 2 3 "
        "1\n3 1 2 3\n"};
    for (size_t i = 0; i < sizeof text / sizeof *text; i++) {
        fmb_mesh *m = read_text(text[i], i == 2 ? FMB_MESH_OFF : FMB_MESH_AUTO);
        cr_expect(fmb_mesh_points(m)[11] == 1 && fmb_mesh_points(m)[3] == 1);
        expect_mesh(m, 3, 4, 3, FAN, FACE);
    }
}

/* Of the last line g or o before a face, also of faces that are cut, and at another place. */
Test(mesh, groups)
{
    fmb_mesh *placed = NULL,
             *m = read_text(
                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\ng  left  wing # or so\nf 1 2 3 4\n"
                 "o tail\nf 2 3 4\ng\nf 2 3 1\n",
                 FMB_MESH_OBJ);
    static const char *const want[] = {NULL, "left  wing", "left  wing", "tail", NULL};
    must(fmb_mesh_placed(m, &(fmb_mesh_place){{1, 1, 1}, {0, 0, 1}}, NULL, &placed));
    cr_assert(fmb_mesh_cells(m) == 5);
    for (size_t c = 0; c < 7; c++) {
        const char *name = c < 5 ? want[c] : NULL, *got = fmb_mesh_group(m, c),
                   *there = fmb_mesh_group(placed, c);
        cr_expect(name ? got && there && strcmp(got, name) == 0 && strcmp(there, name) == 0
                       : !got && !there,
                  "%zu", c);
    }
    cr_expect(!fmb_mesh_group(NULL, 0));
    fmb_mesh_free(m);
    fmb_mesh_free(placed);
    m = read_text("g a\nv 0 0 0\nv 1 0 0\nv 1 1 0\ng\nf 1 2 3", FMB_MESH_OBJ);
    cr_expect(!fmb_mesh_group(m, 0));
    fmb_mesh_free(m);
}

Test(mesh, obj)
{
    fmb_mesh *m =
        read_text("# free\nmtllib x.mtl\nv 0 0 0\nv 1 0 0 1\nvn 0 0 1\nf 1 2/1 3//1 \\\n 4/1/1\n"
                  "v 1 1 0\nv 0 1 1\ng end\nf -3 -2 -1 # behind\n",
                  FMB_MESH_AUTO);
    expect_mesh(m, 3, 4, 3, FAN, FACE);
}

Test(mesh, ply_text)
{
    fmb_mesh *m =
        read_text("ply\nformat ascii 1.0\ncomment free text\nobj_info more\n"
                  "element face 2\nproperty uchar red\nproperty list uchar int vertex_indices\n"
                  "element vertex 4\nproperty float x\nproperty float confidence\n"
                  "property double y\nproperty float z\nelement edge 1\n"
                  "property list int float weights\nend_header\n"
                  "7 4 0 1 2 3\n8 3 1 2 3\n0 .5 0 0\n1 .5 0 0\n1 nan 1 0\n0 1 1 1\n2 1 nan\n",
                  FMB_MESH_AUTO);
    cr_expect(fmb_mesh_points(m)[4] == 0 && fmb_mesh_points(m)[10] == 1);
    expect_mesh(m, 3, 4, 3, FAN, FACE);
}

/* Bytes on their way into a file. */
typedef struct bytes {
    char p[1024];
    size_t n;
} bytes;

static void put(bytes *b, const void *from, size_t n, bool reversed)
{
    const char *p = from;
    for (size_t i = 0; i < n; i++)
        b->p[b->n++] = p[reversed ? n - 1 - i : i];
}

static void put_float(bytes *b, float x, bool big)
{
    put(b, &x, sizeof x, big);
}

static void put_whole(bytes *b, int32_t x, size_t n, bool big)
{
    put(b, (const char *)&x, n, big && n > 1);
}

Test(mesh, ply_binary)
{
    static const float point[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.1F}};
    for (int big = 0; big < 2; big++) {
        bytes b = {.n = 0};
        const char *format = big ? "big" : "little";
        b.n = (size_t)sprintf(b.p,
                              "ply\nformat binary_%s_endian 1.0\nelement vertex 4\n"
                              "property float32 x\nproperty float y\nproperty float z\n"
                              "property short tag\nelement face 2\n"
                              "property list uint8 int32 vertex_index\nend_header\n",
                              format);
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < 3; j++)
                put_float(&b, point[i][j], big);
            put_whole(&b, -1, 2, big);
        }
        put_whole(&b, 4, 1, big);
        for (int i = 0; i < 4; i++)
            put_whole(&b, i, 4, big);
        put_whole(&b, 3, 1, big);
        for (int i = 1; i < 4; i++)
            put_whole(&b, i, 4, big);
        fmb_mesh *m = read_bytes(b.p, b.n, FMB_MESH_AUTO), *none = NULL;
        cr_expect(fmb_mesh_points(m)[11] == (double)0.1F);
        expect_mesh(m, 3, 4, 3, FAN, FACE);
        fmb_where w;
        cr_expect(fmb_mesh_parse(b.p, b.n - 1, FMB_MESH_AUTO, NULL, &none, &w) == FMB_ERR_PARSE);
        cr_expect(w.line == 0 && strstr(w.text, "end of file"), "%s", w.text);
        put_whole(&b, 4, 0, big);
        b.p[b.n - 4 + (big ? 3 : 0)] = 4;
        cr_expect(fmb_mesh_parse(b.p, b.n, FMB_MESH_AUTO, NULL, &none, &w) == FMB_ERR_PARSE);
        cr_expect(strstr(w.text, "one of 4 vertices"), "%s", w.text);
    }
}

/* A face, then strips: turned, ended by -1, going on by way of a vertex twice, and too short. */
static const uint32_t STRIPS[] = {0, 2, 4, 0, 1, 2, 2, 1, 3, 3, 2, 1, 1, 2, 4, 0, 1, 2, 3, 2, 4};
static const size_t STRIP_FACE[] = {0, 1, 2, 3, 4, 5, 6};

Test(mesh, ply_strips_text)
{
    expect_mesh(read_text("ply\nformat ascii 1.0\nelement face 1\n"
                          "property list uchar int vertex_indices\nelement tristrips 4\n"
                          "property list int int vertex_indices\nelement vertex 5\n"
                          "property float x\nproperty float y\nproperty float z\nend_header\n"
                          "3 0 2 4\n9 0 1 2 3 -1\n3 2 1 4\n6 0 1 2 2 3 4\n0\n4 -1 0 4 -1\n"
                          "0 0 0\n1 0 0\n1 1 0\n0 1 1\n2 2 2\n",
                          FMB_MESH_AUTO),
                3, 5, 7, STRIPS, STRIP_FACE);
}

Test(mesh, ply_strips_binary)
{
    static const int32_t strip[4][10] = {
        {9, 0, 1, 2, 3, -1, 3, 2, 1, 4}, {6, 0, 1, 2, 2, 3, 4}, {0}, {4, -1, 0, 4, -1}};
    static const char *const type[] = {"int8", "short", "int"};
    for (int run = 0; run < 6; run++) {
        const bool big = run % 2 == 1;
        const size_t size = (size_t)1 << run / 2;
        bytes b = {.n = 0};
        b.n = (size_t)sprintf(b.p,
                              "ply\nformat binary_%s_endian 1.0\nelement vertex 5\n"
                              "property uchar x\nproperty uchar y\nproperty uchar z\n"
                              "element face 1\nproperty list uchar uchar vertex_index\n"
                              "element tristrips 4\n"
                              "property list int %s vertex_index\nend_header\n",
                              big ? "big" : "little", type[run / 2]);
        put(&b, "\0\0\0\1\0\0\1\1\0\0\1\1\2\2\2\3\0\2\4", 19, false);
        for (int i = 0; i < 4; i++) {
            put_whole(&b, strip[i][0], 4, big);
            for (int k = 1; k <= strip[i][0]; k++)
                put(&b, (const char *)&strip[i][k], size, big);
        }
        expect_mesh(read_bytes(b.p, b.n, FMB_MESH_AUTO), 3, 5, 7, STRIPS, STRIP_FACE);
        fmb_mesh *none = NULL;
        fmb_where w = {0};
        cr_expect(fmb_mesh_parse(b.p, b.n - 1, FMB_MESH_AUTO, NULL, &none, &w) == FMB_ERR_PARSE);
        cr_expect(strstr(w.text, "end of file"), "%s", w.text);
        b.p[b.n - (big ? 1 : size)] = '\xfe';
        cr_expect(fmb_mesh_parse(b.p, b.n, FMB_MESH_AUTO, NULL, &none, &w) == FMB_ERR_PARSE);
        cr_expect(strstr(w.text, "or -1, found a negative number"), "%s", w.text);
    }
}

Test(mesh, stl)
{
    static const uint32_t corner[] = {0, 1, 2, 3, 4, 5};
    bytes b = {.n = 80};
    memcpy(b.p, "solid", 5);
    put_whole(&b, 2, 4, false);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 12; i++)
            put_float(&b, i < 3 ? NAN : (float)(i * i % (5 + k)), false);
        put_whole(&b, 0, 2, false);
    }
    expect_mesh(read_bytes(b.p, b.n, FMB_MESH_AUTO), 3, 6, 2, corner, NULL);
    expect_mesh(
        read_text("solid a name\nfacet normal 0 nan 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                  "vertex 0 1 0\nendloop\nendfacet\nendsolid a name\nsolid\n  FACET normal 1 1 1\n"
                  "OUTER LOOP VERTEX 0 0 0 vertex 1 0 0 vertex 0 0 1 endloop endfacet\nendsolid",
                  FMB_MESH_AUTO),
        3, 6, 2, corner, NULL);
}

Test(mesh, medit)
{
    static const uint32_t corner[] = {0, 1, 2, 3};
    static const char vertices[] =
        "MeshVersionFormatted 2\nDimension\n3\n# free\nVertices\n4\n0 0 0 1\n"
        "1 0 0 1\n1 1 0 7\n0 1 1 0\n";
    char text[512];
    sprintf(text,
            "%sQuadrilaterals 1\n1 2 3 4 9\nEdges 2\n1 2 0\n2 3 0\nTriangles\n1\n2 3 4 9\nEnd\n",
            vertices);
    expect_mesh(read_text(text, FMB_MESH_AUTO), 3, 4, 3, FAN, FACE);
    sprintf(text, "%sTriangles 1 1 2 3 0 Tetrahedra 1\n1 2 3 4 0\n", vertices);
    expect_mesh(read_text(text, FMB_MESH_AUTO), 4, 4, 1, corner, NULL);
}

static fmb_status read_tetgen(const char *node, const char *ele, fmb_mesh **out, fmb_where *w,
                              bool *in_cells)
{
    FILE *points = fmemopen((void *)(uintptr_t)node, strlen(node), "r");
    FILE *cells = fmemopen((void *)(uintptr_t)ele, strlen(ele), "r");
    fmb_status st = fmb_mesh_read_tetgen(points, cells, NULL, out, w, in_cells);
    fclose(points);
    fclose(cells);
    return st;
}

Test(mesh, tetgen)
{
    static const char node[] =
        "# points\n4 3 1 1\n1 0 0 0 7 1\n2 1 0 0 7 1\n3 1 1 0 7 1\n4 0 1 1 7 0\n";
    static const char *const bad[][3] = {{node, "1 5 0\n", "4 or 10"},
                                         {node, "1 4 0\n3 1 2 3 4\n", "line number 1"},
                                         {node, "1 4 0\n1 1 2 3 0\n", "one of 4 vertices"},
                                         {"4 2\n", "1 4 0\n", "3 dimensions"},
                                         {"2 3\n0 0 0 0\n2 0 0 0\n", "1 4 0\n", "line number 1"}};
    static const uint32_t corner[] = {0, 1, 2, 3};
    fmb_mesh *m = NULL;
    fmb_where w = {0};
    bool in_cells = false;
    cr_assert(read_tetgen(node, "1 4 1\n1 1 2 3 4 -5\n", &m, &w, &in_cells) == FMB_OK);
    expect_mesh(m, 4, 4, 1, corner, NULL);
    m = NULL;
    for (int i = 0; i < 5; i++) {
        cr_expect(read_tetgen(bad[i][0], bad[i][1], &m, &w, &in_cells) == FMB_ERR_PARSE && !m);
        cr_expect(strstr(w.text, bad[i][2]) && in_cells == (i < 3), "%d: %s", i, w.text);
    }
    cr_expect(fmb_mesh_read_tetgen(NULL, stdin, NULL, &m, &w, NULL) == FMB_ERR_ARG);
}

typedef struct mistake {
    fmb_mesh_format format;
    long line, column;
    const char *piece, *text;
} mistake;

#define PLY_HEAD "ply\nformat ascii 1.0\n"
#define PLY_STRIP                                                                                  \
    PLY_HEAD "element vertex 1\nproperty int x\nproperty int y\nproperty int z\n"                  \
             "element tristrips 1\nproperty list int "

static const mistake mistakes[] = {
    {FMB_MESH_OFF, 1, 1, "OFF", "OGF\n"},
    {FMB_MESH_OFF, 2, 1, "at most", "OFF\n99999999999 1 0\n"},
    {FMB_MESH_OFF, 2, 1, "number of vertices", "OFF\n3e2 1 0\n"},
    {FMB_MESH_OFF, 3, 1, "end of file", "OFF\n1000000000 1000000000 0\n"},
    {FMB_MESH_OFF, 3, 3, "a number, found 'x'", "OFF\n3 1 0\n0 x 0\n"},
    {FMB_MESH_OFF, 3, 3, "a number, found '1x'", "OFF\n3 1 0\n0 1x 0\n"},
    {FMB_MESH_OFF, 3, 3, "beyond", "OFF\n3 1 0\n0 1e400 0\n"},
    {FMB_MESH_OFF, 6, 1, "at least 3", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n"},
    {FMB_MESH_OFF, 6, 7, "one of 3 vertices", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"},
    {FMB_MESH_OFF, 0, 0, "found none", "OFF\n0 0 0\n"},
    {FMB_MESH_OFF, 1, 4, "NUL", "OFF\0\n"},
    {FMB_MESH_OBJ, 1, 5, "a number", "v 1 one 2\n"},
    {FMB_MESH_OBJ, 1, 6, "end of line", "v 1 2\n"},
    {FMB_MESH_OBJ, 2, 3, "numbered from 1", "v 0 0 0\nf 0 1 1\n"},
    {FMB_MESH_OBJ, 2, 3, "numbered from 1", "v 0 0 0\nf -2 1 1\n"},
    {FMB_MESH_OBJ, 2, 1, "at least 3", "v 0 0 0\nf 1 1\n"},
    {FMB_MESH_OBJ, 2, 5, "number of a vertex", "v 0 0 0\nf 1 1x 1\n"},
    {FMB_MESH_OBJ, 0, 0, "expected 2 vertices", "v 0 0 0\nf 1 1 2\n"},
    {FMB_MESH_PLY, 1, 1, "ply", "plx\n"},
    {FMB_MESH_PLY, 2, 8, "ascii", "ply\nformat text 1.0\n"},
    {FMB_MESH_PLY, 2, 14, "1.0", "ply\nformat ascii 2.0\n"},
    {FMB_MESH_PLY, 3, 1, "before", PLY_HEAD "property float x\n"},
    {FMB_MESH_PLY, 4, 10, "a type", PLY_HEAD "element vertex 1\nproperty real x\n"},
    {FMB_MESH_PLY, 4, 15, "whole",
     PLY_HEAD "element face 1\nproperty list float int vertex_index\n"},
    {FMB_MESH_PLY, 5, 1, "before", PLY_HEAD "element vertex 1\nproperty float x\nproperty int x\n"},
    {FMB_MESH_PLY, 0, 0, "x, y and z", PLY_HEAD "element vertex 1\nproperty float x\nend_header\n"},
    {FMB_MESH_PLY, 0, 0, "vertex_indices", PLY_HEAD "element face 1\nproperty int x\nend_header\n"},
    {FMB_MESH_PLY, 4, 1, "end_header", PLY_HEAD "element vertex 1\n"},
    {FMB_MESH_PLY, 6, 1, "end of file",
     PLY_HEAD "element other 4000000000\nproperty int x\nend_header\n"},
    {FMB_MESH_PLY, 0, 0, "at least 3 corners",
     PLY_HEAD "element face 1\nproperty list int int vertex_index\nend_header\n2 0 1\n"},
    {FMB_MESH_PLY, 0, 0, "vertex_indices",
     PLY_HEAD "element tristrips 1\nproperty list int float vertex_indices\nend_header\n"},
    {FMB_MESH_PLY, 11, 5, "a vertex or -1, found",
     PLY_STRIP "int vertex_index\nend_header\n0 0 0\n2 0 -2\n"},
    {FMB_MESH_PLY, 11, 5, "a vertex or -1, found",
     PLY_STRIP "uint vertex_index\nend_header\n0 0 0\n2 0 -1\n"},
    {FMB_MESH_PLY, 11, 4, "end of file", PLY_STRIP "int vertex_index\nend_header\n0 0 0\n2 0"},
    {FMB_MESH_PLY, 0, 0, "in tristrips, found 7",
     PLY_STRIP "int vertex_index\nend_header\n0 0 0\n2 0 7\n"},
    {FMB_MESH_STL, 1, 1, "solid", "solit\n"},
    {FMB_MESH_STL, 2, 1, "facet or endsolid", "solid\nface\n"},
    {FMB_MESH_STL, 3, 1, "outer", "solid\nfacet normal 0 0 1\nvertex\n"},
    {FMB_MESH_STL, 2, 1, "end of file", "solid\n"},
    {FMB_MESH_MEDIT, 2, 11, "3 dimensions", "MeshVersionFormatted 1\nDimension 2\n"},
    {FMB_MESH_MEDIT, 2, 1, "a keyword", "MeshVersionFormatted 1\n{\n"},
    {FMB_MESH_MEDIT, 4, 1, "numbered from 1", "Vertices 1\n0 0 0 0\nTriangles 1\n0 1 1 0\n"},
};

Test(mesh, mistakes)
{
    for (size_t i = 0; i < sizeof mistakes / sizeof *mistakes; i++) {
        const mistake *m = &mistakes[i];
        size_t size = m->piece[0] == 'N' ? 5 : strlen(m->text);
        fmb_mesh *out = NULL;
        fmb_where w = {0};
        fmb_status st = fmb_mesh_parse(m->text, size, m->format, NULL, &out, &w);
        cr_expect(st == FMB_ERR_PARSE && !out, "%zu: %s", i, fmb_status_text(st));
        cr_expect(w.line == m->line && w.column == m->column && strstr(w.text, m->piece),
                  "%zu: %ld:%ld: %s", i, w.line, w.column, w.text);
    }
}

Test(mesh, arguments)
{
    fmb_mesh *m = NULL;
    fmb_where w;
    cr_expect(fmb_mesh_read(NULL, FMB_MESH_AUTO, NULL, &m, &w) == FMB_ERR_ARG && w.text[0]);
    cr_expect(fmb_mesh_read(stdin, FMB_MESH_AUTO, NULL, NULL, &w) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_parse(NULL, 1, FMB_MESH_AUTO, NULL, &m, &w) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_parse("", 0, (fmb_mesh_format)77, NULL, &m, &w) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_parse("", 0, FMB_MESH_AUTO, NULL, &m, &w) == FMB_ERR_PARSE);
    cr_expect(fmb_mesh_parse("OFF\n", 4, FMB_MESH_OFF,
                             &(fmb_reader){.size = sizeof(fmb_reader), .max_bytes = 3}, &m,
                             &w) == FMB_ERR_PARSE);
}

Test(mesh, formats)
{
    fmb_mesh_format f;
    cr_expect(fmb_mesh_format_of_name("a.b/bunny.PLY") == FMB_MESH_PLY);
    cr_expect(fmb_mesh_format_of_name("a.ply/bunny") == FMB_MESH_AUTO);
    cr_expect(fmb_mesh_format_of_name(NULL) == FMB_MESH_AUTO);
    for (int i = 0; i <= FMB_MESH_MEDIT; i++)
        cr_expect(fmb_mesh_format_parse(fmb_mesh_format_text((fmb_mesh_format)i), &f) &&
                  f == (fmb_mesh_format)i);
    cr_expect(!fmb_mesh_format_parse("fmb", &f));
}
