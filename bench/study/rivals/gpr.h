/* gpr.h: do two tetrahedra meet? By separating planes, found in coordinates of the faces.
 *
 * Doubles, without tolerance: near touching it may be wrong. For studies.
 *
 * Source: Ganovelli, Ponchio, Rocchini 2002.
 */
#ifndef FMB_STUDY_GPR_H
#define FMB_STUDY_GPR_H

#include <fmb/frame.h>

/* p and q: simplices with three axes in three dimensions, neither flat. Touching is meeting. */
bool study_gpr_meet(const fmb_frame *p, const fmb_frame *q);

#endif
