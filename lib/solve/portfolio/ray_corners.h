/* ray_corners.h: corners and lines of a projection by double description, with solutions above
 * them, for proofs that no row is missing (solve/query/met_points.h).
 */
#ifndef FMB_SOLVE_RAY_CORNERS_H
#define FMB_SOLVE_RAY_CORNERS_H

#include "hull/image/image.h"
#include "solve/prepare/reduced_part.h"

/* The image of a cone, and what its coordinates are (project_rays.c). */
typedef struct fmb_ray_corners {
    fmb_reduced_part *of;
    fmb_image *image;
    size_t d;             /* coordinates of the cone, */
    size_t keeps;         /* of which so many stay */
    const size_t *column; /* [d - 1] columns of the part; then comes t */
    const size_t *keep;   /* [d] coordinates that stay, t last; then the others */
} fmb_ray_corners;

/* Where a proof is wanted: hand corners and lines over to the query, with what is above them; where
 * there is no memory for these, they stay behind. Errors: MEMORY, LIMIT. */
fmb_status fmb_ray_corners_hand_over(const fmb_ray_corners *h);

#endif
