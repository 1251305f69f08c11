/* fmb/proximity.h: for two frames that meet: all common points, and the depth; for two that do not:
 * the distance, and a separating row. Everything is exact, in any dimension, and computed only on
 * request: verdicts (<fmb/pair.h>) do not wait for it.
 *
 * f is always an array of two frames of one dimension, at least 1; they are closed unless there is
 * a parameter contact. If one of them moves, answers are about all times from 0 to 1 together.
 * Numbers are handed out as the doubles nearest to them, and exactly by <fmb/gmp.h>, which also
 * takes frames in rationals. *out is NULL if there is nothing to hand out, and at a limit, which
 * res->stop reports.
 *
 * Sources: Wolfe, Finding the nearest point in a polytope, Mathematical Programming 11 (1976);
 * Cameron and Culley, Determining the minimum translational distance between two convex polyhedra,
 * IEEE Conf. Robotics and Automation 1986.
 */
#ifndef FMB_PROXIMITY_H
#define FMB_PROXIMITY_H

#include <fmb/frame.h>
#include <fmb/generators.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The norm of a vector. */
typedef enum fmb_norm {
    FMB_NORM_EUCLIDEAN = 0,
    FMB_NORM_MAX /* its largest coordinate, without sign */
} fmb_norm;

/* A distance or a depth, with its translation and points. */
typedef struct fmb_proximity fmb_proximity;

/* [give] The distance of the frames, and two nearest points; the verdict is FEASIBLE if they meet,
 * and the distance then 0. The plane perpendicular to the shift (Euclidean) proves it. Errors: ARG,
 * MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_distance(fmb_solver *v, const fmb_frame *f, fmb_norm norm,
                                            fmb_proximity **out, fmb_result *res);

/* [give] Their penetration depth: the length of the shortest translation of the second after which
 * they at most touch; 0 if they only touch. *out is NULL, and the verdict INFEASIBLE, if they are
 * apart. In up to eight dimensions, for frames with no more axes than that, normals are enumerated
 * (20 us in space, a few ms in eight dimensions, more for simplices); else a system of all
 * coordinates is projected, so set a limit in high dimensions. Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_depth(fmb_solver *v, const fmb_frame *f, fmb_norm norm,
                                         fmb_proximity **out, fmb_result *res);

/* NULL is fine. */
FMB_API void fmb_proximity_free(fmb_proximity *p);

/* All of these are 0 for NULL, and for a coordinate out of range. */
/* Dimension of the frames. */
FMB_API int fmb_proximity_dim(const fmb_proximity *p);
/* The distance or the depth [world length units]. */
FMB_API double fmb_proximity_length(const fmb_proximity *p);
/* Coordinate j of the translation of the second frame, of that length, after which they touch. */
FMB_API double fmb_proximity_shift(const fmb_proximity *p, int j);
/* For a distance: coordinate j of the nearest point of the first (which = 0) or second frame (1),
 * and the time when they are that near. */
FMB_API double fmb_proximity_point(const fmb_proximity *p, int which, int j);
FMB_API double fmb_proximity_time(const fmb_proximity *p);
/* These numbers as exact text (<fmb/base.h>): the length, for the Euclidean norm its square; and
 * the rest. */
FMB_API size_t fmb_proximity_measure_text(const fmb_proximity *p, char *text, size_t size);
FMB_API size_t fmb_proximity_shift_text(const fmb_proximity *p, int j, char *text, size_t size);
FMB_API size_t fmb_proximity_point_text(const fmb_proximity *p, int which, int j, char *text,
                                        size_t size);
FMB_API size_t fmb_proximity_time_text(const fmb_proximity *p, char *text, size_t size);

/* [give] A row a.x <= b over x1, x2, ... and, if something moves, t: the first frame satisfies it,
 * the second a.x >= b, and fmb_separates accepts it. *out is NULL if they meet. Errors: ARG,
 * MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_separate(fmb_solver *v, const fmb_frame *f, fmb_contact contact,
                                            fmb_system **out, fmb_result *res);

/* Does the only row of that system prove that the frames have no common point? The first must lie
 * on the side of <= at all times, the second on the other, and not both in the plane. This is
 * decided by evaluating corners only. False for invalid arguments, such as arrays of frames that
 * are NULL; the numbers in the frames must be valid. */
FMB_API bool fmb_separates(const fmb_frame *f, fmb_contact contact, const fmb_system *row);

/* [give] The common points: vertices of a point, segment, polygon (in order around it) or polytope,
 * over x1, x2, ... and, if something moves, t. If there are none, the verdict is INFEASIBLE, and
 * *out NULL. Errors: ARG, MEMORY.
 */
FMB_API FMB_CHECKED fmb_status fmb_common(fmb_solver *v, const fmb_frame *f, fmb_generators **out,
                                          fmb_result *res);

#ifdef __cplusplus
}
#endif
#endif
