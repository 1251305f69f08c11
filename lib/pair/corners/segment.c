/* segment.c: how a flat triangle, which is a segment S between two of its corners u and w, meets a
 * triangle T that is not flat, by signs of determinants alone.
 *
 * If S shares two corners with T, they lie on one edge of T, and the line of S meets T in that edge
 * alone: only the edge, the common face, can be common. If S is not in the plane of T, they have at
 * most one point in common: x, where S crosses the plane, in u, w or between them. It is in T iff
 * the volumes of u, w and the edges of T do not have both signs; none is 0 iff x is no point of an
 * edge. Else, see below.
 */
#include "pair/corners/cell.h"

/* The ends of S: along any axis on which the corners differ they are the least and the largest.
 * False: all corners are equal. */
static bool find_ends_of_segment(const fmb_cell *flat, int end[2])
{
    for (int j = 0; j < 3; j++) {
        end[0] = end[1] = 0;
        for (int k = 1; k < 3; k++) {
            end[0] = flat->point[k][j] < flat->point[end[0]][j] ? k : end[0];
            end[1] = flat->point[k][j] > flat->point[end[1]][j] ? k : end[1];
        }
        if (end[0] != end[1])
            return true;
    }
    return false;
}

/* ---- one plane ------------------------------------------------------------------------------- */

/* A segment and a triangle in one plane, seen along axis k; the triangle turns left if inner > 0.
 */
typedef struct flat_view {
    int k, inner;
    const double *end[2];
    const double *const *corner; /* [3] */
} flat_view;

/* T seen from its corner i, which is a point of S: there T is the cone of the two edges that begin
 * in the corner, and S goes on towards an end that is not the corner. */
static fmb_mesh_how decide_around_corner(const flat_view *v, int i)
{
    const double *p = v->corner[i], *q = v->corner[(i + 1) % 3], *r = v->corner[(i + 2) % 3];
    fmb_mesh_how how = FMB_MESH_SHARE;
    for (int e = 0; e < 2; e++) {
        int from_q = v->inner * fmb_sign_of_turn(v->k, p, q, v->end[e]);
        int to_r = v->inner * fmb_sign_of_turn(v->k, p, v->end[e], r);
        if (from_q > 0 && to_r > 0)
            return FMB_MESH_CROSS;
        if (from_q + to_r > 0 && from_q >= 0 && to_r >= 0)
            how = FMB_MESH_TOUCH;
    }
    return how;
}

/* 1: an edge of T has all of S strictly outside; 0: outside or on it; -1: no edge has. */
static int separate_by_edges_of_triangle(const flat_view *v)
{
    int best = -1;
    for (int i = 0; i < 3; i++) {
        int least = 1;
        for (int e = 0; e < 2; e++) {
            int out =
                -v->inner * fmb_sign_of_turn(v->k, v->corner[i], v->corner[(i + 1) % 3], v->end[e]);
            least = out < least ? out : least;
        }
        best = least > best ? least : best;
    }
    return best;
}

/* The same for the line of S and T. */
static int separate_by_segment(const flat_view *v)
{
    int seen = 0;
    for (int i = 0; i < 3; i++)
        seen |= 1 << (1 + fmb_sign_of_turn(v->k, v->end[0], v->end[1], v->corner[i]));
    enum { RIGHT = 1, ON = 2, LEFT = 4 };
    return (seen & RIGHT) && (seen & LEFT) ? -1 : (seen & ON) ? 0 : 1;
}

/* Convex polygons in the plane, here a triangle and a segment, are separated by the line of an edge
 * of one of them: strictly if they are apart, weakly if their relative interiors are. */
static fmb_mesh_how decide_apart_from_corners(const flat_view *v)
{
    int of_edges = separate_by_edges_of_triangle(v);
    int best = of_edges > 0 ? of_edges : separate_by_segment(v);
    best = best > of_edges ? best : of_edges;
    return best > 0 ? FMB_MESH_APART : best == 0 ? FMB_MESH_TOUCH : FMB_MESH_CROSS;
}

static fmb_mesh_how decide_within_plane(const fmb_cell *flat, const int end[2], const fmb_cell *c,
                                        unsigned common)
{
    flat_view v = {.end = {flat->point[end[0]], flat->point[end[1]]}, .corner = c->point};
    while ((v.inner = fmb_sign_of_turn(v.k, c->point[0], c->point[1], c->point[2])) == 0)
        v.k++;
    return common ? decide_around_corner(&v, (int)(common >> 1)) : decide_apart_from_corners(&v);
}

/* ---- both ------------------------------------------------------------------------------------ */

/* S is not in the plane and shares no corner; sides: those of its ends. */
static fmb_mesh_how decide_across_plane(const double *const end[2], const int side[2],
                                        const fmb_cell *c)
{
    int seen = 0;
    if (side[0] * side[1] > 0)
        return FMB_MESH_APART;
    for (int i = 0; i < 3; i++)
        seen |= 1 << (1 + fmb_sign_of_volume(end[0], end[1], c->point[i], c->point[(i + 1) % 3]));
    enum { LEFT = 1, ON = 2, RIGHT = 4 };
    if ((seen & LEFT) && (seen & RIGHT))
        return FMB_MESH_APART;
    return (seen & ON) || side[0] * side[1] == 0 ? FMB_MESH_TOUCH : FMB_MESH_CROSS;
}

bool fmb_decide_segment(const fmb_cell *flat, const fmb_cell *c, const fmb_triangle_plane *plane,
                        fmb_mesh_how *out)
{
    const unsigned common = fmb_cell_common(c, flat);
    const int shared = fmb_cell_count(common);
    int end[2], side[2];
    *out = FMB_MESH_SHARE;
    if (!find_ends_of_segment(flat, end))
        return false;
    if (shared == 2)
        return true;
    const double *const at[2] = {flat->point[end[0]], flat->point[end[1]]};
    for (int e = 0; e < 2; e++)
        side[e] = fmb_cell_has(c, flat->id[end[e]]) ? 0 : fmb_side_of_triangle_plane(plane, at[e]);
    if (side[0] == 0 && side[1] == 0)
        *out = decide_within_plane(flat, end, c, common);
    else if (shared == 0)
        *out = decide_across_plane(at, side, c);
    return true;
}
