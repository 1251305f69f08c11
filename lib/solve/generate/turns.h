/* turns.h: the facets of a hull, by ways that are tried in turns. */
#ifndef FMB_SOLVE_TURNS_H
#define FMB_SOLVE_TURNS_H

#include "hull/image/image.h"

/* The image has a point, and gets its facets, without slacks. Errors: MEMORY, LIMIT. */
fmb_status fmb_hull_find_facets(fmb_image *m);

#endif
