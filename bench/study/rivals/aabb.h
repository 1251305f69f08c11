/* aabb.h: axis-aligned bounding boxes: of a frame over its whole motion; intersections, volumes and
 * containment. Plain doubles, as in a broad phase. A box is [dim][2]: lower end, upper end. */
#ifndef FMB_STUDY_AABB_H
#define FMB_STUDY_AABB_H

#include <fmb/frame.h>

/* The smallest box that contains f at all times. */
void study_aabb_of(const fmb_frame *f, double *box);

/* The intersection of a and b; some upper end is below its lower end if it is empty. out may be a
 * or b. */
void study_aabb_meet(int dim, const double *a, const double *b, double *out);

/* 0 if it is empty. */
double study_aabb_volume(int dim, const double *box);

/* Does outer, each side moved out by slack, contain inner? */
bool study_aabb_holds(int dim, const double *outer, const double *inner, double slack);

/* The largest absolute value of a coordinate that a frame reaches or is made of. */
double study_aabb_scale(const fmb_frame *f);

#endif
