/* gpr.c: see gpr.h.
 *
 * Face i of a tetrahedron gives each point x a height h_i(x), affine in x; x is in the tetrahedron
 * if and only if all heights are >= 0. Three are the coordinates of x in the frame times |det|, the
 * fourth is |det| less their sum.
 *
 * Disjoint polytopes have a plane between them that contains a face of one of them, or an edge of
 * each and so one of the first. The plane of face i of p separates if h_i < 0 at all vertices of q.
 * A plane through the edge of p in which faces i and j meet, with p on one side, is r h_i + s h_j =
 * 0 for some r, s >= 0; it separates if r h_i + s h_j < 0 at all vertices of q. By Farkas there are
 * such r and s unless the hull of the four points (h_i, h_j) meets the quadrant where neither
 * coordinate is negative. The hull meets it if a vertex lies in it, or an edge crosses it: from u
 * with u_i < 0 <= u_j to v with v_j < 0 <= v_i, and passing the origin above or through it,
 * u_i v_j - u_j v_i <= 0.
 *
 * The signs of the heights are kept as bits, which decide nearly everything: the heights themselves
 * are needed only for pairs of vertices on two sides.
 */
#include "study/rivals/gpr.h"

#include <math.h>

/* The heights of the vertices of one tetrahedron over the faces of the other. */
typedef struct heights {
    double at[4][4]; /* [face][vertex] */
    unsigned out[4]; /* [face] bit v: vertex v is outside of it */
} heights;

static void cross(const double *x, const double *y, double *out)
{
    out[0] = x[1] * y[2] - x[2] * y[1];
    out[1] = x[2] * y[0] - x[0] * y[2];
    out[2] = x[0] * y[1] - x[1] * y[0];
}

static double dot(const double *x, const double *y)
{
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/* Heights of the vertices of q over a face of p with that inner normal; base is that of q's corner.
 * False if all are negative. */
static bool measure(const fmb_frame *q, const double *normal, double base, int face, heights *h)
{
    double *to = h->at[face];
    to[0] = base;
    h->out[face] = to[0] < 0;
    for (int v = 1; v < 4; v++) {
        to[v] = base + dot(normal, q->axes + 3 * (v - 1));
        h->out[face] |= (unsigned)(to[v] < 0) << v;
    }
    return h->out[face] != 15;
}

/* All heights of q over p; false as soon as a face separates. */
static bool look(const fmb_frame *p, const fmb_frame *q, heights *h)
{
    double shift[3], normal[4][3], base[3];
    for (int j = 0; j < 3; j++)
        shift[j] = q->origin[j] - p->origin[j];
    for (int i = 0; i < 3; i++)
        cross(p->axes + 3 * ((i + 1) % 3), p->axes + 3 * ((i + 2) % 3), normal[i]);
    double size = dot(p->axes, normal[0]), sign = size < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            normal[i][j] *= sign;
        base[i] = dot(normal[i], shift);
        if (!measure(q, normal[i], base[i], i, h))
            return false;
    }
    for (int j = 0; j < 3; j++)
        normal[3][j] = -(normal[0][j] + normal[1][j] + normal[2][j]);
    return measure(q, normal[3], fabs(size) - (base[0] + base[1] + base[2]), 3, h);
}

/* Does a plane through the edge of faces i and j separate? */
static bool edge_separates(const heights *h, int i, int j)
{
    if ((h->out[i] | h->out[j]) != 15)
        return false;
    unsigned only_i = h->out[i] & ~h->out[j], only_j = h->out[j] & ~h->out[i];
    for (int u = 0; u < 4; u++)
        for (int v = 0; v < 4; v++)
            if (only_i >> u & only_j >> v & 1 &&
                h->at[i][u] * h->at[j][v] - h->at[j][u] * h->at[i][v] <= 0)
                return false;
    return true;
}

bool study_gpr_meet(const fmb_frame *p, const fmb_frame *q)
{
    heights h, back;
    if (!look(p, q, &h))
        return false;
    if ((h.out[0] | h.out[1] | h.out[2] | h.out[3]) != 15)
        return true; /* a vertex is inside */
    for (int i = 0; i < 4; i++)
        for (int j = i + 1; j < 4; j++)
            if (edge_separates(&h, i, j))
                return false;
    return look(q, p, &back);
}
