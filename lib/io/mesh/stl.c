/* stl.c: STL, text or binary: three points per facet; facets are connected only by equal points.
 * Normals are skipped.
 *
 * Binary: 80 bytes of anything (even "solid"), the number of facets in 4 bytes, 50 bytes a facet:
 * 12 floats, then two bytes of anything; the least significant byte first.
 */
#include <math.h>

#include "io/mesh/mesh_draft.h"

enum { HEADER_BYTES = 80, FACET_BYTES = 50 };

static uint64_t count_binary_facets(const fmb_cursor *from)
{
    fmb_cursor c = *from;
    uint64_t facets = 0;
    c.at += HEADER_BYTES;
    for (int k = 0; k < 4; k++)
        facets |= (uint64_t)(unsigned char)c.at[k] << 8 * k;
    return facets;
}

bool fmb_mesh_is_binary_stl(const fmb_cursor *c)
{
    size_t size = (size_t)(c->end - c->begin);
    return size >= HEADER_BYTES + 4 &&
           count_binary_facets(c) * FACET_BYTES + HEADER_BYTES + 4 == size;
}

static fmb_status add_facet(fmb_cursor *c, fmb_mesh_draft *d, double corner[3][3])
{
    fmb_mesh_draft_face(d);
    for (int k = 0; k < 3; k++) {
        FMB_TRY(fmb_mesh_draft_corner(c, d, d->points));
        FMB_TRY(fmb_mesh_draft_point(c, d, corner[k]));
    }
    return FMB_OK;
}

static fmb_status read_binary_facet(fmb_cursor *c, fmb_mesh_draft *d)
{
    double corner[3][3];
    uint64_t bits;
    fmb_status st = FMB_OK;
    c->at += 12;
    for (int k = 0; st == FMB_OK && k < 9; k++) {
        st = fmb_mesh_take_bytes(c, 4, false, "a coordinate", &bits);
        if (st != FMB_OK)
            return st;
        corner[k / 3][k % 3] = fmb_mesh_real_of_bits(bits, 4);
        if (!isfinite(corner[k / 3][k % 3]))
            st = fmb_io_fail(c, NULL, "expected finite coordinates in facet %zu", d->faces);
    }
    c->at += 2;
    return st == FMB_OK ? add_facet(c, d, corner) : st;
}

static fmb_status expect_word(fmb_cursor *c, fmb_mesh_draft *d, const char *word)
{
    d->skip(c);
    const char *p = c->at;
    return fmb_span_is_nocase(fmb_scan_word(c), word) ? FMB_OK : fmb_io_expected(c, p, "%s", word);
}

/* Read a facet after "facet": the normal, which may be no number, ends at "outer". */
static fmb_status read_text_facet(fmb_cursor *c, fmb_mesh_draft *d)
{
    static const char *const end[] = {"endloop", "endfacet"};
    double corner[3][3];
    fmb_skip_line(c);
    FMB_TRY(expect_word(c, d, "outer"));
    FMB_TRY(expect_word(c, d, "loop"));
    for (int k = 0; k < 3; k++) {
        FMB_TRY(expect_word(c, d, "vertex"));
        FMB_TRY(fmb_mesh_scan_point(c, d, corner[k]));
    }
    for (int k = 0; k < 2; k++)
        FMB_TRY(expect_word(c, d, end[k]));
    return add_facet(c, d, corner);
}

/* One solid after another. */
static fmb_status read_text_stl(fmb_cursor *c, fmb_mesh_draft *d)
{
    bool inside = false;
    fmb_status st = fmb_io_check(c);
    for (d->skip(c); st == FMB_OK && (c->at < c->end || inside); d->skip(c)) {
        const char *p = c->at;
        fmb_span word = fmb_scan_word(c);
        bool solid = fmb_span_is_nocase(word, inside ? "endsolid" : "solid");
        if (inside && fmb_span_is_nocase(word, "facet"))
            st = read_text_facet(c, d);
        else if (!solid)
            st = fmb_io_expected(c, p, "%s", inside ? "facet or endsolid" : "solid");
        else
            fmb_skip_line(c);
        inside ^= solid;
    }
    return st;
}

fmb_status fmb_mesh_read_stl(fmb_cursor *c, fmb_mesh_draft *d)
{
    if (!fmb_mesh_is_binary_stl(c))
        return read_text_stl(c, d);
    c->at = c->begin + HEADER_BYTES + 4;
    while (c->at < c->end)
        FMB_TRY(read_binary_facet(c, d));
    return FMB_OK;
}
