/* mesh_draft.c: see mesh_draft.h. */
#include <string.h>

#include "io/mesh/mesh_draft.h"

#include "io/core/number.h"

void fmb_mesh_draft_clear(fmb_mesh_draft *d)
{
    fmb_mem_put(d->mem, d->point, d->point_capacity, 3 * sizeof *d->point);
    fmb_mem_put(d->mem, d->triangle, d->triangle_capacity, 3 * sizeof *d->triangle);
    fmb_mem_put(d->mem, d->face, d->face_capacity, sizeof *d->face);
    fmb_mem_put(d->mem, d->group, d->group_capacity, sizeof *d->group);
    fmb_mem_put(d->mem, d->names, d->name_capacity, 1);
    fmb_mem_put(d->mem, d->tetrahedron, d->tetrahedron_capacity, 4 * sizeof *d->tetrahedron);
}

static fmb_status refuse_more(fmb_cursor *c, const char *what)
{
    return fmb_io_fail(c, c->at, "expected at most %zu %s", FMB_MESH_MOST, what);
}

fmb_status fmb_mesh_draft_point(fmb_cursor *c, fmb_mesh_draft *d, const double p[3])
{
    if (d->points == FMB_MESH_MOST)
        return refuse_more(c, "vertices");
    FMB_TRY(fmb_mem_reserve(d->mem, (void **)&d->point, &d->point_capacity, d->points + 1,
                            3 * sizeof *d->point));
    for (int j = 0; j < 3; j++)
        d->point[3 * d->points + (size_t)j] = p[j];
    d->points++;
    return FMB_OK;
}

void fmb_mesh_draft_face(fmb_mesh_draft *d)
{
    d->faces++;
    d->face_corners = 0;
}

static fmb_status append_triangle(fmb_cursor *c, fmb_mesh_draft *d, uint32_t third)
{
    if (d->triangles == FMB_MESH_MOST || d->faces > FMB_MESH_MOST)
        return refuse_more(c, "triangles");
    FMB_TRY(fmb_mem_reserve(d->mem, (void **)&d->triangle, &d->triangle_capacity, d->triangles + 1,
                            3 * sizeof *d->triangle));
    FMB_TRY(FMB_RESERVE(d->mem, &d->face, &d->face_capacity, d->triangles + 1));
    if (d->names_size > 0)
        FMB_TRY(FMB_RESERVE(d->mem, &d->group, &d->group_capacity, d->triangles + 1));
    if (d->names_size > 0)
        d->group[d->triangles] = d->group_now;
    uint32_t *to = d->triangle + 3 * d->triangles;
    to[0] = d->first;
    to[1] = d->last;
    to[2] = third;
    d->face[d->triangles++] = (uint32_t)(d->faces - 1);
    return FMB_OK;
}

fmb_status fmb_mesh_draft_corner(fmb_cursor *c, fmb_mesh_draft *d, size_t vertex)
{
    fmb_status st = d->face_corners >= 2 ? append_triangle(c, d, (uint32_t)vertex) : FMB_OK;
    if (d->face_corners == 0)
        d->first = (uint32_t)vertex;
    d->last = (uint32_t)vertex;
    d->face_corners += d->face_corners < 3;
    return st;
}

/* At the first name: triangles before it belong to no group. */
static fmb_status begin_names(fmb_mesh_draft *d)
{
    FMB_TRY(fmb_mem_reserve(d->mem, (void **)&d->names, &d->name_capacity, 1, 1));
    if (d->triangles > 0)
        FMB_TRY(FMB_RESERVE(d->mem, &d->group, &d->group_capacity, d->triangles));
    for (size_t i = 0; i < d->triangles; i++)
        d->group[i] = 0;
    d->names[d->names_size++] = '\0';
    return FMB_OK;
}

fmb_status fmb_mesh_draft_group(fmb_cursor *c, fmb_mesh_draft *d, fmb_span name)
{
    d->group_now = 0;
    if (name.n == 0)
        return FMB_OK;
    if (name.n >= FMB_MESH_MOST - d->names_size)
        return refuse_more(c, "bytes of names");
    FMB_TRY(d->names_size == 0 ? begin_names(d) : FMB_OK);
    FMB_TRY(fmb_mem_reserve(d->mem, (void **)&d->names, &d->name_capacity,
                            d->names_size + name.n + 1, 1));
    d->group_now = (uint32_t)d->names_size;
    memcpy(d->names + d->names_size, name.p, name.n);
    d->names_size += name.n;
    d->names[d->names_size++] = '\0';
    return FMB_OK;
}

fmb_status fmb_mesh_draft_tetrahedron(fmb_cursor *c, fmb_mesh_draft *d, const uint32_t corner[4])
{
    if (d->tetrahedra == FMB_MESH_MOST)
        return refuse_more(c, "tetrahedra");
    FMB_TRY(fmb_mem_reserve(d->mem, (void **)&d->tetrahedron, &d->tetrahedron_capacity,
                            d->tetrahedra + 1, 4 * sizeof *d->tetrahedron));
    for (int k = 0; k < 4; k++)
        d->tetrahedron[4 * d->tetrahedra + (size_t)k] = corner[k];
    d->tetrahedra++;
    return FMB_OK;
}

/* ---- words of a text ------------------------------------------------------------------------- */

void fmb_mesh_skip_comments(fmb_cursor *c)
{
    fmb_skip_space(c);
    while (fmb_peek(c) == '#') {
        fmb_skip_line(c);
        fmb_skip_space(c);
    }
}

static bool is_end_of_word(const fmb_cursor *c)
{
    int b = fmb_peek(c);
    return b < 0 || b == ' ' || (b >= '\t' && b <= '\r') || b == '#';
}

/* Check that the number that began at p ends as a word. */
static fmb_status check_end_of_number(fmb_cursor *c, const char *p, const char *what)
{
    return is_end_of_word(c) ? FMB_OK : fmb_io_expected(c, p, "%s", what);
}

fmb_status fmb_mesh_scan_real(fmb_cursor *c, const fmb_mesh_draft *d, double *out)
{
    d->skip(c);
    const char *p = c->at;
    FMB_TRY(fmb_scan_nearest(c, "a number", out));
    return check_end_of_number(c, p, "a number");
}

fmb_status fmb_mesh_scan_point(fmb_cursor *c, const fmb_mesh_draft *d, double out[3])
{
    for (int j = 0; j < 3; j++)
        FMB_TRY(fmb_mesh_scan_real(c, d, &out[j]));
    return FMB_OK;
}

fmb_status fmb_mesh_scan_size(fmb_cursor *c, const fmb_mesh_draft *d, const char *what, size_t *out)
{
    d->skip(c);
    const char *p = c->at;
    FMB_TRY(fmb_scan_count(c, FMB_MESH_MOST, what, out));
    return check_end_of_number(c, p, what);
}

fmb_status fmb_mesh_scan_vertex(fmb_cursor *c, const fmb_mesh_draft *d, size_t base,
                                size_t vertices, size_t *out)
{
    size_t v = 0;
    d->skip(c);
    const char *p = c->at;
    FMB_TRY(fmb_mesh_scan_size(c, d, "the number of a vertex", &v));
    if (v < base || v - base >= vertices)
        return fmb_io_expected(c, p, "one of %zu vertices, numbered from %zu", vertices, base);
    *out = v - base;
    return FMB_OK;
}

/* ---- binary numbers -------------------------------------------------------------------------- */

fmb_status fmb_mesh_take_bytes(fmb_cursor *c, int n, bool big_endian, const char *what,
                               uint64_t *out)
{
    uint64_t x = 0;
    if (c->end - c->at < n)
        return fmb_io_fail(c, NULL, "expected %s, found end of file", what);
    for (int k = 0; k < n; k++)
        x |= (uint64_t)(unsigned char)c->at[k] << 8 * (big_endian ? n - 1 - k : k);
    c->at += n;
    *out = x;
    return FMB_OK;
}

double fmb_mesh_real_of_bits(uint64_t bits, int n)
{
    uint32_t half = (uint32_t)bits;
    float single;
    double twice;
    memcpy(&single, &half, sizeof single);
    memcpy(&twice, &bits, sizeof twice);
    return n == 4 ? (double)single : twice;
}
