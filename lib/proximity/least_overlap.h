/* least_overlap.h: the normal in whose direction two frames overlap least, exactly, in up to eight
 * dimensions.
 */
#ifndef FMB_PROXIMITY_LEAST_OVERLAP_H
#define FMB_PROXIMITY_LEAST_OVERLAP_H

#include <fmb/proximity.h>

#include "proximity/minkowski.h"
#include "proximity/overlap.h"

/* Are there normals for M, and not too many? */
bool fmb_has_normals(const fmb_minkowski *m);

void fmb_least_overlap_init(fmb_least_overlap *x);
void fmb_least_overlap_clear(fmb_least_overlap *x);
/* Less than 0: they are apart, and there may be less. More: M has an interior, and this is the
 * depth. If it is 0 then they touch, or M is flat and they may be apart. Errors: MEMORY, LIMIT. */
fmb_status fmb_find_least_overlap(fmb_minkowski *m, fmb_norm norm, fmb_run *run,
                                  fmb_least_overlap *out);

#endif
