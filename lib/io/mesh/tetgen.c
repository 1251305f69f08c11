/* tetgen.c: TetGen's .node and .ele: counts, then numbered lines of points and tetrahedra. The
 * number of the first point, 0 or 1, is the base of numbers in both files; the rest of a line after
 * coordinates or corners is skipped.
 */
#include "io/mesh/mesh_draft.h"

/* Read the number at the start of a line; numbers must be consecutive. */
static fmb_status read_line_number(fmb_cursor *c, fmb_mesh_draft *d, size_t i, size_t *base)
{
    size_t number = 0;
    d->skip(c);
    const char *p = c->at;
    FMB_TRY(fmb_mesh_scan_size(c, d, "the number of a line", &number));
    if (i == 0 && number <= 1)
        *base = number;
    if (number != *base + i)
        return fmb_io_fail(c, p, "expected line number %zu, found %zu", *base + i, number);
    return FMB_OK;
}

fmb_status fmb_mesh_read_node(fmb_cursor *c, fmb_mesh_draft *d)
{
    size_t points = 0, dim = 3;
    double p[3];
    d->skip = fmb_mesh_skip_comments;
    fmb_status st = fmb_mesh_scan_size(c, d, "the number of points", &points);
    d->skip(c);
    const char *at = c->at;
    FMB_THEN(st, fmb_mesh_scan_size(c, d, "the dimension", &dim));
    if (st == FMB_OK && dim != 3)
        st = fmb_io_fail(c, at, "expected 3 dimensions, found %zu", dim);
    fmb_skip_line(c);
    for (size_t i = 0; st == FMB_OK && i < points; i++) {
        st = read_line_number(c, d, i, &d->base);
        FMB_THEN(st, fmb_mesh_scan_point(c, d, p));
        FMB_THEN(st, fmb_mesh_draft_point(c, d, p));
        fmb_skip_line(c);
    }
    return st;
}

fmb_status fmb_mesh_read_ele(fmb_cursor *c, fmb_mesh_draft *d)
{
    size_t cells = 0, corners = 4, first = d->base;
    uint32_t corner[4];
    d->skip = fmb_mesh_skip_comments;
    fmb_status st = fmb_mesh_scan_size(c, d, "the number of tetrahedra", &cells);
    d->skip(c);
    const char *at = c->at;
    FMB_THEN(st, fmb_mesh_scan_size(c, d, "the number of corners", &corners));
    if (st == FMB_OK && corners != 4 && corners != 10)
        st = fmb_io_fail(c, at, "expected 4 or 10 corners of a tetrahedron, found %zu", corners);
    fmb_skip_line(c);
    for (size_t i = 0; st == FMB_OK && i < cells; i++) {
        st = read_line_number(c, d, i, &first);
        for (int k = 0; st == FMB_OK && k < 4; k++) {
            size_t v = 0;
            st = fmb_mesh_scan_vertex(c, d, d->base, d->points, &v);
            corner[k] = (uint32_t)v;
        }
        FMB_THEN(st, fmb_mesh_draft_tetrahedron(c, d, corner));
        fmb_skip_line(c);
    }
    return st;
}
