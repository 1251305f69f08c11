/* bodies.h: two frames as lists of vertices, in doubles that do not overflow nor, unless stated,
 * underflow: relative to the origin of the first frame and, where numbers are very large or small,
 * divided by the power of two just above the largest.
 *
 * With R = reach, coordinates are at most R, with errors of at most 12 u R: from the difference of
 * origins, up to three edges that may be differences themselves, and the rounding of their sum.
 */
#ifndef FMB_PAIR_CONTACT_BODIES_H
#define FMB_PAIR_CONTACT_BODIES_H

#include <fmb/pair.h>

#include <math.h>

/* Vertices of a body. */
enum { FMB_BODY_MOST = 64 };

typedef struct fmb_body_vertices {
    int n, edges;      /* edges > 0: a cuboid; vertex v is the sum of the edges of its bits */
    double edge[3][3]; /* of a cuboid */
    double x[3][FMB_BODY_MOST]; /* of a simplex: padded with the first vertex to a
                                      multiple of four, or of eight if there are more */
} fmb_body_vertices;

/* Loops over more than four vertices, x[3][FMB_BODY_MOST], padded with repeated vertices to a
 * multiple of eight. */
typedef struct fmb_hull_kernels {
    /* The number of a vertex, of n, that is farthest along w. */
    int (*farthest)(const double *x, int n, const double *w);
    /* Write n points of space, times both factors and minus `from`, as vertices, then `first`.
     * Returns the size of the longest vector from `first` to a vertex. */
    double (*place)(const double *points, int n, const double factor[2], const double *from,
                    const double *first, double *x);
} fmb_hull_kernels;

typedef struct fmb_bodies {
    const fmb_hull_kernels *hulls; /* or NULL: loops over single vertices */
    int dim, exponent;             /* the world is 2^exponent times as large */
    bool moves, known;             /* known: the reach is far above the underflow threshold */
    double reach;    /* <fmb/pair.h>: sizes of all edges, of the vector between the origins and of
                        the drift; of a frame with more axes than dim its longest edge twice */
    double drift[3]; /* speed of the first minus that of the second */
    fmb_body_vertices side[2];
} fmb_bodies;

static inline double fmb_dot3(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The largest coordinate. */
static inline double fmb_size3(const double *a)
{
    double x = fabs(a[0]), y = fabs(a[1]), z = fabs(a[2]);
    x = x > y ? x : y;
    return x > z ? x : z;
}

/* Can good frames be represented as bodies? */
static inline bool fmb_bodies_are(const fmb_frame *p, const fmb_frame *q)
{
    return (p->dim == 2 || p->dim == 3) && p->naxes < FMB_BODY_MOST && q->naxes < FMB_BODY_MOST;
}
/* For frames that satisfy fmb_bodies_are. Sets all but hulls. */
void fmb_bodies_init(const fmb_frame *p, const fmb_frame *q, fmb_bodies *out);
/* Are all numbers multiples of one power of two, and coordinates less than 2^16 times it? Vertices
 * are then exact, and so are products and sums made of three differences of them (less than 2^17):
 * these are less than 2^53. */
bool fmb_bodies_are_whole(const fmb_frame *p, const fmb_frame *q, const fmb_bodies *b);
/* Convert coordinate j of a body to a world coordinate. */
double fmb_bodies_place(const fmb_bodies *b, const fmb_frame *p, int j, double x);

#endif
