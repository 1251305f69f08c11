/* enumerate.h: distance, depth and common points of two frames by brute force, in integers: all
 * planes through corners of the Minkowski difference, all sets of corners, all points where as many
 * rows meet as there are coordinates. It shares nothing with the library. Origins up to 128 and
 * edges and speeds up to 32, without sign, overflow nowhere.
 */
#ifndef FMB_TEST_ENUMERATE_H
#define FMB_TEST_ENUMERATE_H

#include <stdbool.h>

enum {
    ENUMERATE_MOST_DIM = 3,
    ENUMERATE_MOST_CORNERS = 2 * 8 * 8,
    ENUMERATE_MOST_PLANES = 512,
    ENUMERATE_MOST_POINTS = 256
};

__extension__ typedef __int128 wide;

/* A frame by edges; it stands still if all speeds are 0. */
typedef struct solid {
    int dim, naxes;
    bool cuboid;
    long origin[3], edge[3][3], speed[3];
} solid;

/* n.m <= c for all points m of the difference; equal for at least D corners. */
typedef struct plane {
    long n[3], c;
} plane;

/* All differences of a point of one and one of another at one time: their hull. */
typedef struct minkowski {
    int dim, corners, planes;
    bool flat; /* in a plane, in which case it and its opposite are the planes */
    long corner[ENUMERATE_MOST_CORNERS][3];
    plane plane[ENUMERATE_MOST_PLANES];
} minkowski;

typedef struct fraction {
    wide p, q; /* q > 0 */
} fraction;

int compare_fractions(fraction x, fraction y);

void enumerate_difference(const solid *a, const solid *b, minkowski *out);
/* Squares of the Euclidean distance from 0 to the difference, or of the depth of 0 within it. */
fraction enumerate_distance_square(const minkowski *m);
fraction enumerate_depth_square(const minkowski *m);
/* By the largest coordinate. */
fraction enumerate_distance_max(const minkowski *m);
fraction enumerate_depth_max(const minkowski *m);

/* Points p[0 ... dim - 1] / q, and then the time if something moves. */
typedef struct common_points {
    int dim, n;
    wide p[ENUMERATE_MOST_POINTS][4], q[ENUMERATE_MOST_POINTS];
} common_points;

/* All vertices of what two frames have in common; false if edges of one depend on each other. */
bool enumerate_common(const solid *a, const solid *b, common_points *out);

#endif
