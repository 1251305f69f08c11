/* whole_point.h: a point of both frames of a pair that touch. */
#ifndef FMB_PAIR_KERNELS_WHOLE_POINT_H
#define FMB_PAIR_KERNELS_WHOLE_POINT_H

#include "pair/kernels/whole_pair.h"

/* Is there a point of both in these faces, of D - 1 vectors? False: that is not known. */
bool fmb_whole_point_meet(const whole_pair *p, whole_faces faces);

#endif
