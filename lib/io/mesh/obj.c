/* obj.c: Wavefront OBJ, one statement per line: v and f are read, g and o name the following faces,
 * and all others concern appearance and are skipped. Faces may name vertices that come later;
 * negative numbers count back from the last vertex.
 */
#include <string.h>

#include "io/core/number.h"
#include "io/mesh/mesh_draft.h"

/* Blanks, and line ends behind a backslash. */
static void skip_blanks_of_statement(fmb_cursor *c)
{
    for (fmb_skip_blanks(c); fmb_peek(c) == '\\'; fmb_skip_blanks(c)) {
        const char *p = c->at++;
        fmb_skip_blanks(c);
        if (fmb_peek(c) != '\n') {
            c->at = p;
            return;
        }
        c->at++;
    }
}

static bool is_end_of_statement(const fmb_cursor *c)
{
    return fmb_peek(c) < 0 || fmb_peek(c) == '\n' || fmb_peek(c) == '#';
}

/* "7", "-1", with "/2/3" behind it, which is texture and normal. */
static fmb_status read_obj_corner(fmb_cursor *c, fmb_mesh_draft *d)
{
    const char *p = c->at;
    bool back = fmb_accept(c, "-");
    size_t v = 0;
    FMB_TRY(fmb_scan_count(c, FMB_MESH_MOST, "the number of a vertex", &v));
    if (v == 0 || (back && v > d->points))
        return fmb_io_expected(c, p, "one of %zu vertices, numbered from 1", d->points);
    if (fmb_peek(c) == '/')
        fmb_scan_word(c);
    if (!is_end_of_statement(c) && !strchr(" \t\r\f\v\\", fmb_peek(c)))
        return fmb_io_expected(c, p, "the number of a vertex");
    return fmb_mesh_draft_corner(c, d, back ? d->points - v : v - 1);
}

static fmb_status read_obj_face(fmb_cursor *c, fmb_mesh_draft *d, const char *p)
{
    fmb_mesh_draft_face(d);
    for (d->skip(c); !is_end_of_statement(c); d->skip(c))
        FMB_TRY(read_obj_corner(c, d));
    if (d->face_corners < 3)
        return fmb_io_fail(c, p, "expected a face of at least 3 corners, found %d",
                           d->face_corners);
    return FMB_OK;
}

/* All words of the line, as they stand. */
static fmb_status read_obj_group(fmb_cursor *c, fmb_mesh_draft *d)
{
    fmb_skip_blanks(c);
    fmb_span name = {c->at, 0};
    for (; !is_end_of_statement(c); fmb_skip_blanks(c)) {
        fmb_span word = fmb_scan_word(c);
        name.n = (size_t)(word.p + word.n - name.p);
    }
    return fmb_mesh_draft_group(c, d, name);
}

static fmb_status read_obj_statement(fmb_cursor *c, fmb_mesh_draft *d)
{
    double x[3];
    fmb_skip_blanks(c);
    const char *p = c->at;
    fmb_span word = fmb_scan_word(c);
    if (fmb_span_is(word, "f"))
        return read_obj_face(c, d, p);
    if (fmb_span_is(word, "g") || fmb_span_is(word, "o"))
        return read_obj_group(c, d);
    if (!fmb_span_is(word, "v"))
        return FMB_OK;
    FMB_TRY(fmb_mesh_scan_point(c, d, x));
    return fmb_mesh_draft_point(c, d, x);
}

/* All faces are read: are all their corners there? */
static fmb_status check_obj_corners(fmb_cursor *c, const fmb_mesh_draft *d)
{
    for (size_t i = 0; i < 3 * d->triangles; i++)
        if (d->triangle[i] >= d->points)
            return fmb_io_fail(
                c, NULL, "expected %zu vertices, as face %zu has one with that number, found %zu",
                (size_t)d->triangle[i] + 1, (size_t)d->face[i / 3] + 1, d->points);
    return FMB_OK;
}

fmb_status fmb_mesh_read_obj(fmb_cursor *c, fmb_mesh_draft *d)
{
    fmb_status st = FMB_OK;
    d->skip = skip_blanks_of_statement;
    while (st == FMB_OK && c->at < c->end) {
        st = read_obj_statement(c, d);
        fmb_next_line(c);
    }
    return st == FMB_OK ? check_obj_corners(c, d) : st;
}
