/* body.c: see bunny.h. */
#include <math.h>
#include <string.h>

#include "common/file.h"
#include "common/message.h"
#include "common/source.h"
#include "fmb-qualify/bunny/bunny.h"

/* ---- meshes ---------------------------------------------------------------------------------- */

enum { RINGS = 186, SPOKES = 188 };

/* In metres, like scans. */
static void put_point_of_ball(int ring, int spoke, double *p)
{
    double u = M_PI * (ring + 0.5) / RINGS, v = 2 * M_PI * spoke / SPOKES;
    double r = 0.06 * (1 + 0.1 * sin(7 * u) * cos(5 * v));
    p[0] = r * sin(u) * cos(v) - 0.017;
    p[1] = r * cos(u) + 0.11;
    p[2] = r * sin(u) * sin(v);
}

static fmb_status make_ball(fmb_mesh **out)
{
    double *point = app_need(malloc(3 * RINGS * SPOKES * sizeof *point));
    uint32_t *corner = app_need(malloc(6 * RINGS * SPOKES * sizeof *corner));
    size_t cells = 0;
    for (int i = 0; i < RINGS * SPOKES; i++)
        put_point_of_ball(i / SPOKES, i % SPOKES, point + 3 * i);
    for (uint32_t i = 0; i < (RINGS - 1) * SPOKES; i++) {
        uint32_t next = i % SPOKES == SPOKES - 1 ? i + 1 - SPOKES : i + 1;
        const uint32_t two[6] = {i, next, i + SPOKES, next, next + SPOKES, i + SPOKES};
        memcpy(corner + 3 * cells, two, sizeof two);
        cells += 2;
    }
    fmb_status st = fmb_mesh_new(3, RINGS * SPOKES, point, cells, corner, NULL, out);
    free(point);
    free(corner);
    return st;
}

int bunny_read(const char *path, fmb_mesh **out)
{
    fmb_where where = {0};
    FILE *in;
    if (!path) {
        fmb_status st = make_ball(out);
        return st == FMB_OK ? APP_YES : app_status_error(st);
    }
    int code = app_file_open(path, &in);
    if (code != APP_YES)
        return code;
    fmb_status st = fmb_mesh_read(in, fmb_mesh_format_of_name(path), NULL, out, &where);
    app_file_close_input(in);
    code = app_source_outcome(st, path, &where);
    if (code == APP_YES && fmb_mesh_corners(*out) != 3) {
        fmb_mesh_free(*out);
        *out = NULL;
        code = app_error(APP_BAD_INPUT, "%s: expected triangles", path);
    }
    return code;
}

/* ---- frames ---------------------------------------------------------------------------------- */

/* Edges q - p and r - p, and the unit vector along their product; 0 for a flat face. */
static void put_frame(const double p[3], const double q[3], const double r[3], double *to)
{
    double *c0 = to + 3, *c1 = to + 6, *c2 = to + 9;
    for (int j = 0; j < 3; j++) {
        to[j] = p[j];
        c0[j] = q[j] - p[j];
        c1[j] = r[j] - p[j];
    }
    for (int j = 0; j < 3; j++) {
        int k = (j + 1) % 3, l = (j + 2) % 3;
        c2[j] = c1[k] * c0[l] - c1[l] * c0[k];
    }
    double length = sqrt(c2[0] * c2[0] + c2[1] * c2[1] + c2[2] * c2[2]);
    for (int j = 0; length > 0 && j < 3; j++)
        c2[j] /= length;
}

static void put_point(const fmb_mesh *m, size_t v, bool mirrored, double p[3])
{
    for (int j = 0; j < 3; j++)
        p[j] = 1000 * fmb_mesh_points(m)[3 * v + (size_t)j];
    if (mirrored) {
        p[0] = 50 - p[0];
        p[1] -= 10;
    }
}

static fmb_status make_cells(bunny_body *b)
{
    double *point = app_need(malloc((12 * b->faces + 1) * sizeof *point));
    uint32_t *corner = app_need(malloc((4 * b->faces + 1) * sizeof *corner));
    for (size_t i = 0; i < 12 * b->faces; i++) {
        size_t face = i / 12, j = i % 3, k = i % 12 / 3;
        const double *number = b->number + 12 * face;
        point[i] = k == 0 ? number[j] : number[j] + number[3 * k + j];
    }
    for (size_t i = 0; i < 4 * b->faces; i++)
        corner[i] = (uint32_t)i;
    fmb_status st = fmb_mesh_new(4, 4 * b->faces, point, b->faces, corner, NULL, &b->cells);
    free(point);
    free(corner);
    return st;
}

fmb_status bunny_body_make(const fmb_mesh *m, bool mirrored, bunny_body *out)
{
    bunny_body b = {.faces = fmb_mesh_cells(m)};
    b.number = app_need(malloc((12 * b.faces + 1) * sizeof *b.number));
    b.frame = app_need(malloc((b.faces + 1) * sizeof *b.frame));
    for (size_t i = 0; i < b.faces; i++) {
        double p[3][3], *to = b.number + 12 * i;
        for (size_t k = 0; k < 3; k++)
            put_point(m, fmb_mesh_indices(m)[3 * i + k], mirrored, p[k]);
        put_frame(p[0], p[1], p[2], to);
        b.frame[i] =
            (fmb_frame){.shape = FMB_SIMPLEX, .dim = 3, .naxes = 3, .origin = to, .axes = to + 3};
    }
    fmb_status st = make_cells(&b);
    if (st == FMB_OK)
        *out = b;
    else
        bunny_body_clear(&b);
    return st;
}

void bunny_body_clear(bunny_body *b)
{
    fmb_mesh_free(b->cells);
    free(b->frame);
    free(b->number);
}
