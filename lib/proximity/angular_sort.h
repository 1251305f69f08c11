/* angular_sort.h: vertices of a polygon in their order around it. */
#ifndef FMB_PROXIMITY_ANGULAR_SORT_H
#define FMB_PROXIMITY_ANGULAR_SORT_H

#include <fmb/generators.h>

#include "base/mem.h"

/* *g, the vertices of a convex set, may be replaced by a list of the same: if they span a plane,
 * they are in their order around the polygon. Errors: MEMORY, LIMIT; *g is then unchanged. */
fmb_status fmb_angular_sort(fmb_generators **g, fmb_mem *mem);

#endif
