/* sat_plain.c: see sat_plain.h.
 *
 * Two convex polytopes are apart iff a normal of a face of one of them, or a cross product of an
 * edge of each, separates them; in the plane, a normal of an edge. Seen from P, a moving Q sweeps
 * the sum of Q and the segment of its way: a polytope that has that way as one more edge.
 */
#include "study/rivals/sat_plain.h"

#include <math.h>
#include <string.h>

enum { MOST_CORNERS = 8, MOST_EDGES = 6 };

/* A frame in the world; in the plane, the third coordinate is 0. */
typedef struct solid {
    int corners, edges;
    double corner[MOST_CORNERS][3], edge[MOST_EDGES][3];
} solid;

static void cross(const double *a, const double *b, double *out)
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* ---- corners and edges ----------------------------------------------------------------------- */

/* The corner of a cuboid whose coordinates are the bits of which; of a simplex, its corner number
 * which. */
static void put_corner(const fmb_frame *f, int which, double *corner)
{
    for (int j = 0; j < f->dim; j++) {
        corner[j] = f->origin[j];
        for (int k = 0; k < f->dim; k++)
            if (f->shape == FMB_CUBOID ? which >> k & 1 : which == k + 1)
                corner[j] += f->axes[k * f->dim + j];
    }
}

/* Edges in all directions: the axes, and of a simplex their differences. */
static void put_edges(const fmb_frame *f, solid *s)
{
    for (int k = 0; k < f->dim; k++, s->edges++)
        memcpy(s->edge[k], f->axes + k * f->dim, (size_t)f->dim * sizeof(double));
    for (int k = 0; f->shape == FMB_SIMPLEX && k < f->dim; k++)
        for (int l = 0; l < k; l++, s->edges++)
            for (int j = 0; j < f->dim; j++)
                s->edge[s->edges][j] = s->edge[k][j] - s->edge[l][j];
}

static void solid_of(const fmb_frame *f, solid *s)
{
    memset(s, 0, sizeof *s);
    s->corners = f->shape == FMB_CUBOID ? 1 << f->dim : f->dim + 1;
    for (int i = 0; i < s->corners; i++)
        put_corner(f, i, s->corner[i]);
    put_edges(f, s);
}

/* ---- axes ------------------------------------------------------------------------------------ */

/* Both, and the way of Q as P sees it; NULL if nothing moves. */
typedef struct scene {
    solid p, q;
    const double *way;
} scene;

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void project(const solid *s, const double *axis, double *least, double *most)
{
    *least = INFINITY;
    *most = -INFINITY;
    for (int i = 0; i < s->corners; i++) {
        double x = dot(axis, s->corner[i]);
        if (x < *least)
            *least = x;
        if (x > *most)
            *most = x;
    }
}

static bool separates(const scene *s, const double *axis)
{
    double p[2], q[2];
    project(&s->p, axis, &p[0], &p[1]);
    project(&s->q, axis, &q[0], &q[1]);
    if (s->way) {
        double x = dot(axis, s->way);
        if (x < 0)
            q[0] += x;
        else
            q[1] += x;
    }
    return p[1] < q[0] || q[1] < p[0];
}

static bool separates_across(const scene *s, const double *a, const double *b)
{
    double axis[3];
    cross(a, b, axis);
    return separates(s, axis);
}

/* Faces in three dimensions: two axes span one, and two differences of axes the last of a simplex,
 * whose edges 3, 4, 5 are those. */
static bool faces_separate(const scene *s, const solid *of)
{
    for (int k = 0; k < 3; k++)
        if (separates_across(s, of->edge[k], of->edge[(k + 1) % 3]))
            return true;
    return of->edges > 3 && separates_across(s, of->edge[3], of->edge[4]);
}

static bool edges_separate(const scene *s)
{
    for (int i = 0; i < s->p.edges; i++)
        for (int j = 0; j < s->q.edges; j++)
            if (separates_across(s, s->p.edge[i], s->q.edge[j]))
                return true;
    return false;
}

/* Edges of one of them across a direction: the way; in the plane, what stands on it. */
static bool edges_separate_across(const scene *s, const solid *of, const double *direction)
{
    for (int k = 0; k < of->edges; k++)
        if (separates_across(s, of->edge[k], direction))
            return true;
    return false;
}

static bool apart_in_plane(const scene *s)
{
    static const double UP[3] = {0, 0, 1};
    return edges_separate_across(s, &s->p, UP) || edges_separate_across(s, &s->q, UP) ||
           (s->way && separates_across(s, s->way, UP));
}

static bool apart_in_space(const scene *s)
{
    return faces_separate(s, &s->p) || faces_separate(s, &s->q) || edges_separate(s) ||
           (s->way &&
            (edges_separate_across(s, &s->p, s->way) || edges_separate_across(s, &s->q, s->way)));
}

bool study_sat_plain(const fmb_frame *p, const fmb_frame *q)
{
    scene s = {.way = NULL};
    double way[3] = {0, 0, 0};
    solid_of(p, &s.p);
    solid_of(q, &s.q);
    for (int j = 0; j < p->dim; j++)
        way[j] = (q->speed ? q->speed[j] : 0) - (p->speed ? p->speed[j] : 0);
    if (p->speed || q->speed)
        s.way = way;
    return !(p->dim == 2 ? apart_in_plane(&s) : apart_in_space(&s));
}
