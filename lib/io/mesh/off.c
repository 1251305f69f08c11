/* off.c: Geomview's OFF: counts, points, faces with as many corners as they say. What stands behind
 * the corners in the line of a face is its colour, and passed over. Points are words, not lines;
 * but many programs write colours behind them without saying so. So where there is a line for each
 * point and each face, the rest of a point's line is passed over; elsewhere a point is as many
 * numbers as the header says.
 */
#include "io/mesh/mesh_draft.h"

/* "OFF", and colours or normals with the points (COFF, NOFF), which are then passed over as well:
 * *more numbers. Other letters mean other points. The header may be missing. */
static fmb_status read_off_header(fmb_cursor *c, int *more)
{
    fmb_mesh_skip_comments(c);
    const char *p = c->at;
    *more = 0;
    if (fmb_peek(c) >= '0' && fmb_peek(c) <= '9')
        return FMB_OK;
    fmb_span word = fmb_scan_word(c);
    *more = fmb_span_is(word, "COFF") ? 4 : fmb_span_is(word, "NOFF") ? 3 : 0;
    if (*more > 0 || fmb_span_is(word, "OFF"))
        return FMB_OK;
    return fmb_io_expected(c, p, "OFF, COFF or NOFF");
}

/* Words up to the end of the line, or a comment. */
static size_t skip_words_of_line(fmb_cursor *c)
{
    size_t words = 0;
    for (fmb_skip_blanks(c); fmb_peek(c) >= 0 && fmb_peek(c) != '\n' && fmb_peek(c) != '#';
         words++) {
        fmb_scan_word(c);
        fmb_skip_blanks(c);
    }
    fmb_skip_line(c);
    return words;
}

/* From here on there is a line for each point, of three words at least, and one for each face. A
 * file of which that is true by accident has a face on two lines. */
static bool has_line_for_each(fmb_cursor c, size_t vertices, size_t faces)
{
    size_t lines = 0;
    bool good = true;
    for (fmb_mesh_skip_comments(&c); good && fmb_peek(&c) >= 0; fmb_mesh_skip_comments(&c)) {
        size_t words = skip_words_of_line(&c);
        good = lines++ >= vertices || words >= 3;
    }
    return good && lines == vertices + faces;
}

static fmb_status read_off_points(fmb_cursor *c, fmb_mesh_draft *d, size_t vertices, int more,
                                  bool by_lines)
{
    double p[3], ignored;
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < vertices; i++) {
        st = fmb_mesh_scan_point(c, d, p);
        FMB_THEN(st, fmb_mesh_draft_point(c, d, p));
        if (by_lines)
            fmb_skip_line(c);
        for (int j = 0; !by_lines && st == FMB_OK && j < more; j++)
            st = fmb_mesh_scan_real(c, d, &ignored);
    }
    return st;
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
        FMB_THEN(st, fmb_mesh_draft_corner(c, d, v));
    }
    fmb_skip_line(c);
    return st;
}

fmb_status fmb_mesh_read_off(fmb_cursor *c, fmb_mesh_draft *d)
{
    size_t vertices = 0, faces = 0, edges;
    int more;
    d->skip = fmb_mesh_skip_comments;
    FMB_TRY(read_off_header(c, &more));
    FMB_TRY(fmb_mesh_scan_size(c, d, "the number of vertices", &vertices));
    FMB_TRY(fmb_mesh_scan_size(c, d, "the number of faces", &faces));
    FMB_TRY(fmb_mesh_scan_size(c, d, "the number of edges", &edges));
    FMB_TRY(read_off_points(c, d, vertices, more, has_line_for_each(*c, vertices, faces)));
    for (size_t i = 0; i < faces; i++)
        FMB_TRY(read_off_face(c, d));
    return FMB_OK;
}
