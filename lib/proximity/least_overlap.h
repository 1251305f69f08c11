/* least_overlap.h: the normal in whose direction two frames overlap least, exactly, in up to eight
 * dimensions.
 */
#ifndef FMB_PROXIMITY_LEAST_OVERLAP_H
#define FMB_PROXIMITY_LEAST_OVERLAP_H

#include <fmb/proximity.h>

#include "proximity/minkowski.h"
#include "proximity/overlap.h"

/* Does fmb_find_least_overlap apply: at most eight dimensions, no frame with more axes? */
bool fmb_has_normals(const fmb_minkowski *m);

void fmb_least_overlap_init(fmb_least_overlap *x);
void fmb_least_overlap_clear(fmb_least_overlap *x);
/* Overlap < 0: the frames are apart, and another normal may have less. > 0: M has an interior, and
 * this is the depth. 0: they touch, or M is flat and they may be apart. Errors: MEMORY, LIMIT. */
fmb_status fmb_find_least_overlap(fmb_minkowski *m, fmb_norm norm, fmb_run *run,
                                  fmb_least_overlap *out);

#endif
