/* angular_sort.h: vertices of a polygon in their order around it. */
#ifndef FMB_PROXIMITY_ANGULAR_SORT_H
#define FMB_PROXIMITY_ANGULAR_SORT_H

#include <fmb/generators.h>

#include "base/mem.h"

/* *g, vertices none of which is between others, may become another list of them: where they span a
 * plane, they follow each other around the polygon. Errors: MEMORY, LIMIT; *g is then as it was. */
fmb_status fmb_angular_sort(fmb_generators **g, fmb_mem *mem);

#endif
