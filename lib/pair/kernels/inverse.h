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
 * that divide the origin. Inverse, reach and size are filled in by kernels (minors_inverse.h).
 */
#ifndef FMB_PAIR_INVERSE_H
#define FMB_PAIR_INVERSE_H

#include <fmb/frame.h>

#include "pair/kernels/minors_kernels.h"

/* Write origin, axes and speed of f, a frame by edges with all its axes in four to eight
 * dimensions, and zeros. */
void fmb_inverse_write_frame(const fmb_frame *f, double *record);
/* Write the units of a record of a frame, and that it has no integers (whole). */
void fmb_inverse_write_units(int dim, double *record);
/* Write units, whole and grain of a record that fmb_minor_kernels.invert has filled in. */
void fmb_inverse_write_integers(int dim, double *record);

#endif
