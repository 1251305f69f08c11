/* triangles.c: how two triangles that are not flat meet, by signs of volumes alone.
 *
 * Let A lie in the plane H, B in K. If all of B is strictly on one side of H, or all of A of K,
 * they are apart. If H = K, see below. Else H and K meet in a line L, A meets K in an interval P of
 * L, B meets H in an interval Q, and the common points are P and Q's. An end of P is where an edge
 * uw of A meets K: w strictly on one side, u in K or on the other side. For an end x of P on uw and
 * an end y of Q on kl, with directions e of uw and f of kl,
 *
 *     vol(u, w, k, l) = det(w - u, k - u, l - u) ~ det(e, y - x, f)
 *
 * up to positive factors, as k - u is y - x plus multiples of e and f. The part of e across L has
 * the sign of w's side of K, that of f the sign of l's side of H. So vol times both sides has the
 * sign of x - y along L, up to one factor that is common to all ends. No order along L is needed:
 * P and Q are apart iff all x - y have one strict sign; they have at most one point in common iff
 * none is positive or none is negative.
 *
 * Source: Devillers and Guigue, INRIA RR-4488, 2002.
 */
#include "pair/corners/cell.h"
#include "pair/corners/volume.h"

/* On which side of h are the corners of c, where bits of `common` are of corners that it has, too:
 * -1, 0, 1; 0 also if doubles are not certain. Below: side[] then becomes exact. */
static void find_certain_sides(const fmb_triangle_plane *h, const fmb_cell *c, unsigned common,
                               int side[3])
{
    for (int i = 0; i < 3; i++)
        side[i] = common >> i & 1 ? 0 : fmb_certain_side_of_plane(h, c->point[i]);
}

static void find_other_sides(const fmb_triangle_plane *h, const fmb_cell *c, unsigned common,
                             int side[3])
{
    for (int i = 0; i < 3; i++)
        if (side[i] == 0 && !(common >> i & 1))
            side[i] = fmb_side_of_triangle_plane(h, c->point[i]);
}

static bool are_on_both_sides(const int side[3])
{
    int seen = 0;
    for (int i = 0; i < 3; i++)
        seen |= side[i] > 0 ? 2 : side[i] < 0 ? 1 : 0;
    return seen == 3;
}

/* ---- two planes ------------------------------------------------------------------------------ */

/* An edge by its ends u, w. */
typedef struct crossing_edge {
    int u, w;
} crossing_edge;

/* The one or two ends of the interval that a triangle with these sides cuts from the other plane.
 */
static int find_ends_of_interval(const int side[3], crossing_edge out[2])
{
    int n = 0;
    for (int i = 0; i < 3; i++) {
        int next = (i + 1) % 3, last = (i + 2) % 3;
        if (side[i] == 0)
            out[n++] = (crossing_edge){i, side[next] != 0 ? next : last};
        if (side[i] * side[next] < 0)
            out[n++] = (crossing_edge){i, next};
    }
    return n;
}

/* The sign of x - y along the common line, x on edge e of a and y on edge f of b. */
static int compare_ends(const fmb_cell *a, crossing_edge e, const fmb_cell *b, crossing_edge f)
{
    bool same = a->id[e.u] == b->id[f.u] || a->id[e.u] == b->id[f.w] || a->id[e.w] == b->id[f.u] ||
                a->id[e.w] == b->id[f.w];
    return same ? 0
                : fmb_sign_of_volume(a->point[e.u], a->point[e.w], b->point[f.u], b->point[f.w]);
}

static fmb_mesh_how decide_across_planes(const fmb_cell *a, const int *side_a, const fmb_cell *b,
                                         const int *side_b, int shared)
{
    crossing_edge e[2], f[2];
    int n = find_ends_of_interval(side_a, e), m = find_ends_of_interval(side_b, f), seen = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++) {
            int sign = compare_ends(a, e[i], b, f[j]) * side_a[e[i].w] * side_b[f[j].w];
            seen |= 1 << (sign + 1);
        }
    enum { BELOW = 1, EQUAL = 2, ABOVE = 4 };
    if (seen == BELOW || seen == ABOVE)
        return FMB_MESH_APART;
    bool overlap = (seen & BELOW) && (seen & ABOVE);
    if (overlap && are_on_both_sides(side_a) && are_on_both_sides(side_b))
        return FMB_MESH_CROSS;
    bool is_point = n == 1 || m == 1 || !overlap;
    return shared == 1 && is_point ? FMB_MESH_SHARE : FMB_MESH_TOUCH;
}

/* ---- one plane ------------------------------------------------------------------------------- */

/* Not inlined, to keep the loops below short. */
__attribute__((noinline)) static int turn_in_plane(int k, const double *p, const double *q,
                                                   const double *r)
{
    return fmb_sign_of_turn(k, p, q, r);
}

/* On which side of edge i of a is corner j of b: -1, 0, 1? Corners that both have need no turn. */
static int side_of_edge(int k, const fmb_cell *a, int i, const fmb_cell *b, int j)
{
    int next = (i + 1) % 3;
    if (b->id[j] == a->id[i] || b->id[j] == a->id[next])
        return 0;
    return turn_in_plane(k, a->point[i], a->point[next], b->point[j]);
}

int fmb_separate_by_edges(int k, const fmb_cell *a, const fmb_cell *b)
{
    int best = -1, inner = turn_in_plane(k, a->point[0], a->point[1], a->point[2]);
    for (int i = 0; i < 3; i++) {
        int least = 1;
        for (int j = 0; j < 3 && least > best; j++) {
            int out = -inner * side_of_edge(k, a, i, b, j);
            least = out < least ? out : least;
        }
        best = least > best ? least : best;
    }
    return best;
}

/* Have p - v and q - v, which are parallel and not 0, the same direction? */
static bool are_same_way(const double *v, const double *p, const double *q)
{
    int j = 0;
    while (j < 2 && p[j] == v[j])
        j++;
    return (p[j] > v[j]) == (q[j] > v[j]);
}

bool fmb_have_edges_on_one_ray(int k, const fmb_cell *a, const fmb_cell *b)
{
    int i = 0, j = 0;
    while (!fmb_cell_has(b, a->id[i]))
        i++;
    while (a->id[i] != b->id[j])
        j++;
    const double *v = a->point[i];
    for (int s = 1; s < 3; s++)
        for (int t = 1; t < 3; t++) {
            const double *p = a->point[(i + s) % 3], *q = b->point[(j + t) % 3];
            if (b->id[(j + t) % 3] != a->id[i] && turn_in_plane(k, v, p, q) == 0 &&
                are_same_way(v, p, q))
                return true;
        }
    return false;
}

int fmb_triangle_axis(const fmb_cell *c)
{
    int k = 0;
    while (k < 2 && turn_in_plane(k, c->point[0], c->point[1], c->point[2]) == 0)
        k++;
    return k;
}

/* In the plane, convex polygons with interiors that do not meet are separated by the line of an
 * edge; strictly, if they are apart, which they are not with a corner in common. */
static fmb_mesh_how decide_in_plane(const fmb_cell *a, const fmb_cell *b, int shared)
{
    int k = fmb_triangle_axis(a), of_a = fmb_separate_by_edges(k, a, b);
    int of_b = of_a > 0 || (of_a == 0 && shared > 0) ? of_a : fmb_separate_by_edges(k, b, a);
    if (of_a > 0 || of_b > 0)
        return FMB_MESH_APART;
    if (of_a < 0 && of_b < 0)
        return FMB_MESH_COPLANAR;
    bool only_shared = shared == 2 || (shared == 1 && !fmb_have_edges_on_one_ray(k, a, b));
    return only_shared ? FMB_MESH_SHARE : FMB_MESH_TOUCH;
}

/* ---- neighbours ------------------------------------------------------------------------------ */

/* The axis along which the projection of this plane is largest, by a rounded normal. */
static int steepest_axis(const fmb_triangle_plane *h)
{
    int k = fabs(h->normal[1]) > fabs(h->normal[0]) ? 1 : 0;
    return fabs(h->normal[2]) > fabs(h->normal[k]) ? 2 : k;
}

/* The corners of c, rotated so that corner i comes first. */
static void list_corners_from(const fmb_cell *c, int i, const double *out[3])
{
    for (int j = 0; j < 3; j++)
        out[j] = c->point[i + j < 3 ? i + j : i + j - 3];
}

/* Triangles with a common corner, the first of both; seen along axis k, which is not in the plane
 * of a, the others of one are strictly beyond the line of an edge of the other one that ends there.
 * Then only the corner is common: another point would be seen on that line, where the one has its
 * corner alone and the other one, if it is a, no two points that are seen as one.
 */
static bool are_apart_but_for_corner(int k, const double *const a[3], const double *const b[3])
{
    int of_a = fmb_sign_of_turn(k, a[0], a[1], a[2]), turn[2][2];
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++)
            turn[i][j] = fmb_sign_of_turn(k, a[0], a[1 + i], b[1 + j]);
        int inner = i == 0 ? of_a : -of_a;
        if (inner != 0 && turn[i][0] == -inner && turn[i][1] == -inner)
            return true;
    }
    int of_b = fmb_sign_of_turn(k, a[0], b[1], b[2]);
    return of_b != 0 && ((turn[0][0] == of_b && turn[1][0] == of_b) ||
                         (turn[0][1] == -of_b && turn[1][1] == -of_b));
}

/* Triangles with a common edge, behind the first corner of both: that of b is strictly beyond it.
 * Then only the edge is common, as above. */
static bool are_apart_but_for_edge(int k, const double *const a[3], const double *const b[3])
{
    int of_a = fmb_sign_of_turn(k, a[1], a[2], a[0]);
    return of_a != 0 && fmb_sign_of_turn(k, a[1], a[2], b[0]) == -of_a;
}

/* The index of the only 1 among the three lowest bits. */
static int place_of_bit(unsigned bit)
{
    return (int)(bit >> 1);
}

/* A fast test that recognizes most neighbours in a mesh, also those in one plane, whose volumes are
 * 0 and would take long. h: a's plane. */
static bool are_mere_neighbours(const fmb_triangle_plane *h, const fmb_cell *a, unsigned of_a,
                                const fmb_cell *b, unsigned of_b, int shared)
{
    if (shared != 1 && shared != 2)
        return false;
    unsigned flip = shared == 1 ? 0 : 7;
    const double *p[3], *q[3];
    list_corners_from(a, place_of_bit(of_a ^ flip), p);
    list_corners_from(b, place_of_bit(of_b ^ flip), q);
    int k = steepest_axis(h);
    return shared == 1 ? are_apart_but_for_corner(k, p, q) : are_apart_but_for_edge(k, p, q);
}

/* Are all corners that are not shared, at least one, strictly on one side? */
static bool are_others_on_one_side(const int side[3], int shared)
{
    int sum = side[0] + side[1] + side[2];
    return sum != 0 && (sum == 3 - shared || sum == shared - 3);
}

/* ---- both ------------------------------------------------------------------------------------ */

/* A cell strictly beside a plane but for shared corners meets a cell in the plane only in these. */
fmb_mesh_how fmb_decide_triangles(const fmb_cell *a, const fmb_triangle_plane *plane,
                                  const fmb_cell *b, unsigned common)
{
    const int shared = fmb_cell_count(common);
    const unsigned of_b = fmb_cell_common(b, a);
    const fmb_mesh_how neither = shared > 0 ? FMB_MESH_SHARE : FMB_MESH_APART;
    int side_a[3], side_b[3];
    find_certain_sides(plane, b, of_b, side_b);
    if (are_others_on_one_side(side_b, shared))
        return neither;
    if (are_mere_neighbours(plane, a, common, b, of_b, shared))
        return FMB_MESH_SHARE;
    find_other_sides(plane, b, of_b, side_b);
    if (side_b[0] == 0 && side_b[1] == 0 && side_b[2] == 0)
        return decide_in_plane(a, b, shared);
    if (are_others_on_one_side(side_b, shared))
        return neither;
    fmb_triangle_plane plane_b = fmb_plane_of_cell(b);
    find_certain_sides(&plane_b, a, common, side_a);
    find_other_sides(&plane_b, a, common, side_a);
    if (are_others_on_one_side(side_a, shared))
        return neither;
    return decide_across_planes(a, side_a, b, side_b, shared);
}
