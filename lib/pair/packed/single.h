/* single.h: records in the plane and in space, rounded to floats: half the bytes, which decide how
 * fast pairs by index are where sets are larger than the caches.
 */
#ifndef FMB_PAIR_SINGLE_H
#define FMB_PAIR_SINGLE_H

#include "pair/packed/set.h"

/* Round record i of s. A number that is too large or too small for a normal float becomes a NaN, so
 * kernels leave its frame open. */
void fmb_single_add(fmb_frames *s, size_t i);

#endif
