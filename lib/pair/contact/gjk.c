/* gjk.c: see gjk.h.
 *
 * The nearest point x of a simplex is orthogonalized against it once more: its remaining error then
 * hardly tilts the plane that proves the distance. That proof needs only x, however it was found.
 */
#include "pair/contact/gjk.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* More steps than this occur only by rounding. */
enum { MOST_STEPS = 64 };

static void subtract(const double *a, const double *b, double *out)
{
    for (int j = 0; j < 3; j++)
        out[j] = a[j] - b[j];
}

static void cross(const double *a, const double *b, double *out)
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* ---- support --------------------------------------------------------------------------------- */

/* The vertex of side k that is farthest in direction `along`. */
static int farthest_vertex(const fmb_bodies *b, int k, const double *along)
{
    const fmb_body_vertices *s = &b->side[k];
    int best = 0;
    if (s->edges > 0) {
        for (int i = 0; i < s->edges; i++)
            best |= (fmb_dot3(along, s->edge[i]) > 0) << i;
        return best;
    }
    if (s->n > 4 && b->hulls)
        return b->hulls->farthest(s->x[0], s->n, along);
    double most = -DBL_MAX;
    for (int v = 0; v < s->n; v++) {
        double at = along[0] * s->x[0][v] + along[1] * s->x[1][v] + along[2] * s->x[2][v];
        best = at > most ? v : best;
        most = at > most ? at : most;
    }
    return best;
}

void fmb_gjk_support(const fmb_gjk *g, const double *w, fmb_gjk_vertex *out)
{
    const fmb_body_vertices *a = &g->b->side[0], *b = &g->b->side[1];
    const double back[3] = {-w[0], -w[1], -w[2]};
    int i = farthest_vertex(g->b, 0, back), k = farthest_vertex(g->b, 1, w);
    out->of[0] = i;
    out->of[1] = k;
    out->late = g->b->moves && fmb_dot3(w, g->b->drift) < 0;
    for (int j = 0; j < 3; j++)
        out->x[j] = a->x[j][i] - b->x[j][k] + (out->late ? g->b->drift[j] : 0);
}

/* ---- the nearest point of a simplex ---------------------------------------------------------- */

/* A point of a simplex: vertices, in rising order, and their weights. */
typedef struct simplex_point {
    int n, of[4];
    double weight[4], x[3];
} simplex_point;

static void nearest_of_vertex(const fmb_gjk *g, int i, simplex_point *out)
{
    out->n = 1;
    out->of[0] = i;
    out->weight[0] = 1;
    memcpy(out->x, g->v[i].x, sizeof out->x);
}

static void nearest_of_edge(const fmb_gjk *g, int i, int k, simplex_point *out)
{
    double d[3];
    subtract(g->v[k].x, g->v[i].x, d);
    double length = fmb_dot3(d, d), t = -fmb_dot3(g->v[i].x, d);
    if (!(t > 0)) {
        nearest_of_vertex(g, i, out);
        return;
    }
    if (t >= length) {
        nearest_of_vertex(g, k, out);
        return;
    }
    t /= length;
    for (int j = 0; j < 3; j++)
        out->x[j] = g->v[i].x[j] + t * d[j];
    double off = fmb_dot3(out->x, d) / length;
    for (int j = 0; j < 3; j++)
        out->x[j] -= off * d[j];
    out->n = 2;
    out->of[0] = i;
    out->of[1] = k;
    out->weight[0] = 1 - t;
    out->weight[1] = t;
}

/* Ericson, Real-Time Collision Detection (2005), 5.1.5, with 0 as the point. */
static void nearest_of_triangle(const fmb_gjk *g, int i, int k, int l, simplex_point *out)
{
    const double *a = g->v[i].x, *b = g->v[k].x, *c = g->v[l].x;
    double ab[3], ac[3], n[3];
    subtract(b, a, ab);
    subtract(c, a, ac);
    double d1 = -fmb_dot3(ab, a), d2 = -fmb_dot3(ac, a), d3 = -fmb_dot3(ab, b),
           d4 = -fmb_dot3(ac, b);
    double d5 = -fmb_dot3(ab, c), d6 = -fmb_dot3(ac, c);
    double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    if (d1 <= 0 && d2 <= 0) {
        nearest_of_vertex(g, i, out);
    } else if (d3 >= 0 && d4 <= d3) {
        nearest_of_vertex(g, k, out);
    } else if (d6 >= 0 && d5 <= d6) {
        nearest_of_vertex(g, l, out);
    } else if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        nearest_of_edge(g, i, k, out);
    } else if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        nearest_of_edge(g, i, l, out);
    } else if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        nearest_of_edge(g, k, l, out);
    } else {
        cross(ab, ac, n);
        double sum = va + vb + vc, off = fmb_dot3(n, a) / fmb_dot3(n, n);
        *out = (simplex_point){3, {i, k, l}, {va / sum, vb / sum, vc / sum}, {0}};
        for (int j = 0; j < 3; j++)
            out->x[j] = off * n[j];
    }
}

/* Does the plane of face i, k, l separate 0 from vertex m? */
static bool is_outside_face(const fmb_gjk *g, int i, int k, int l, int m)
{
    double ab[3], ac[3], am[3], n[3];
    subtract(g->v[k].x, g->v[i].x, ab);
    subtract(g->v[l].x, g->v[i].x, ac);
    subtract(g->v[m].x, g->v[i].x, am);
    cross(ab, ac, n);
    return fmb_dot3(n, g->v[i].x) * fmb_dot3(n, am) >= 0;
}

const uint8_t FMB_GJK_FACE[2][4][3] = {{{0, 1, 0}, {1, 2, 0}, {2, 0, 0}},
                                       {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}}};

/* The nearest of the faces at the last vertex, beyond which 0 lies; 0 was not beyond the first. */
static void nearest_of_tetrahedron(const fmb_gjk *g, simplex_point *out)
{
    static const uint8_t face[3][4] = {{0, 1, 3, 2}, {1, 2, 3, 0}, {0, 2, 3, 1}};
    double least = INFINITY;
    for (int i = 0; i < 3; i++) {
        const uint8_t *f = face[i];
        if (!is_outside_face(g, f[0], f[1], f[2], f[3]))
            continue;
        simplex_point one;
        nearest_of_triangle(g, f[0], f[1], f[2], &one);
        double square = fmb_dot3(one.x, one.x);
        if (square < least) {
            least = square;
            *out = one;
        }
    }
    if (least == INFINITY)
        *out = (simplex_point){4, {0, 1, 2, 3}, {-1}, {0}};
}

static void nearest_of_simplex(const fmb_gjk *g, int n, simplex_point *out)
{
    if (n == 1)
        nearest_of_vertex(g, 0, out);
    else if (n == 2)
        nearest_of_edge(g, 0, 1, out);
    else if (n == 3)
        nearest_of_triangle(g, 0, 1, 2, out);
    else
        nearest_of_tetrahedron(g, out);
}

/* ---- the nearest point of M ------------------------------------------------------------------ */

static bool is_in_simplex(const fmb_gjk *g, const fmb_gjk_vertex *v)
{
    int i = 0;
    while (i < g->n &&
           (g->v[i].of[0] != v->of[0] || g->v[i].of[1] != v->of[1] || g->v[i].late != v->late))
        i++;
    return i < g->n;
}

/* Update the bound of the distance, given that v is the support of M in direction -w. The square
 * root is computed only if the bodies are apart along w. */
static void note_apart(fmb_gjk *g, const double *w, const fmb_gjk_vertex *v)
{
    const double error = 64 * DBL_EPSILON * g->b->reach;
    double between = fmb_dot3(w, v->x) - error * fmb_size3(w);
    if (!(between > 0))
        return;
    double length = sqrt(fmb_dot3(w, w)), apart = between / length * (1 - 8 * DBL_EPSILON);
    if (apart > g->apart) {
        g->apart = apart;
        for (int j = 0; j < 3; j++)
            g->along[j] = w[j] / length;
    }
}

/* One GJK step to the vertex after those of the simplex; false: it comes no nearer, and nothing is
 * changed.
 */
static bool step_to_vertex(fmb_gjk *g, double *square)
{
    simplex_point p;
    nearest_of_simplex(g, g->n + 1, &p);
    double now = fmb_dot3(p.x, p.x);
    if (!(now < *square))
        return false;
    *square = now;
    g->n = p.n;
    for (int i = 0; i < p.n; i++) {
        if (p.of[i] > i)
            g->v[i] = g->v[p.of[i]];
        g->weight[i] = p.weight[i];
    }
    memcpy(g->x, p.x, sizeof g->x);
    return true;
}

void fmb_gjk_nearest(fmb_gjk *g, const double *guess, double enough)
{
    const double close = 0x1p-43 * g->b->reach;
    double square = INFINITY;
    g->apart = -INFINITY;
    g->n = 0;
    fmb_gjk_support(g, guess, &g->v[0]);
    note_apart(g, guess, &g->v[0]);
    for (int step = 0; step < MOST_STEPS && step_to_vertex(g, &square); step++) {
        fmb_gjk_vertex *next = &g->v[g->n];
        if (g->weight[0] < 0 || square <= close * close || g->apart > enough)
            return;
        fmb_gjk_support(g, g->x, next);
        double left = square - fmb_dot3(g->x, next->x);
        note_apart(g, g->x, next);
        if (g->apart > enough || left <= 0 || left * left <= close * close * square ||
            is_in_simplex(g, next))
            return;
    }
}

void fmb_gjk_points(const fmb_gjk *g, double point[2][3], double *time)
{
    memset(point, 0, 2 * sizeof *point);
    *time = 0;
    for (int i = 0; i < g->n; i++) {
        for (int k = 0; k < 2; k++)
            for (int j = 0; j < 3; j++)
                point[k][j] += g->weight[i] * g->b->side[k].x[j][g->v[i].of[k]];
        *time += g->v[i].late ? g->weight[i] : 0;
    }
}

/* ---- proofs that they meet ------------------------------------------------------------------- */

/* With s the product of the sizes of both edges, n is off by 8 u s in each coordinate, which are 2
 * s at most; n a by three times that and 18 u s, times the size of a; the length of n by 14 u s,
 * and 4 u of itself, which is 2 sqrt(3) s at most. */
double fmb_gjk_height(int dim, const double *a, const double *b, const double *c, double *n)
{
    const double u = DBL_EPSILON / 2;
    double ab[3], ac[3] = {0, 0, 1};
    subtract(b, a, ab);
    if (dim == 3)
        subtract(c, a, ac);
    cross(ab, ac, n);
    double s = fmb_size3(ab) * fmb_size3(ac), above = fmb_dot3(n, a) - 48 * u * s * fmb_size3(a);
    return above > 0 ? above / (sqrt(fmb_dot3(n, n)) + 32 * u * s) * (1 - 8 * u) : 0;
}

/* Orient the faces of the simplex outward; half of all simplices need it. */
static void turn_simplex(fmb_gjk *g)
{
    double ab[3], ac[3], ad[3] = {0, 0, 1}, n[3];
    subtract(g->v[1].x, g->v[0].x, ab);
    subtract(g->v[2].x, g->v[0].x, ac);
    if (g->n > 3)
        subtract(g->v[3].x, g->v[0].x, ad);
    cross(ab, ac, n);
    if (fmb_dot3(n, ad) >= 0)
        return;
    fmb_gjk_vertex t = g->v[0];
    g->v[0] = g->v[1];
    g->v[1] = t;
}

bool fmb_gjk_is_inside(fmb_gjk *g)
{
    int dim = g->b->dim;
    double n[3];
    bool inside = g->n > dim;
    if (inside)
        turn_simplex(g);
    for (int i = 0; inside && i <= dim; i++) {
        const uint8_t *f = FMB_GJK_FACE[dim - 2][i];
        inside = fmb_gjk_height(dim, g->v[f[0]].x, g->v[f[1]].x, g->v[f[2]].x, n) >
                 32 * DBL_EPSILON * g->b->reach;
    }
    return inside;
}

/* ---- of whole numbers ------------------------------------------------------------------------ */

/* Add a vertex of M that differs along w from the present vertices, which are all equal along w;
 * false: there is none. */
static bool add_vertex_beside(fmb_gjk *g, const double *w)
{
    const double back[3] = {-w[0], -w[1], -w[2]};
    for (int side = 0; side < 2; side++) {
        fmb_gjk_support(g, side == 0 ? w : back, &g->v[g->n]);
        if (fmb_dot3(w, g->v[g->n].x) != fmb_dot3(w, g->v[0].x)) {
            g->n++;
            return true;
        }
    }
    return false;
}

/* Add a vertex in a direction perpendicular to the present edges. */
static bool grow_simplex(fmb_gjk *g)
{
    bool grown = false;
    for (int j = 0; j < 3 && !grown; j++) {
        double axis[3] = {j == 0, j == 1, j == 2}, edge[3], w[3];
        memcpy(w, axis, sizeof w);
        if (g->n > 2)
            subtract(g->v[2].x, g->v[0].x, axis);
        if (g->n > 1) {
            subtract(g->v[1].x, g->v[0].x, edge);
            cross(edge, axis, w);
        }
        grown = add_vertex_beside(g, w);
    }
    return grown;
}

/* The simplex is none in a plane if its vertex 2, which is not on the first face, is behind that.
 */
bool fmb_gjk_surrounds(fmb_gjk *g)
{
    const int dim = g->b->dim;
    while (g->n <= dim)
        if (!grow_simplex(g))
            return false;
    turn_simplex(g);
    bool around = true;
    for (int i = 0; around && i <= dim; i++) {
        const uint8_t *f = FMB_GJK_FACE[dim - 2][i];
        double n[3], at;
        fmb_gjk_height(dim, g->v[f[0]].x, g->v[f[1]].x, g->v[f[2]].x, n);
        at = fmb_dot3(n, g->v[f[0]].x);
        around = at >= 0 && (i > 0 || fmb_dot3(n, g->v[2].x) < at);
    }
    return around;
}
