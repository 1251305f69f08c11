/* plain_sat.h: separating axes in the plane as one would write them by hand: one pair at a time, in
 * doubles, without a bound on what rounding is off by. A measure of what certainty costs. */
#ifndef FMB_BENCH_PLAIN_SAT_H
#define FMB_BENCH_PLAIN_SAT_H

#include <fmb/frame.h>

/* Do two frames of the plane with two axes each, which stand still, meet? Touching counts. */
bool plain_sat_meet(const fmb_frame *a, const fmb_frame *b);

#endif
