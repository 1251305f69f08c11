/* ends.h: is a box right? Beside the exact one, whose ends were rounded outward. */
#ifndef FMB_STUDY_ENDS_H
#define FMB_STUDY_ENDS_H

#include <fmb/pair.h>

#include "study/draw/pairs.h"

/* The largest absolute coordinate of a corner of p or q at t = 0 or 1. */
double study_largest_coordinate(const fmb_frame *p, const fmb_frame *q);

/* What a witness may be off a common point, in every coordinate. */
double study_neighbourhood(const fmb_frame *p, const fmb_frame *q);

/* Faults (verdicts.h) of one pair's answers beside the exact ones; tightest: ends must be equal.
 * excess: the most by which an end lies farther out, over what counts as 1 there: the largest
 * coordinate for places, 1 for coordinates of a frame and times. */
unsigned study_box_faults(const fmb_frame *p, const fmb_frame *q, const fmb_pair_answers *ours,
                          const fmb_pair_answers *exact, bool tightest, double *excess);

/* Two frames of twice as many dimensions that meet iff p, q and the same neighbourhood do (below):
 * what is said of the system may be proved of them. False: both are simplices, or there is no room
 * for that. */
typedef struct study_witness_pair {
    fmb_frame frame[2];
    double number[2][STUDY_PAIR_MOST_DIM * (STUDY_PAIR_MOST_DIM + 2)];
} study_witness_pair;

bool study_witness_frames(const fmb_frame *p, const fmb_frame *q, const double *x,
                          study_witness_pair *out);

/* [give] The system of what p, q and the neighbourhood of x, as large as rounding, share; it has a
 * solution iff x is a common point, up to rounding. Errors: ARG, MEMORY. */
fmb_status study_witness_system(const fmb_frame *p, const fmb_frame *q, const double *x,
                                fmb_system **out);

#endif
