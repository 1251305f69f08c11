/* gjk.h: two bodies: the nearest points, or vertices that show that they meet; guessed in doubles,
 * proved with an error bound.
 *
 * M is the set of the differences a - b (swept along the drift of the first body); the distance of
 * the bodies is that of 0 and M, and they have common inner points if 0 is inside a simplex of
 * vertices of M.
 *
 * By the errors of bodies.h, a vertex of M has an error of at most 25 u R in each coordinate, and
 * w x, for a vertex x of one body, 46 u R times the size of w: 36 from the vertex, 10 from the sum.
 *
 * Source: E. G. Gilbert, D. W. Johnson and S. S. Keerthi, A fast procedure for computing the
 * distance between complex objects in three-dimensional space, IEEE J. Robotics and Automation 4
 * (1988).
 */
#ifndef FMB_PAIR_CONTACT_GJK_H
#define FMB_PAIR_CONTACT_GJK_H

#include "pair/contact/bodies.h"

/* A vertex of M: the two vertices it comes from, and whether it is taken after the drift. */
typedef struct fmb_gjk_vertex {
    double x[3];
    int of[2];
    bool late;
} fmb_gjk_vertex;

typedef struct fmb_gjk {
    const fmb_bodies *b;
    bool whole;          /* fmb_bodies_are_whole */
    int n;               /* vertices of a simplex with the nearest point */
    fmb_gjk_vertex v[4]; /* these vertices, and the current one */
    double weight[4];    /* of that point; less than 0: 0 is inside the simplex */
    double x[3];         /* the point */
    /* A certain lower bound of the distance, in a direction of length 1 from the second body to the
     * first; at most 0 if unknown. It is the best bound of all directions tried: near 0 the
     * direction of the nearest point may be lost to rounding. */
    double apart, along[3];
} fmb_gjk;

/* The vertex of M that is farthest in the direction of -w. */
void fmb_gjk_support(const fmb_gjk *g, const double *w, fmb_gjk_vertex *out);
/* Find the nearest point of M, starting from a guess. Sets all but b, which is input. Stops once
 * the distance is known to exceed `enough`. */
void fmb_gjk_nearest(fmb_gjk *g, const double *guess, double enough);
/* The nearest points, moved back to time 0, and the time when they are nearest. */
void fmb_gjk_points(const fmb_gjk *g, double point[2][3], double *time);
/* A lower bound of the distance of 0 from the plane through three vertices (if dim is 2, from the
 * line through a and b; c is not used), on the side of the normal n: (b - a) x (c - a), or b - a
 * turned to the right. 0: not certain. The errors of the vertices are not included. */
double fmb_gjk_height(int dim, const double *a, const double *b, const double *c, double *n);
/* Is a ball of radius 64 u R around 0 certainly inside the simplex? Its vertices are reordered so
 * that its faces, listed in FMB_GJK_FACE, are oriented outward. */
bool fmb_gjk_is_inside(fmb_gjk *g);
/* For exact bodies (fmb_bodies_are_whole): has M a full-dimensional simplex with the current
 * vertices among its own, and 0 in it or on its boundary? Then its faces are oriented outward. */
bool fmb_gjk_surrounds(fmb_gjk *g);
/* [dim - 2][face] vertices of the dim + 1 faces of a simplex. */
extern const uint8_t FMB_GJK_FACE[2][4][3];

#endif
