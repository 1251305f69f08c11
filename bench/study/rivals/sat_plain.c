/* sat_plain.c: see sat_plain.h.
 *
 * Two convex polytopes are apart iff a normal of a face of one of them, or a cross product of an
 * edge of each, separates them; in the plane, a normal of an edge. Relative to P, a moving Q sweeps
 * the Minkowski sum of Q and the segment of its path: a polytope with one more edge direction.
 *
 * The cost is the article's, too: for each axis all corners are computed anew and compared with the
 * extremes so far, those of Q once more at the end of the path. The order of axes and corners,
 * which decides the cost of disjoint pairs, is that of the article's program, and so are the jump
 * by the number of a corner and, in space, one function for all axes, which a processor predicts
 * otherwise than copies of them.
 */
#include "study/rivals/sat_plain.h"

#include <string.h>

enum { MOST_EDGES = 6 };

/* Compiled once for each number of dimensions. */
#define SAT_PLAIN_INLINE static inline __attribute__((always_inline))

/* Pointers to the numbers of a frame. */
typedef struct body {
    fmb_shape shape;
    const double *origin, *axes, *speed;
} body;

/* Both frames, and the path of Q relative to P; NULL if nothing moves. */
typedef struct scene {
    body p, q;
    const double *way;
} scene;

/* ---- one axis -------------------------------------------------------------------------------- */

/* A corner; its z is 0 in the plane. */
typedef struct place {
    double x, y, z;
} place;

SAT_PLAIN_INLINE place place_at(int dim, const double *v)
{
    return (place){v[0], v[1], dim == 2 ? 0 : v[2]};
}

SAT_PLAIN_INLINE place sum(place a, place b)
{
    return (place){a.x + b.x, a.y + b.y, a.z + b.z};
}

SAT_PLAIN_INLINE double dot(int dim, place a, const double *axis)
{
    double plane = a.x * axis[0] + a.y * axis[1];
    return dim == 2 ? plane : plane + a.z * axis[2];
}

SAT_PLAIN_INLINE place axis_of(int dim, const body *f, int k)
{
    return place_at(dim, f->axes + k * dim);
}

/* The corner with that number: axes are added up before the origin is added. The first dim + 1
 * corners are those of a simplex, all 2^dim those of a cuboid. */
SAT_PLAIN_INLINE place corner_in_plane(const body *f, int which)
{
    place o = place_at(2, f->origin);
    switch (which) {
    case 3:
        return sum(o, sum(axis_of(2, f, 0), axis_of(2, f, 1)));
    case 2:
        return sum(o, axis_of(2, f, 0));
    case 1:
        return sum(o, axis_of(2, f, 1));
    default:
        return o;
    }
}

SAT_PLAIN_INLINE place corner_in_space(const body *f, int which)
{
    place o = place_at(3, f->origin);
    switch (which) {
    case 7:
        return sum(o, sum(sum(axis_of(3, f, 0), axis_of(3, f, 1)), axis_of(3, f, 2)));
    case 6:
        return sum(o, sum(axis_of(3, f, 1), axis_of(3, f, 2)));
    case 5:
        return sum(o, sum(axis_of(3, f, 0), axis_of(3, f, 2)));
    case 4:
        return sum(o, sum(axis_of(3, f, 0), axis_of(3, f, 1)));
    case 3:
        return sum(o, axis_of(3, f, 2));
    case 2:
        return sum(o, axis_of(3, f, 1));
    case 1:
        return sum(o, axis_of(3, f, 0));
    default:
        return o;
    }
}

SAT_PLAIN_INLINE void widen(double x, double *ends)
{
    if (ends[0] > x)
        ends[0] = x;
    if (ends[1] < x)
        ends[1] = x;
}

/* The interval of f on the axis, over all of its path. */
SAT_PLAIN_INLINE void project_corners(int dim, const body *f, const double *way, const double *axis,
                                      double *ends)
{
    bool first = true;
    for (int i = f->shape == FMB_CUBOID ? 1 << dim : dim + 1; i--; first = false) {
        place corner = dim == 2 ? corner_in_plane(f, i) : corner_in_space(f, i);
        double x = dot(dim, corner, axis);
        if (first)
            ends[0] = ends[1] = x;
        else
            widen(x, ends);
        if (way)
            widen(dot(dim, sum(corner, place_at(dim, way)), axis), ends);
    }
}

SAT_PLAIN_INLINE bool separates_frames(int dim, bool moves, const scene *s, const double *axis)
{
    double ends[2][2];
    for (int i = 0; i < 2; i++) {
        const body f = i == 0 ? s->p : s->q; /* a copy: its pointers stay in registers */
        project_corners(dim, &f, moves && i == 1 ? s->way : NULL, axis, ends[i]);
    }
    return ends[0][1] < ends[1][0] || ends[1][1] < ends[0][0];
}

static __attribute__((noinline)) bool separates_still_in_space(const scene *s, const double *axis)
{
    return separates_frames(3, false, s, axis);
}

static __attribute__((noinline)) bool separates_moving_in_space(const scene *s, const double *axis)
{
    return separates_frames(3, true, s, axis);
}

SAT_PLAIN_INLINE bool separates(int dim, const scene *s, const double *axis)
{
    if (dim == 3)
        return s->way ? separates_moving_in_space(s, axis) : separates_still_in_space(s, axis);
    return s->way ? separates_frames(2, true, s, axis) : separates_frames(2, false, s, axis);
}

/* ---- in the plane ---------------------------------------------------------------------------- */

SAT_PLAIN_INLINE bool normal_separates(const scene *s, const double *edge)
{
    double normal[2] = {edge[1], -edge[0]};
    return separates(2, s, normal);
}

SAT_PLAIN_INLINE bool apart_in_plane(const scene *s)
{
    if (s->way && normal_separates(s, s->way))
        return true;
    for (int i = 0; i < 2; i++) {
        const body f = i == 0 ? s->p : s->q;
        double third[2];
        int edges = 2;
        if (f.shape == FMB_SIMPLEX) {
            third[0] = f.axes[2] - f.axes[0];
            third[1] = f.axes[3] - f.axes[1];
            edges = 3;
        }
        for (int k = edges; k--;)
            if (normal_separates(s, k == 2 ? third : f.axes + 2 * k))
                return true;
    }
    return false;
}

/* ---- in space -------------------------------------------------------------------------------- */

/* All edge directions: the axes, and for a simplex their differences. */
typedef struct edges {
    int n;
    const double *edge[MOST_EDGES];
    double difference[3][3];
} edges;

static void list_edges(const body *f, edges *s)
{
    static const int FROM[3] = {0, 2, 0}, TO[3] = {1, 1, 2};
    s->n = 3;
    for (int k = 0; k < 3; k++)
        s->edge[k] = f->axes + 3 * k;
    for (int k = 0; f->shape == FMB_SIMPLEX && k < 3; k++) {
        for (int j = 0; j < 3; j++)
            s->difference[k][j] = s->edge[TO[k]][j] - s->edge[FROM[k]][j];
        s->edge[s->n++] = s->difference[k];
    }
}

static bool cross_separates(const scene *s, const double *a, const double *b)
{
    double axis[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                      a[0] * b[1] - a[1] * b[0]};
    return separates(3, s, axis);
}

/* Two axes span a face; two differences of axes span the last face of a simplex. */
static bool faces_separate(const scene *s, const edges *of)
{
    return (of->n > 3 && cross_separates(s, of->edge[3], of->edge[4])) ||
           cross_separates(s, of->edge[2], of->edge[1]) ||
           cross_separates(s, of->edge[0], of->edge[2]) ||
           cross_separates(s, of->edge[0], of->edge[1]);
}

/* Faces that Q sweeps. */
static bool swept_faces_separate(const scene *s, const edges *q)
{
    for (int k = q->n; k--;)
        if (cross_separates(s, s->way, q->edge[k]))
            return true;
    return false;
}

static bool edges_separate(const scene *s, const edges *p, const edges *q)
{
    for (int i = p->n; i--;) {
        if (s->way && cross_separates(s, p->edge[i], s->way))
            return true;
        for (int j = q->n; j--;)
            if (cross_separates(s, p->edge[i], q->edge[j]))
                return true;
    }
    return false;
}

static __attribute__((noinline)) bool apart_in_space(const scene *s)
{
    edges p, q;
    list_edges(&s->p, &p);
    list_edges(&s->q, &q);
    return faces_separate(s, &p) || (s->way && swept_faces_separate(s, &q)) ||
           faces_separate(s, &q) || edges_separate(s, &p, &q);
}

SAT_PLAIN_INLINE bool do_meet(int dim, const body *p, const body *q)
{
    scene s = {*p, *q, NULL};
    double way[3];
    if (p->speed || q->speed) {
        for (int j = 0; j < dim; j++)
            way[j] = (q->speed ? q->speed[j] : 0) - (p->speed ? p->speed[j] : 0);
        s.way = way;
    }
    return !(dim == 2 ? apart_in_plane(&s) : apart_in_space(&s));
}

bool study_sat_plain(const fmb_frame *p, const fmb_frame *q)
{
    body a = {p->shape, p->origin, p->axes, p->speed}, b = {q->shape, q->origin, q->axes, q->speed};
    return p->dim == 2 ? do_meet(2, &a, &b) : do_meet(3, &a, &b);
}

/* ---- frames as the program has them ---------------------------------------------------------- */

void study_sat_record_make(const fmb_frame *f, study_sat_record *out)
{
    size_t dim = (size_t)f->dim;
    *out = (study_sat_record){.shape = f->shape};
    memcpy(out->origin, f->origin, dim * sizeof *f->origin);
    memcpy(out->axes, f->axes, dim * dim * sizeof *f->axes);
    if (f->speed)
        memcpy(out->speed, f->speed, dim * sizeof *f->speed);
}

SAT_PLAIN_INLINE bool do_records_meet(int dim, bool move, const study_sat_record *p,
                                      const study_sat_record *q)
{
    const body a = {p->shape, p->origin, p->axes, move ? p->speed : NULL};
    const body b = {q->shape, q->origin, q->axes, move ? q->speed : NULL};
    return do_meet(dim, &a, &b);
}

static bool do_still_2(const study_sat_record *p, const study_sat_record *q)
{
    return do_records_meet(2, false, p, q);
}

static bool do_moving_2(const study_sat_record *p, const study_sat_record *q)
{
    return do_records_meet(2, true, p, q);
}

static bool do_still_3(const study_sat_record *p, const study_sat_record *q)
{
    return do_records_meet(3, false, p, q);
}

static bool do_moving_3(const study_sat_record *p, const study_sat_record *q)
{
    return do_records_meet(3, true, p, q);
}

study_sat_records_meet *study_sat_program(int dim, bool move)
{
    static study_sat_records_meet *const PROGRAM[2][2] = {{do_still_2, do_moving_2},
                                                          {do_still_3, do_moving_3}};
    return PROGRAM[dim - 2][move];
}
