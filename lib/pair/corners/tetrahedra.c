/* tetrahedra.c: how two tetrahedra that are not flat meet, by signs of determinants alone.
 *
 * Separating axes, exactly. A - B is a polytope whose facets are parallel to a face of A, to one of
 * B, or to an edge of A and one of B. A and B are apart iff the origin is strictly outside one of
 * them, and their interiors do not meet iff it is not strictly inside all. If a plane H has A on
 * one side and B on the other, all common points lie in H; so if the corners of A in H, or those of
 * B, are shared, there are no others than what these span. Nor are there if those of A and those of
 * B are edges with a common corner and different directions.
 */
#include "pair/corners/cell.h"
#include "pair/corners/volume.h"

/* The results of the planes tested so far. */
typedef struct separation {
    const fmb_cell *a, *b;
    int shared;
    bool apart, weakly, only_shared;
} separation;

/* Are all corners of c in this set of bits also corners of the other cell? */
static bool are_shared_corners(const fmb_cell *c, const fmb_cell *other, unsigned bits)
{
    bool shared = true;
    for (int k = 0; k < 4; k++)
        shared &= !(bits >> k & 1) || fmb_cell_has(other, c->id[k]);
    return shared;
}

/* Note the side of corner k of a plane; on: bits of corners on it. False: it is the wrong side. */
static bool add_corner(int sign, int k, unsigned *on)
{
    *on |= sign == 0 ? 1U << k : 0;
    return sign >= 0;
}

static void note_plane(separation *s, bool strictly, unsigned on_a, unsigned on_b)
{
    s->weakly = true;
    s->apart |= strictly;
    s->only_shared |= s->shared > 0 && (are_shared_corners(s->a, s->b, on_a) ||
                                        are_shared_corners(s->b, s->a, on_b));
}

static bool is_decided(const separation *s)
{
    return s->apart || s->only_shared;
}

/* Test the plane of the face of c opposite corner k. It cannot separate if k is also a corner of
 * the other cell. */
static void look_at_face(separation *s, const fmb_cell *c, const fmb_cell *other, int k)
{
    const double *p = c->point[(k + 1) % 4], *q = c->point[(k + 2) % 4], *r = c->point[(k + 3) % 4];
    unsigned on = 0, face = 15U & ~(1U << k);
    bool outside = !fmb_cell_has(other, c->id[k]);
    int inner = outside ? fmb_sign_of_volume(p, q, r, c->point[k]) : 0;
    for (int j = 0; outside && j < 4; j++) {
        bool shared = fmb_cell_has(c, other->id[j]);
        int sign = shared ? 0 : -inner * fmb_sign_of_volume(p, q, r, other->point[j]);
        outside = add_corner(sign, j, &on);
    }
    if (outside)
        note_plane(s, on == 0, c == s->a ? face : on, c == s->a ? on : face);
}

/* For each edge of a tetrahedron: its two corners, then the two others. */
static const int edge_corner[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2},
                                      {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};

/* The two corners off an edge of c lie beyond no plane through it and along f: the common sign of
 * theirs, 0 if there are two, or none. */
static int find_side_of_others(const fmb_cell *c, const int *edge, fmb_difference e,
                               fmb_difference f, unsigned *on)
{
    int sign[2];
    *on = 1U << edge[0] | 1U << edge[1];
    for (int i = 0; i < 2; i++) {
        sign[i] = fmb_sign_of_determinant(
            e, f, (fmb_difference){c->point[edge[2 + i]], c->point[edge[0]]});
        *on |= sign[i] == 0 ? 1U << edge[2 + i] : 0;
    }
    return sign[0] * sign[1] < 0 ? 0 : sign[0] + sign[1] > 0 ? 1 : sign[0] + sign[1] < 0 ? -1 : 0;
}

/* Have the edges a common corner? */
static bool do_edges_share(const separation *s, const int *of_a, const int *of_b)
{
    const uint32_t *p = s->a->id, *q = s->b->id;
    return p[of_a[0]] == q[of_b[0]] || p[of_a[0]] == q[of_b[1]] || p[of_a[1]] == q[of_b[0]] ||
           p[of_a[1]] == q[of_b[1]];
}

/* Test the planes parallel to an edge of A and one of B. If these are parallel, all signs are 0. */
static void look_at_edges(separation *s, const int *of_a, const int *of_b, bool share)
{
    const fmb_cell *a = s->a, *b = s->b;
    fmb_difference e = {a->point[of_a[1]], a->point[of_a[0]]};
    fmb_difference f = {b->point[of_b[1]], b->point[of_b[0]]};
    unsigned on_a, on_b;
    int side_a = find_side_of_others(a, of_a, e, f, &on_a);
    if (side_a == 0)
        return;
    int side_b = find_side_of_others(b, of_b, e, f, &on_b);
    if (side_b != -side_a)
        return;
    int gap =
        share
            ? 0
            : fmb_sign_of_determinant(e, f, (fmb_difference){b->point[of_b[0]], a->point[of_a[0]]});
    if (gap * side_b < 0)
        return;
    note_plane(s, gap != 0, on_a, on_b);
    s->only_shared |= share && __builtin_popcount(on_a) == 2 && __builtin_popcount(on_b) == 2;
}

/* Test pairs of edges, those with a common corner first: most cells with one are separated so. */
static void look_at_all_edges(separation *s)
{
    for (int share = s->shared > 0; share >= 0; share--)
        for (int k = 0; !is_decided(s) && k < 36; k++) {
            const int *of_a = edge_corner[k / 6], *of_b = edge_corner[k % 6];
            if (do_edges_share(s, of_a, of_b) == share)
                look_at_edges(s, of_a, of_b, share);
        }
}

fmb_mesh_how fmb_decide_tetrahedra(const fmb_cell *a, const fmb_cell *b, int shared)
{
    separation s = {.a = a, .b = b, .shared = shared};
    for (int k = 0; !is_decided(&s) && k < 4; k++)
        look_at_face(&s, a, b, k);
    for (int k = 0; !is_decided(&s) && k < 4; k++)
        look_at_face(&s, b, a, k);
    look_at_all_edges(&s);
    return s.apart         ? FMB_MESH_APART
           : s.only_shared ? FMB_MESH_SHARE
           : s.weakly      ? FMB_MESH_TOUCH
                           : FMB_MESH_CROSS;
}
