/* ray_corners.h: the corners and lines that double description finds of a projection, with their
 * preimages, for proofs that no row is missing (solve/query/met_points.h).
 */
#ifndef FMB_SOLVE_RAY_CORNERS_H
#define FMB_SOLVE_RAY_CORNERS_H

#include "hull/image/image.h"
#include "solve/prepare/reduced_part.h"

/* The image of a cone, and what its coordinates are (project_rays.c). */
typedef struct fmb_ray_corners {
    fmb_reduced_part *of;
    fmb_image *image;
    size_t d;             /* coordinates of the cone */
    size_t keeps;         /* the number of kept ones among them */
    const size_t *column; /* [d - 1] columns of the part; then comes t */
    const size_t *keep;   /* [d] kept coordinates, the last is t; then the others */
} fmb_ray_corners;

/* If a proof is wanted, hand corners and lines over to the query, with their preimages; nothing is
 * handed over where numbers become too long. Errors: MEMORY, LIMIT. */
fmb_status fmb_ray_corners_hand_over(const fmb_ray_corners *h);

#endif
