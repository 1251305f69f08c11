/* proximity_private.h: an answer about how near or how deep two frames are, and how it is filled
 * in. */
#ifndef FMB_PROXIMITY_PROXIMITY_PRIVATE_H
#define FMB_PROXIMITY_PROXIMITY_PRIVATE_H

#include <fmb/proximity.h>

#include "proximity/minkowski.h"

struct fmb_proximity {
    fmb_mem mem;
    int dim;
    fmb_norm norm;
    mpq_t measure; /* the length, or its square if the norm is Euclidean */
    mpq_t time;
    mpq_t *point[2]; /* [dim] of the first frame, of the second */
    mpq_t *shift;    /* [dim] */
};

/* [give] All zeros. Errors: MEMORY. */
fmb_status fmb_proximity_new(int dim, fmb_norm norm, const fmb_alloc *mem, fmb_proximity **out);

/* nearest.c: the point of M nearest to 0, as distance, points, shift and time. Errors: MEMORY,
 * LIMIT. */
fmb_status fmb_find_nearest(fmb_minkowski *m, fmb_run *run, fmb_proximity *out);

#endif
