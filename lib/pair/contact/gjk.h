/* gjk.h: two bodies: the nearest points, or vertices that show that they meet; guessed in doubles,
 * proved with an error bound.
 *
 * M is the set of the differences a - b (with all of them while the first drifts); the bodies are
 * apart by the distance from 0 to M, and have inner points in common if 0 is inside of a simplex of
 * its vertices.
 *
 * Errors are those of bodies.h: a vertex of M is off by 25 u R in each coordinate, and w x for a
 * vertex x of one body by 46 u R times the size of w: 36 for the vertex, 10 for the sum.
 *
 * Source: E. G. Gilbert, D. W. Johnson and S. S. Keerthi, A fast procedure for computing the
 * distance between complex objects in three-dimensional space, IEEE J. Robotics and Automation 4
 * (1988).
 */
#ifndef FMB_PAIR_CONTACT_GJK_H
#define FMB_PAIR_CONTACT_GJK_H

#include "pair/contact/bodies.h"

/* A vertex of M: of which vertices, and whether after the drift. */
typedef struct fmb_gjk_vertex {
    double x[3];
    int of[2];
    bool late;
} fmb_gjk_vertex;

typedef struct fmb_gjk {
    const fmb_bodies *b;
    bool whole;          /* that these are (bodies.h) */
    int n;               /* vertices of a simplex with the nearest point */
    fmb_gjk_vertex v[4]; /* and the one that is looked at */
    double weight[4];    /* of that point; less than 0: 0 is inside of the simplex */
    double x[3];         /* the point */
    /* The bodies certainly are so far apart in a direction of length 1, from the second to the
     * first; at most 0 where that is unknown. It is the best that was tried: near 0 that of the
     * point may have been lost to rounding. */
    double apart, along[3];
} fmb_gjk;

/* The vertex of M that is farthest in the direction of -w. */
void fmb_gjk_support(const fmb_gjk *g, const double *w, fmb_gjk_vertex *out);
/* From a guess of the nearest point of M. Sets all but b, which is given. No farther than to know
 * that they are more than `enough` apart. */
void fmb_gjk_nearest(fmb_gjk *g, const double *guess, double enough);
/* The nearest points at rest, and the time. */
void fmb_gjk_points(const fmb_gjk *g, double point[2][3], double *time);
/* The plane through three vertices, in the plane the line through a and b (c is not looked at), is
 * at least so far from 0, on the side of the normal that is given back: (b - a) x (c - a), or b - a
 * turned to the right. 0: that is not certain. What vertices are off by is left out. */
double fmb_gjk_height(int dim, const double *a, const double *b, const double *c, double *n);
/* Is a ball of radius 64 u R around 0 certainly inside the simplex? Its vertices are put in such an
 * order that its faces, as FMB_GJK_FACE tells them, look outward. */
bool fmb_gjk_is_inside(fmb_gjk *g);
/* Of bodies that are whole (bodies.h): has M a simplex of that dimension with the vertices at hand
 * among its own, and 0 in it or on its boundary? Its faces look outward then, too. */
bool fmb_gjk_surrounds(fmb_gjk *g);
/* [dim - 2][face]; there are dim + 1. */
extern const uint8_t FMB_GJK_FACE[2][4][3];

#endif
