/* whole_point.h: a common point of two frames that touch. */
#ifndef FMB_PAIR_KERNELS_WHOLE_POINT_H
#define FMB_PAIR_KERNELS_WHOLE_POINT_H

#include "pair/kernels/whole_pair.h"

/* Have these faces, of D - 1 vectors together, a common point? False: that is not known. */
bool fmb_whole_point_meet(const whole_pair *p, whole_faces faces);

#endif
