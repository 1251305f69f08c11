/* some_rays.h: some rays of a cone, for use when a limit has ended the search for all rays. */
#ifndef FMB_SOLVE_SOME_RAYS_H
#define FMB_SOLVE_SOME_RAYS_H

#include "hull/image/image.h"
#include "solve/query/lifted.h"

/* Set *image to some extreme rays of {x : row.x >= 0 or = 0} and all lines; to nothing after a
 * cancel. The search takes the time set aside by fmb_run_reserve, or a fixed number of steps;
 * run->stop is unchanged. fmb_image_clear it, even after an error. Errors: MEMORY. */
fmb_status fmb_find_some_rays(fmb_run *run, const fmb_cone_row *row, size_t rows, size_t d,
                              fmb_image *image);

/* Find the facets of the image, which has a point, by several methods in turns; facets come without
 * slacks. Errors: MEMORY, LIMIT. */
fmb_status fmb_hull_find_facets(fmb_image *m);

/* Find all rays and lines by whichever method is cheaper, and put them into h->image; its supports
 * have no meaning. h is open. Errors: MEMORY, LIMIT. */
fmb_status fmb_lifted_find_rays(fmb_lifted *h);

#endif
