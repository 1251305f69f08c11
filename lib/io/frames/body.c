/* body.c: a frame or a polytope in JSON; docs/formats.md, "frames". */
#include "io/frames/frame_reader.h"

/* ---- rows of a polytope ---------------------------------------------------------------------- */

static fmb_status read_coefficients(void *reader, fmb_cursor *c)
{
    fmb_frame_reader *r = reader;
    fmb_numbers *a = &r->now->coefficients;
    a->n = 0;
    FMB_TRY(fmb_frame_reader_point(r, c, a));
    return r->how.nearest ? fmb_numbers_rationals(a, &r->mem) : FMB_OK;
}

static fmb_status read_relation_word(void *reader, fmb_cursor *c)
{
    static const char what[] = "\"<=\", \"<\" or \"=\"";
    fmb_frame_reader *r = reader;
    const char *p = c->at;
    fmb_span word;
    FMB_TRY(fmb_json_string(c, what, &word));
    bool le = fmb_json_spells(word, "<="), eq = fmb_json_spells(word, "=");
    r->rel = le ? FMB_LE : eq ? FMB_EQ : FMB_LT;
    return le || eq || fmb_json_spells(word, "<") ? FMB_OK : fmb_io_fail(c, p, "expected %s", what);
}

static fmb_status read_right_side(void *reader, fmb_cursor *c)
{
    fmb_frame_reader *r = reader;
    return fmb_frame_reader_value(r, c, r->row.rhs);
}

static fmb_status append_polytope_row(fmb_frame_reader *r, fmb_cursor *c, const char *p)
{
    fmb_body_draft *b = r->now;
    fmb_status st = FMB_OK;
    if (!b->rows)
        st = fmb_system_new(r->dim, r->how.mem, &b->rows);
    r->row.n = 0;
    for (int j = 0; st == FMB_OK && j < r->dim; j++)
        st = fmb_draft_add(&r->row, j, b->coefficients.q[j]);
    return st == FMB_OK ? fmb_draft_append(c, p, &r->row, r->rel, b->rows) : st;
}

static fmb_status read_polytope_row(void *reader, fmb_cursor *c)
{
    static const fmb_json_key keys[] = {{"coefficients", read_coefficients},
                                        {"relation", read_relation_word},
                                        {"rhs", read_right_side}};
    fmb_frame_reader *r = reader;
    unsigned seen;
    fmb_json_blanks(c);
    const char *p = c->at;
    FMB_TRY(fmb_json_object(c, "a row", keys, 3, r, &seen));
    if (seen != 7)
        return fmb_io_fail(c, p, "expected \"coefficients\", \"relation\" and \"rhs\" in a row");
    return append_polytope_row(r, c, p);
}

static fmb_status read_polytope_rows(void *reader, fmb_cursor *c)
{
    return fmb_json_array(c, "an array of rows", read_polytope_row, reader);
}

/* ---- frames ---------------------------------------------------------------------------------- */

static fmb_status read_body_type(void *reader, fmb_cursor *c)
{
    static const char what[] = "\"cuboid\", \"simplex\", \"tetrahedron\", \"hull\" or \"polytope\"";
    fmb_body_draft *b = ((fmb_frame_reader *)reader)->now;
    const char *p = c->at;
    fmb_span word;
    FMB_TRY(fmb_json_string(c, what, &word));
    b->is_polytope = fmb_json_spells(word, "polytope");
    b->shape = fmb_json_spells(word, "cuboid") ? FMB_CUBOID : FMB_SIMPLEX;
    b->is_hull = fmb_json_spells(word, "hull");
    return b->is_polytope || b->is_hull || b->shape == FMB_CUBOID ||
                   fmb_json_spells(word, "simplex") || fmb_json_spells(word, "tetrahedron")
               ? FMB_OK
               : fmb_io_fail(c, p, "expected %s", what);
}

static fmb_status read_frame_origin(void *reader, fmb_cursor *c)
{
    fmb_frame_reader *r = reader;
    return fmb_frame_reader_point(r, c, &r->now->origin);
}

static fmb_status read_frame_axis(void *reader, fmb_cursor *c)
{
    fmb_frame_reader *r = reader;
    fmb_json_blanks(c);
    const char *p = c->at;
    FMB_TRY(fmb_frame_reader_point(r, c, &r->now->axes));
    if (++r->now->naxes > r->dim)
        return fmb_io_fail(c, p, "expected at most %d edges in %d dimensions", r->dim, r->dim);
    return FMB_OK;
}

/* The first one is the origin. */
static fmb_status read_frame_corner(void *reader, fmb_cursor *c)
{
    fmb_frame_reader *r = reader;
    if (r->now->origin.n == 0)
        return read_frame_origin(r, c);
    r->now->naxes++;
    return fmb_frame_reader_point(r, c, &r->now->axes);
}

/* Only a hull may have any number of corners; the member "type" may follow later. */
static fmb_status read_frame_corners(void *reader, fmb_cursor *c)
{
    return fmb_json_array(c, "an array of points", read_frame_corner, reader);
}

static fmb_status read_frame_axes(void *reader, fmb_cursor *c)
{
    return fmb_json_array(c, "an array of edges", read_frame_axis, reader);
}

/* A speed of zeros is the same as no speed. */
static fmb_status read_frame_speed(void *reader, fmb_cursor *c)
{
    fmb_frame_reader *r = reader;
    fmb_numbers *a = &r->now->speed;
    if (fmb_json_null(c))
        return FMB_OK;
    fmb_status st = fmb_frame_reader_point(r, c, a);
    bool moves = false;
    for (size_t j = 0; j < a->n; j++)
        moves |= r->how.nearest ? a->d[j] != 0 : mpq_sgn(a->q[j]) != 0;
    a->n = moves ? a->n : 0;
    return st;
}

/* ---- bodies ---------------------------------------------------------------------------------- */

static void reset_body_draft(fmb_body_draft *b)
{
    b->origin.n = b->axes.n = b->speed.n = 0;
    b->naxes = 0;
    b->is_polytope = b->is_hull = false;
    fmb_system_free(b->rows);
    b->rows = NULL;
}

fmb_status fmb_frame_reader_body(fmb_frame_reader *r, fmb_cursor *c)
{
    enum { TYPE = 1, ORIG = 2, COMP = 4, VEL = 8, ROWS = 16, POINTS = 32 };
    static const fmb_json_key keys[] = {
        {"type", read_body_type},  {"orig", read_frame_origin},  {"comp", read_frame_axes},
        {"vel", read_frame_speed}, {"rows", read_polytope_rows}, {"points", read_frame_corners}};
    const char *p = c->at;
    unsigned seen;
    reset_body_draft(r->now);
    FMB_TRY(fmb_json_object(c, "a frame", keys, 6, r, &seen));
    if (!(seen & TYPE))
        return fmb_io_fail(c, p, "expected a \"type\"");
    if (r->now->is_polytope && (seen != (TYPE | ROWS) || !r->now->rows))
        return fmb_io_fail(c, p, "expected \"rows\" in a polytope, and no \"orig\" or \"comp\"");
    bool by_corners = !r->now->is_polytope && (seen & ~(unsigned)VEL) == (TYPE | POINTS);
    if (by_corners && r->now->origin.n == 0)
        return fmb_io_fail(c, p, "expected \"points\" that are not empty");
    if (by_corners && !r->now->is_hull && r->now->naxes > r->dim)
        return fmb_io_fail(c, p, "expected at most %d points in %d dimensions, or a \"hull\"",
                           r->dim + 1, r->dim);
    if (r->now->is_hull && !by_corners)
        return fmb_io_fail(c, p, "expected \"points\" in a hull");
    if (by_corners)
        r->now->shape =
            r->now->shape == FMB_CUBOID ? FMB_CUBOID_BY_CORNERS : FMB_SIMPLEX_BY_CORNERS;
    else if (!r->now->is_polytope && (seen & ~(unsigned)VEL) != (TYPE | ORIG | COMP))
        return fmb_io_fail(c, p, "expected \"orig\" and \"comp\" in a frame, and no \"rows\"");
    return FMB_OK;
}
