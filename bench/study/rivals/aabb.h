/* aabb.h: boxes with sides along the axes of the world: of a frame for as long as it moves, what is
 * common to two of them, volumes, and whether one holds another. Plain doubles, as a broad phase
 * has them. A box is [dim][2]: lower end, upper end. */
#ifndef FMB_STUDY_AABB_H
#define FMB_STUDY_AABB_H

#include <fmb/frame.h>

/* The tightest that holds f at all times. */
void study_aabb_of(const fmb_frame *f, double *box);

/* What a and b have in common; an end below its other end if nothing. out may be one of them. */
void study_aabb_meet(int dim, const double *a, const double *b, double *out);

/* 0 if it is empty. */
double study_aabb_volume(int dim, const double *box);

/* Does outer, each side moved out by slack, hold inner? */
bool study_aabb_holds(int dim, const double *outer, const double *inner, double slack);

/* The largest absolute value of a coordinate that a frame reaches or is made of. */
double study_aabb_scale(const fmb_frame *f);

#endif
