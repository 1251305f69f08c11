/* off.c: Geomview's OFF: counts, points, faces with as many corners as they say. What stands behind
 * the corners in the line of a face is its colour, and passed over.
 */
#include "io/mesh/draft.h"

/* "OFF", and colours or normals with the points (COFF, NOFF), which are then passed over as well;
 * other letters mean other points. The header may be missing. */
static fmb_status read_off_header(fmb_cursor *c)
{
    fmb_mesh_skip_comments(c);
    const char *p = c->at;
    if (fmb_peek(c) >= '0' && fmb_peek(c) <= '9')
        return FMB_OK;
    fmb_span word = fmb_scan_word(c);
    if (fmb_span_is(word, "OFF") || fmb_span_is(word, "COFF") || fmb_span_is(word, "NOFF"))
        return FMB_OK;
    char found[FMB_QUOTE];
    return fmb_io_fail(c, p, "expected OFF, COFF or NOFF, found %s", fmb_quote(c, p, found));
}

static fmb_status read_off_face(fmb_cursor *c, fmb_mesh_draft *d)
{
    size_t corners, v;
    d->skip(c);
    const char *p = c->at;
    fmb_status st = fmb_mesh_scan_size(c, d, "the number of corners of a face", &corners);
    if (st == FMB_OK && corners < 3)
        st = fmb_io_fail(c, p, "expected a face of at least 3 corners, found %zu", corners);
    if (st == FMB_OK)
        fmb_mesh_draft_face(d);
    for (size_t k = 0; st == FMB_OK && k < corners; k++) {
        st = fmb_mesh_scan_vertex(c, d, 0, d->points, &v);
        if (st == FMB_OK)
            st = fmb_mesh_draft_corner(c, d, v);
    }
    fmb_skip_line(c);
    return st;
}

fmb_status fmb_mesh_read_off(fmb_cursor *c, fmb_mesh_draft *d)
{
    size_t vertices = 0, faces = 0, edges;
    double p[3];
    d->skip = fmb_mesh_skip_comments;
    fmb_status st = read_off_header(c);
    if (st == FMB_OK)
        st = fmb_mesh_scan_size(c, d, "the number of vertices", &vertices);
    if (st == FMB_OK)
        st = fmb_mesh_scan_size(c, d, "the number of faces", &faces);
    if (st == FMB_OK)
        st = fmb_mesh_scan_size(c, d, "the number of edges", &edges);
    for (size_t i = 0; st == FMB_OK && i < vertices; i++) {
        st = fmb_mesh_scan_point(c, d, p);
        if (st == FMB_OK)
            st = fmb_mesh_draft_point(c, d, p);
        fmb_skip_line(c);
    }
    for (size_t i = 0; st == FMB_OK && i < faces; i++)
        st = read_off_face(c, d);
    return st;
}
