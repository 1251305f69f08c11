/* generate_rays.h: all rays and lines of the cone over a system, by whichever way is cheap. */
#ifndef FMB_SOLVE_GENERATE_GENERATE_RAYS_H
#define FMB_SOLVE_GENERATE_GENERATE_RAYS_H

#include "solve/query/lifted.h"

/* h->image gets them; supports are of no meaning. h is open. Errors: MEMORY, LIMIT. */
fmb_status fmb_lifted_find_rays(fmb_lifted *h);

#endif
