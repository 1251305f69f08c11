/* ply.c: PLY, as text or binary of either byte order. A header names the kinds of elements and the
 * properties of each, in order; of vertices x, y and z are read, of faces and of triangle strips
 * the list vertex_indices (or vertex_index), and all others are skipped.
 */
#include <math.h>

#include "io/core/number.h"
#include "io/mesh/mesh_draft.h"

typedef struct ply_type {
    const char *name, *other_name;
    int bytes;
    bool is_real, is_signed;
} ply_type;

static const ply_type types[] = {
    {"char", "int8", 1, false, true},    {"uchar", "uint8", 1, false, false},
    {"short", "int16", 2, false, true},  {"ushort", "uint16", 2, false, false},
    {"int", "int32", 4, false, true},    {"uint", "uint32", 4, false, false},
    {"float", "float32", 4, true, true}, {"double", "float64", 8, true, true},
};

/* The meaning of a property for the mesh. */
enum { ROLE_X, ROLE_Y, ROLE_Z, ROLE_CORNERS, ROLE_STRIPS, ROLE_NONE };

typedef struct ply_property {
    const ply_type *type, *count; /* count: of a list, or NULL */
    int role;
} ply_property;

typedef enum ply_kind { PLY_OTHER, PLY_VERTEX, PLY_FACE, PLY_STRIPS } ply_kind;

typedef struct ply_element {
    ply_kind kind;
    size_t number, from, to; /* of the properties */
    unsigned roles;          /* bits */
} ply_element;

typedef struct ply_header {
    bool binary, big_endian;
    ply_element *element;
    size_t elements, element_capacity;
    ply_property *property;
    size_t properties, property_capacity;
} ply_header;

/* ---- the header ------------------------------------------------------------------------------ */

/* The header is text, and its lines end in LF, perhaps with CR in front of it. */
static fmb_span scan_header_word(fmb_cursor *c)
{
    fmb_skip_blanks(c);
    return fmb_scan_word(c);
}

static fmb_status fail_at_word(fmb_cursor *c, fmb_span word, const char *what)
{
    return fmb_io_expected(c, word.p, "%s", what);
}

static fmb_status read_ply_format(fmb_cursor *c, ply_header *h)
{
    fmb_span word = scan_header_word(c);
    h->big_endian = fmb_span_is(word, "binary_big_endian");
    h->binary = h->big_endian || fmb_span_is(word, "binary_little_endian");
    if (!h->binary && !fmb_span_is(word, "ascii"))
        return fail_at_word(c, word, "ascii, binary_little_endian or binary_big_endian");
    word = scan_header_word(c);
    return fmb_span_is(word, "1.0") ? FMB_OK : fail_at_word(c, word, "version 1.0");
}

static fmb_status read_ply_element(fmb_cursor *c, ply_header *h)
{
    fmb_span word = scan_header_word(c);
    ply_element e = {.kind = fmb_span_is(word, "vertex")      ? PLY_VERTEX
                             : fmb_span_is(word, "face")      ? PLY_FACE
                             : fmb_span_is(word, "tristrips") ? PLY_STRIPS
                                                              : PLY_OTHER,
                     .from = h->properties,
                     .to = h->properties};
    fmb_skip_blanks(c);
    FMB_TRY(fmb_scan_count(c, FMB_MESH_MOST, "the number of elements", &e.number));
    FMB_TRY(FMB_RESERVE(c->mem, &h->element, &h->element_capacity, h->elements + 1));
    h->element[h->elements++] = e;
    return FMB_OK;
}

static fmb_status read_ply_type(fmb_cursor *c, fmb_span word, bool whole, const ply_type **out)
{
    *out = NULL;
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (fmb_span_is(word, types[i].name) || fmb_span_is(word, types[i].other_name))
            *out = &types[i];
    return *out && !(whole && (*out)->is_real)
               ? FMB_OK
               : fail_at_word(c, word, whole ? "a type of whole numbers" : "a type");
}

static int find_role(const ply_element *e, const ply_property *p, fmb_span name)
{
    static const char *const axis[] = {"x", "y", "z"};
    for (int j = 0; e->kind == PLY_VERTEX && !p->count && j < 3; j++)
        if (fmb_span_is(name, axis[j]))
            return ROLE_X + j;
    bool corners = fmb_span_is(name, "vertex_indices") || fmb_span_is(name, "vertex_index");
    if (!corners || !p->count || p->type->is_real)
        return ROLE_NONE;
    return e->kind == PLY_FACE ? ROLE_CORNERS : e->kind == PLY_STRIPS ? ROLE_STRIPS : ROLE_NONE;
}

static fmb_status read_ply_property(fmb_cursor *c, ply_header *h, const char *line)
{
    ply_property p = {.count = NULL};
    if (h->elements == 0)
        return fmb_io_fail(c, line, "expected an element before its properties");
    ply_element *e = &h->element[h->elements - 1];
    fmb_span word = scan_header_word(c);
    bool list = fmb_span_is(word, "list");
    FMB_TRY(list ? read_ply_type(c, scan_header_word(c), true, &p.count) : FMB_OK);
    FMB_TRY(read_ply_type(c, list ? scan_header_word(c) : word, false, &p.type));
    p.role = find_role(e, &p, scan_header_word(c));
    if (p.role != ROLE_NONE && (e->roles >> p.role & 1))
        return fmb_io_fail(c, line, "expected a property of another name: it came before");
    e->roles |= p.role != ROLE_NONE ? 1U << p.role : 0;
    fmb_status st = FMB_RESERVE(c->mem, &h->property, &h->property_capacity, h->properties + 1);
    if (st == FMB_OK)
        h->property[h->properties++] = p;
    e->to = h->properties;
    return st;
}

static fmb_status check_ply_element(fmb_cursor *c, const ply_element *e)
{
    unsigned point = 1U << ROLE_X | 1U << ROLE_Y | 1U << ROLE_Z;
    if (e->kind == PLY_VERTEX && e->roles != point)
        return fmb_io_fail(c, NULL, "expected properties x, y and z of a vertex");
    if (e->kind == PLY_FACE && e->roles != 1U << ROLE_CORNERS)
        return fmb_io_fail(c, NULL, "expected a list vertex_indices of a face");
    if (e->kind == PLY_STRIPS && e->roles != 1U << ROLE_STRIPS)
        return fmb_io_fail(c, NULL, "expected a list vertex_indices of tristrips");
    return FMB_OK;
}

static fmb_status read_ply_line(fmb_cursor *c, ply_header *h, bool *end)
{
    fmb_skip_blanks(c);
    const char *line = c->at;
    fmb_span word = fmb_scan_word(c);
    *end = fmb_span_is(word, "end_header");
    if (fmb_span_is(word, "format"))
        return read_ply_format(c, h);
    if (fmb_span_is(word, "element"))
        return read_ply_element(c, h);
    if (fmb_span_is(word, "property"))
        return read_ply_property(c, h, line);
    bool free = *end || fmb_span_is(word, "comment") || fmb_span_is(word, "obj_info");
    return free ? FMB_OK
                : fail_at_word(c, word, "format, comment, element, property or end_header");
}

static fmb_status read_ply_header(fmb_cursor *c, ply_header *h)
{
    bool end = false;
    fmb_span word = scan_header_word(c);
    FMB_TRY(fmb_span_is(word, "ply") ? FMB_OK : fail_at_word(c, word, "ply"));
    while (!end) {
        fmb_next_line(c);
        FMB_TRY(read_ply_line(c, h, &end));
    }
    for (size_t i = 0; i < h->elements; i++)
        FMB_TRY(check_ply_element(c, &h->element[i]));
    fmb_next_line(c);
    return FMB_OK;
}

/* ---- numbers --------------------------------------------------------------------------------- */

typedef struct ply_reader {
    fmb_cursor *c;
    fmb_mesh_draft *d;
    const ply_header *h;
    double point[3];
    size_t most_of_strips; /* the largest number of a vertex in them */
} ply_reader;

static fmb_status take_binary_bits(const ply_reader *r, const ply_type *t, uint64_t *out)
{
    return fmb_mesh_take_bytes(r->c, t->bytes, r->h->big_endian, "a number", out);
}

static fmb_status read_ply_real(const ply_reader *r, const ply_type *t, double *out)
{
    uint64_t bits = 0;
    if (!r->h->binary)
        return fmb_mesh_scan_real(r->c, r->d, out);
    fmb_status st = take_binary_bits(r, t, &bits);
    int unused = 64 - 8 * t->bytes;
    *out = t->is_real     ? fmb_mesh_real_of_bits(bits, t->bytes)
           : t->is_signed ? (double)((int64_t)(bits << unused) >> unused)
                          : (double)bits;
    if (st == FMB_OK && !isfinite(*out))
        st = fmb_io_fail(r->c, NULL, "expected finite coordinates of vertex %zu", r->d->points);
    return st;
}

/* A number that must not be negative. */
static fmb_status read_ply_whole(const ply_reader *r, const ply_type *t, const char *what,
                                 size_t *out)
{
    uint64_t bits = 0;
    if (!r->h->binary)
        return fmb_mesh_scan_size(r->c, r->d, what, out);
    fmb_status st = take_binary_bits(r, t, &bits);
    if (st == FMB_OK && t->is_signed && bits >> (8 * t->bytes - 1))
        st = fmb_io_fail(r->c, NULL, "expected %s, found a negative number", what);
    *out = (size_t)bits;
    return st;
}

static fmb_status skip_ply_number(const ply_reader *r, const ply_type *t)
{
    uint64_t ignored;
    if (r->h->binary)
        return take_binary_bits(r, t, &ignored);
    r->d->skip(r->c);
    return fmb_scan_word(r->c).n > 0
               ? FMB_OK
               : fmb_io_fail(r->c, r->c->at, "expected a number, found end of file");
}

/* ---- elements -------------------------------------------------------------------------------- */

/* Vertices may come behind the faces. */
static fmb_status read_ply_corners(const ply_reader *r, const ply_property *p, size_t n)
{
    if (n < 3)
        return fmb_io_fail(r->c, NULL, "expected at least 3 corners of face %zu, found %zu",
                           r->d->faces, n);
    fmb_mesh_draft_face(r->d);
    for (size_t k = 0; k < n; k++) {
        size_t v = 0;
        FMB_TRY(read_ply_whole(r, p->type, "the number of a vertex", &v));
        FMB_TRY(fmb_mesh_draft_corner(r->c, r->d, v));
    }
    return FMB_OK;
}

/* -1 ends a strip, if the type has it. */
static bool scan_end_of_strip(const ply_reader *r, const ply_type *t)
{
    fmb_cursor *c = r->c;
    const char *start = c->at;
    uint64_t bits = 0;
    bool ends;
    if (r->h->binary) {
        ends = c->end - start >= t->bytes && take_binary_bits(r, t, &bits) == FMB_OK &&
               bits == UINT64_MAX >> (64 - 8 * t->bytes);
    } else {
        r->d->skip(c);
        ends = fmb_span_is(fmb_scan_word(c), "-1");
    }
    ends = ends && t->is_signed;
    if (!ends)
        c->at = start;
    return ends;
}

static fmb_status append_triangle_of_strip(const ply_reader *r, const size_t v[3], bool turned)
{
    const size_t corner[3] = {v[turned], v[!turned], v[2]};
    if (v[0] == v[1] || v[1] == v[2] || v[0] == v[2])
        return FMB_OK;
    fmb_mesh_draft_face(r->d);
    for (int k = 0; k < 3; k++)
        FMB_TRY(fmb_mesh_draft_corner(r->c, r->d, corner[k]));
    return FMB_OK;
}

/* Three consecutive vertices form a triangle; every second one of a strip is reversed, so that all
 * have the same orientation. A degenerate one, with a vertex twice, only moves the strip: it is
 * dropped, but counts for the reversal. */
static fmb_status read_ply_strips(ply_reader *r, const ply_property *p, size_t n)
{
    size_t v[3] = {0}, length = 0;
    fmb_status st = FMB_OK;
    for (size_t k = 0; st == FMB_OK && k < n; k++) {
        bool ends = scan_end_of_strip(r, p->type);
        length = ends ? 0 : length + 1;
        if (ends)
            continue;
        v[0] = v[1];
        v[1] = v[2];
        st = read_ply_whole(r, p->type, "the number of a vertex or -1", &v[2]);
        if (st == FMB_OK && length >= 3)
            st = append_triangle_of_strip(r, v, length % 2 == 0);
        if (v[2] > r->most_of_strips)
            r->most_of_strips = v[2];
    }
    return st;
}

static fmb_status read_ply_value(ply_reader *r, const ply_property *p)
{
    size_t n = 1;
    FMB_TRY(p->count ? read_ply_whole(r, p->count, "the length of a list", &n) : FMB_OK);
    if (p->role == ROLE_CORNERS)
        return read_ply_corners(r, p, n);
    if (p->role == ROLE_STRIPS)
        return read_ply_strips(r, p, n);
    if (p->role != ROLE_NONE)
        return read_ply_real(r, p->type, &r->point[p->role]);
    for (size_t k = 0; k < n; k++)
        FMB_TRY(skip_ply_number(r, p->type));
    return FMB_OK;
}

static fmb_status read_ply_elements(ply_reader *r, const ply_element *e)
{
    for (size_t i = 0; i < e->number && e->from < e->to; i++) {
        for (size_t k = e->from; k < e->to; k++)
            FMB_TRY(read_ply_value(r, &r->h->property[k]));
        if (e->kind == PLY_VERTEX)
            FMB_TRY(fmb_mesh_draft_point(r->c, r->d, r->point));
    }
    return FMB_OK;
}

/* Check the numbers of corners; strips may have corners that are in no triangle. */
static fmb_status check_ply_corners(const ply_reader *r)
{
    fmb_cursor *c = r->c;
    const fmb_mesh_draft *d = r->d;
    for (size_t i = 0; i < 3 * d->triangles; i++)
        if (d->triangle[i] >= d->points)
            return fmb_io_fail(
                c, NULL, "expected one of %zu vertices, numbered from 0, in face %zu, found %zu",
                d->points, (size_t)d->face[i / 3], (size_t)d->triangle[i]);
    if (r->most_of_strips > 0 && r->most_of_strips >= d->points)
        return fmb_io_fail(c, NULL,
                           "expected one of %zu vertices, numbered from 0, in tristrips, found %zu",
                           d->points, r->most_of_strips);
    return FMB_OK;
}

fmb_status fmb_mesh_read_ply(fmb_cursor *c, fmb_mesh_draft *d)
{
    ply_header h = {.binary = false};
    ply_reader r = {.c = c, .d = d, .h = &h};
    fmb_status st = read_ply_header(c, &h);
    if (st == FMB_OK && !h.binary)
        st = fmb_io_check(c);
    for (size_t i = 0; st == FMB_OK && i < h.elements; i++)
        st = read_ply_elements(&r, &h.element[i]);
    fmb_mem_put(c->mem, h.element, h.element_capacity, sizeof *h.element);
    fmb_mem_put(c->mem, h.property, h.property_capacity, sizeof *h.property);
    return st == FMB_OK ? check_ply_corners(&r) : st;
}
