/* bodies.h: two frames as vertices, in doubles that neither overflow nor, unless it is said so,
 * underflow: less the origin of the first, and where they are very large or small over the power of
 * two that is just above the largest number.
 *
 * With R = reach, coordinates are at most R, and off by 12 u R: a difference of origins, up to
 * three edges that may be differences themselves, and what is rounded where they are added.
 */
#ifndef FMB_PAIR_CONTACT_BODIES_H
#define FMB_PAIR_CONTACT_BODIES_H

#include <fmb/pair.h>

#include <math.h>

/* Vertices of a body. */
enum { FMB_BODY_MOST = 64 };

typedef struct fmb_body_vertices {
    int n, edges;      /* edges > 0: a cuboid with so many; vertex v has those of its bits */
    double edge[3][3]; /* of a cuboid */
    double x[3][FMB_BODY_MOST]; /* of a simplex up to a multiple of four, if there
                                      are more of eight, with the first one again */
} fmb_body_vertices;

/* Loops over more vertices than four, x[3][FMB_BODY_MOST]. Up to a multiple of eight vertices come
 * again. */
typedef struct fmb_hull_kernels {
    /* The number of a vertex of n that is farthest along w. */
    int (*farthest)(const double *x, int n, const double *w);
    /* n points of space, times both factors and less `from`, become vertices, and `first` the one
     * behind them. The size of the longest way from that one to another. */
    double (*place)(const double *points, int n, const double factor[2], const double *from,
                    const double *first, double *x);
} fmb_hull_kernels;

typedef struct fmb_bodies {
    const fmb_hull_kernels *hulls; /* or NULL: one after another */
    int dim, exponent;             /* the world is 2^exponent times as large */
    bool moves, known;             /* known: the reach is far above what underflows */
    double reach;    /* <fmb/pair.h>: sizes of all edges, of the way between the origins and of
                        the drift; of a frame with more axes than dim its longest edge twice */
    double drift[3]; /* speed of the first less that of the second */
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

/* Can good frames be told as bodies? */
static inline bool fmb_bodies_are(const fmb_frame *p, const fmb_frame *q)
{
    return (p->dim == 2 || p->dim == 3) && p->naxes < FMB_BODY_MOST && q->naxes < FMB_BODY_MOST;
}
/* Of frames that can. Sets all but hulls. */
void fmb_bodies_init(const fmb_frame *p, const fmb_frame *q, fmb_bodies *out);
/* Are all numbers multiples of one power of two, and coordinates less than 2^16 of it? Vertices are
 * then what they are, and so is all that is made of three differences of them (less than 2^17) by
 * products and sums: that is less than 2^53. */
bool fmb_bodies_are_whole(const fmb_frame *p, const fmb_frame *q, const fmb_bodies *b);
/* Coordinate j of the world. */
double fmb_bodies_place(const fmb_bodies *b, const fmb_frame *p, int j, double x);

#endif
