/* inverse.h: the numbers that a record in four to eight dimensions holds beyond those of the frame
 * (pair/kernels/minors_kernels.h).
 *
 * With V the exact inverse of the axes (of the matrix whose columns they are) and u = 2^-53, each
 * row r of the inverse W in a record has
 *
 *     sum over j of |W_rj - V_rj| <= 2 u reach_r,
 *     sum over j of |W_rj|, sum over j of |V_rj| <= reach_r,    2^-301 <= reach_r <= 2^334,
 *
 * and no number of the frame is greater than 2^300. Either whole and grain are 0, or grain is a
 * power of two of which all numbers of the frame are multiples, and whole V and whole / grain are
 * integers. The two units are the largest powers of two that divide all axes and the speed, and
 * that divide the origin.
 */
#ifndef FMB_PAIR_INVERSE_H
#define FMB_PAIR_INVERSE_H

#include <stdbool.h>

#include <fmb/frame.h>

/* Fill the record of f, a frame by edges with all its axes in four to eight dimensions. False: f is
 * flat, or so slender or large that no inverse is certain. */
bool fmb_inverse_record(const fmb_frame *f, double *record);

#endif
