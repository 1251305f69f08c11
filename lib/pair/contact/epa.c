/* epa.c: see epa.h.
 *
 * Triangles (in the plane segments) with vertices of M, as computed in doubles, form a closed
 * surface: first that of a simplex around 0. In each step the support vertex of M is found in the
 * direction of the triangle nearest to 0; if it lies beyond, the triangles visible from it are
 * replaced by those that join it to the edges (ends) of the hole. Whatever triangles rounding makes
 * visible, the surface stays closed: each edge is still passed once in each direction.
 *
 * Proof. If 0 lies behind all triangles, at least t away from their planes, then the surface winds
 * around all points of the ball of radius t around 0, as each triangle adds a positive angle.
 * If the vertices are moved to the exact vertices of M, by 25 u R in each coordinate, the surface
 * moves by less than 64 u R, and still winds around the ball of radius t - 64 u R: that ball lies
 * in M, so the depth is at least its radius. It is at most the support of M in any direction.
 *
 * If bodies are exact (fmb_bodies_are_whole), only lengths are rounded: the surface is the boundary
 * of the hull of its vertices, 0 is behind all triangles or on them, and M lies behind a triangle
 * beyond which it has no vertex.
 */
#include "pair/contact/epa.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { MOST_VERTICES = 160, MOST_TRIANGLES = 2 * MOST_VERTICES, MOST_EDGES = 3 * MOST_TRIANGLES };

typedef struct triangle {
    uint8_t v[3];
    double n[3], at; /* the normal outward, and its product with a vertex */
    double height;   /* how far the plane certainly is away */
} triangle;

typedef struct surface {
    int dim, vertices, triangles, edges;
    bool whole;
    double x[MOST_VERTICES][3];
    triangle t[MOST_TRIANGLES];
    uint8_t edge[MOST_EDGES][2]; /* of removed triangles, passed in one direction only; in the plane
                                    a vertex, and whether it is an end */
} surface;

/* False: there is no room. */
static bool add_triangle(surface *s, int a, int b, int c)
{
    if (s->triangles == MOST_TRIANGLES)
        return false;
    triangle *t = &s->t[s->triangles++];
    t->v[0] = (uint8_t)a;
    t->v[1] = (uint8_t)b;
    t->v[2] = (uint8_t)c;
    t->height = fmb_gjk_height(s->dim, s->x[a], s->x[b], s->x[c], t->n);
    t->at = fmb_dot3(t->n, s->x[a]);
    if (s->whole)
        t->height = t->at / sqrt(fmb_dot3(t->n, t->n));
    return true;
}

/* Add an edge of a removed triangle, or cancel it against the opposite edge `other`. */
static void add_edge(surface *s, const uint8_t *edge, const uint8_t *other)
{
    for (int i = 0; i < s->edges; i++)
        if (memcmp(s->edge[i], other, sizeof s->edge[i]) == 0) {
            memcpy(s->edge[i], s->edge[--s->edges], sizeof s->edge[i]);
            return;
        }
    memcpy(s->edge[s->edges++], edge, sizeof s->edge[0]);
}

static void drop_triangle(surface *s, int i)
{
    const uint8_t *v = s->t[i].v;
    for (uint8_t k = 0; k < s->dim; k++) {
        const uint8_t next = v[(k + 1) % 3], other = k == 0;
        if (s->dim == 2)
            add_edge(s, (const uint8_t[2]){v[k], k}, (const uint8_t[2]){v[k], other});
        else
            add_edge(s, (const uint8_t[2]){v[k], next}, (const uint8_t[2]){next, v[k]});
    }
    s->t[i] = s->t[--s->triangles];
}

/* Put a vertex on the surface that lies beyond triangle `beyond`. */
static bool add_vertex(surface *s, const double *x, int beyond)
{
    if (s->vertices == MOST_VERTICES)
        return false;
    int v = s->vertices++;
    memcpy(s->x[v], x, sizeof s->x[v]);
    s->edges = 0;
    for (int i = s->triangles - 1; i >= 0; i--)
        if (i == beyond || fmb_dot3(s->t[i].n, x) > s->t[i].at)
            drop_triangle(s, i);
    bool room = true;
    for (int i = 0; room && i < s->edges; i++) {
        int from = s->edge[i][0], to = s->edge[i][1];
        room = s->dim == 3 ? add_triangle(s, from, to, v)
                           : add_triangle(s, to ? v : from, to ? from : v, v);
    }
    return room;
}

static int find_lowest_triangle(const surface *s)
{
    int lowest = 0;
    for (int i = 1; i < s->triangles; i++)
        lowest = s->t[i].height < s->t[lowest].height ? i : lowest;
    return lowest;
}

bool fmb_epa_depth(const fmb_gjk *g, double *depth, double *normal)
{
    const double reach = g->b->reach, error = 64 * DBL_EPSILON * reach;
    surface s;
    s.dim = g->b->dim;
    s.whole = g->whole;
    s.vertices = s.dim + 1;
    s.triangles = 0;
    for (int i = 0; i <= s.dim; i++)
        memcpy(s.x[i], g->v[i].x, sizeof s.x[i]);
    for (int i = 0; i <= s.dim; i++) {
        const uint8_t *f = FMB_GJK_FACE[s.dim - 2][i];
        add_triangle(&s, f[0], f[1], f[2]);
    }
    for (;;) {
        fmb_gjk_vertex far;
        int i = find_lowest_triangle(&s);
        const triangle *t = &s.t[i];
        double back[3] = {-t->n[0], -t->n[1], -t->n[2]}, length = sqrt(fmb_dot3(t->n, t->n));
        fmb_gjk_support(g, back, &far);
        const double most = fmb_dot3(t->n, far.x);
        *depth = most > 0 ? most / length : 0;
        for (int j = 0; j < g->b->dim; j++)
            normal[j] = t->n[j] / length;
        if (s.whole && most == t->at)
            return true;
        if (!(t->height > 0) && !s.whole)
            return false;
        if (t->height > 0 && *depth - t->height <= 0x1p-42 * reach)
            return *depth + error - (t->height - error) <= 0x1p-41 * reach;
        if (!add_vertex(&s, far.x, i))
            return false;
    }
}
