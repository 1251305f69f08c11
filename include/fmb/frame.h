/* fmb/frame.h: cuboids and simplices in R^D, static or moving, and the systems whose solutions are
 * the common points of several of them.
 *
 * Source: Baillehache 2020 (FMB), whose system is the one in FMB_COORDINATES_LAST.
 */
#ifndef FMB_FRAME_H
#define FMB_FRAME_H

#include <fmb/system.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The shape of a frame, by the coordinates c of its points along its edges. */
typedef enum fmb_shape {
    FMB_CUBOID = 0, /* 0 <= c_i <= 1 */
    FMB_SIMPLEX,    /* 0 <= c_i, sum c_i <= 1 */
    /* The same shapes given by corners: row i of axes is the corner at the end of edge i, and the
     * edge is axes_i - origin, exactly. This difference of two doubles need not be a double, and
     * neighbours with rounded edges may come apart at a shared corner; by corners they meet. */
    FMB_CUBOID_BY_CORNERS,
    FMB_SIMPLEX_BY_CORNERS /* may have any number of corners: it is their convex hull, though its
                              coordinates c are then not unique */
} fmb_shape;

/* The most dimensions of a frame; a larger dim is refused before anything is read. */
enum { FMB_FRAME_MOST_DIM = 1000000 };

/* The points origin + sum c_i axes_i + t speed, 0 <= t <= 1. naxes < dim gives faces, edges and
 * points; a flat frame is legal. Arrays are borrowed. World length units; speed per unit of t. */
typedef struct fmb_frame {
    fmb_shape shape;
    int dim, naxes;       /* 0 <= naxes <= dim <= FMB_FRAME_MOST_DIM (SIMPLEX_BY_CORNERS: naxes <=
                             FMB_FRAME_MOST_DIM) */
    const double *origin; /* [dim] */
    const double *axes;   /* [naxes][dim], row i is edge i, or the corner at its end */
    const double *speed;  /* [dim], or NULL: static */
} fmb_frame;

/* Do the faces of a frame belong to it? */
typedef enum fmb_contact {
    FMB_CONTACT_CLOSED = 0, /* yes: touching is meeting */
    FMB_CONTACT_OPEN        /* no: only its relative interior, 0 < c_i (< 1, or sum c_i < 1). The
                               interval of time stays closed */
} fmb_contact;

/* The variables of a system. The time t follows them if any frame has a speed. */
typedef enum fmb_coordinates {
    FMB_COORDINATES_EACH = 0, /* c of every frame, bound by equalities; any frames */
    FMB_COORDINATES_WORLD,    /* the point itself: x1 ... xD */
    FMB_COORDINATES_LAST,     /* c of the last frame, whose axes may be anything */
    FMB_COORDINATES_ALL       /* the point, then c of every frame; any frames */
} fmb_coordinates;

/* [give] A system that has a solution iff the frames share a point at one time: exact, rows of the
 * frames in their order (lower ends, then upper ends), those of time at the end. A frame whose
 * coordinates are not variables needs linearly independent axes. Errors: ARG (no frame, an invalid
 * dim, naxes or shape, an array that is NULL, different dim, dependent axes, a number that is not
 * finite, more variables than a system can have), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_from_frames(const fmb_frame *f, size_t n,
                                                      fmb_coordinates in, fmb_contact contact,
                                                      const fmb_alloc *mem, fmb_system **out);

#ifdef __cplusplus
}
#endif
#endif
