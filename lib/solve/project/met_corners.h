/* met_corners.h: which of the points that were met are corners of a projection. */
#ifndef FMB_SOLVE_MET_CORNERS_H
#define FMB_SOLVE_MET_CORNERS_H

#include "hull/image/image.h"
#include "solve/query/solver.h"

/* m gets the corners of what the rows of the image allow as its rays and lines, as far as they were
 * met (q->met): all of them, if they span it. *found false: there are none, or they are not of all
 * kept variables, and then forgotten. In any case fmb_image_clear m. Errors:
 * MEMORY, LIMIT. */
fmb_status fmb_met_corners(fmb_query *q, const int *place, const fmb_system *image, fmb_image *m,
                           bool *found);

#endif
