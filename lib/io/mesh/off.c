/* off.c: Geomview's OFF: counts, points, faces with a number of corners each. The rest of the line
 * of a face is its colour, and skipped. Points are numbers regardless of lines; but many programs
 * write colours after them that the header does not declare. So if there is one line per point and
 * per face, the rest of a point's line is skipped; otherwise a point has as many numbers as the
 * header says.
 */
#include "io/mesh/mesh_draft.h"

/* "OFF", or with colours or normals of points (COFF, NOFF): then *more numbers per point are
 * skipped. Other letters mean other kinds of points. The header may be missing. */
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

/* From c on, is there one line per point, of at least three words, and one per face? A file could
 * satisfy this by accident only with a face on two lines. */
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
