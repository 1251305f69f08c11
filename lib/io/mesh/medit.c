/* medit.c: medit's .mesh: sections of a keyword, a count and lines. Each line ends in a reference
 * number, which is skipped, as are sections other than points, faces and tetrahedra.
 */
#include "io/core/cursor.h"
#include "io/mesh/mesh_draft.h"

/* Skip the numbers of a section that is not used. */
static fmb_status skip_numbers(fmb_cursor *c, fmb_mesh_draft *d)
{
    for (d->skip(c); fmb_starts_number(fmb_peek(c)); d->skip(c))
        fmb_scan_word(c);
    return FMB_OK;
}

static fmb_status check_dimension(fmb_cursor *c, fmb_mesh_draft *d)
{
    size_t dim = 0;
    d->skip(c);
    const char *p = c->at;
    FMB_TRY(fmb_mesh_scan_size(c, d, "3", &dim));
    return dim != 3 ? fmb_io_fail(c, p, "expected 3 dimensions, found %zu", dim) : FMB_OK;
}

static fmb_status skip_reference(fmb_cursor *c, fmb_mesh_draft *d)
{
    double ignored;
    return fmb_mesh_scan_real(c, d, &ignored);
}

static fmb_status read_medit_vertex(fmb_cursor *c, fmb_mesh_draft *d)
{
    double p[3];
    FMB_TRY(fmb_mesh_scan_point(c, d, p));
    return fmb_mesh_draft_point(c, d, p);
}

static fmb_status read_medit_face(fmb_cursor *c, fmb_mesh_draft *d, int corners)
{
    size_t v;
    fmb_mesh_draft_face(d);
    for (int k = 0; k < corners; k++) {
        FMB_TRY(fmb_mesh_scan_vertex(c, d, 1, d->points, &v));
        FMB_TRY(fmb_mesh_draft_corner(c, d, v));
    }
    return FMB_OK;
}

static fmb_status read_medit_triangle(fmb_cursor *c, fmb_mesh_draft *d)
{
    return read_medit_face(c, d, 3);
}

static fmb_status read_medit_quadrilateral(fmb_cursor *c, fmb_mesh_draft *d)
{
    return read_medit_face(c, d, 4);
}

static fmb_status read_medit_tetrahedron(fmb_cursor *c, fmb_mesh_draft *d)
{
    uint32_t corner[4];
    fmb_status st = FMB_OK;
    for (int k = 0; st == FMB_OK && k < 4; k++) {
        size_t v = 0;
        st = fmb_mesh_scan_vertex(c, d, 1, d->points, &v);
        corner[k] = (uint32_t)v;
    }
    return st == FMB_OK ? fmb_mesh_draft_tetrahedron(c, d, corner) : st;
}

typedef struct medit_section {
    const char *name;
    fmb_mesh_read_fn *line;
} medit_section;

static fmb_status read_medit_section(fmb_cursor *c, fmb_mesh_draft *d, const medit_section *s)
{
    size_t n = 0;
    FMB_TRY(fmb_mesh_scan_size(c, d, "the number of lines of a section", &n));
    for (size_t i = 0; i < n; i++) {
        FMB_TRY(s->line(c, d));
        FMB_TRY(skip_reference(c, d));
    }
    return FMB_OK;
}

static fmb_status read_medit_keyword(fmb_cursor *c, fmb_mesh_draft *d, fmb_span word)
{
    static const medit_section sections[] = {{"Vertices", read_medit_vertex},
                                             {"Triangles", read_medit_triangle},
                                             {"Quadrilaterals", read_medit_quadrilateral},
                                             {"Tetrahedra", read_medit_tetrahedron}};
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++)
        if (fmb_span_is_nocase(word, sections[i].name))
            return read_medit_section(c, d, &sections[i]);
    return fmb_span_is_nocase(word, "Dimension") ? check_dimension(c, d) : skip_numbers(c, d);
}

fmb_status fmb_mesh_read_medit(fmb_cursor *c, fmb_mesh_draft *d)
{
    d->skip = fmb_mesh_skip_comments;
    for (d->skip(c); c->at < c->end; d->skip(c)) {
        const char *p = c->at;
        fmb_span word = fmb_scan_word(c);
        if (fmb_span_is_nocase(word, "End"))
            return FMB_OK;
        int letter = *p | 32;
        FMB_TRY(letter >= 'a' && letter <= 'z' ? read_medit_keyword(c, d, word)
                                               : fmb_io_expected(c, p, "a keyword"));
    }
    return FMB_OK;
}
