/* some_rays.h: some rays of a cone, where a limit has ended the search for all of them. */
#ifndef FMB_SOLVE_SOME_RAYS_H
#define FMB_SOLVE_SOME_RAYS_H

#include "hull/image/image.h"
#include "solve/query/lifted.h"

/* *image, new, gets rays of {x : row.x >= 0 or = 0}, each of them extreme, and all lines; after a
 * cancel nothing. The time that was kept for that (fmb_run_reserve) is used, or so many steps;
 * run->stop stays. In any case fmb_image_clear it. Errors: MEMORY. */
fmb_status fmb_find_some_rays(fmb_run *run, const fmb_cone_row *row, size_t rows, size_t d,
                              fmb_image *image);

/* By ways that are tried in turns: the image has a point, and gets its facets, without slacks.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_hull_find_facets(fmb_image *m);

/* All rays and lines, by whichever way is cheap: h->image gets them; supports are of no meaning. h
 * is open. Errors: MEMORY, LIMIT. */
fmb_status fmb_lifted_find_rays(fmb_lifted *h);

#endif
