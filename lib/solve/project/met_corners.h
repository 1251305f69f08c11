/* met_corners.h: which of the points met by the engines are corners of a projection. */
#ifndef FMB_SOLVE_MET_CORNERS_H
#define FMB_SOLVE_MET_CORNERS_H

#include "hull/image/image.h"
#include "solve/query/solver.h"

/* Set the rays and lines of m to those corners of the image's polyhedron that are in q->met: all of
 * its corners, if they span it. *found false: there are none, or they lack kept variables, and are
 * discarded. fmb_image_clear m, even after an error. Errors: MEMORY, LIMIT. */
fmb_status fmb_met_corners(fmb_query *q, const int *place, const fmb_system *image, fmb_image *m,
                           bool *found);

#endif
