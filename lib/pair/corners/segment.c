/* segment.c: how a flat triangle, which is a segment S between two of its corners u and w, meets a
 * triangle T that is not flat, by signs of determinants alone.
 *
 * If S shares two corners with T, they lie on one edge of T, and the line of S meets T in that edge
 * alone: only the edge, the common face, can be common. If S is not in the plane of T, they have at
 * most one point in common: x, where S crosses the plane, in u, w or between them. It is in T iff
 * the volumes of u, w and the edges of T do not have both signs; none is 0 iff x is no point of an
 * edge.
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

/* 1: T is strictly on one side of the line of S, seen along axis k; 0: on one side or on it; -1: on
 * both sides. */
static int separate_by_line(int k, const double *const end[2], const fmb_cell *c)
{
    enum { RIGHT = 1, ON = 2, LEFT = 4 };
    int seen = 0;
    for (int i = 0; i < 3; i++)
        seen |= 1 << (1 + fmb_sign_of_turn(k, end[0], end[1], c->point[i]));
    return (seen & RIGHT) && (seen & LEFT) ? -1 : (seen & ON) ? 0 : 1;
}

/* As two triangles (triangles.c), of which one has a single line. */
static fmb_mesh_how decide_within_plane(const fmb_cell *flat, const double *const end[2],
                                        const fmb_cell *c, int shared)
{
    const int k = fmb_triangle_axis(c), of_edges = fmb_separate_by_edges(k, c, flat);
    const int of_line = of_edges > 0 ? of_edges : separate_by_line(k, end, c);
    if (of_line > 0)
        return FMB_MESH_APART;
    if (of_edges < 0 && of_line < 0)
        return FMB_MESH_CROSS;
    return shared == 1 && !fmb_have_edges_on_one_ray(k, c, flat) ? FMB_MESH_SHARE : FMB_MESH_TOUCH;
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
    const int shared = fmb_cell_count(fmb_cell_common(c, flat));
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
        *out = decide_within_plane(flat, at, c, shared);
    else if (shared == 0)
        *out = decide_across_plane(at, side, c);
    return true;
}
