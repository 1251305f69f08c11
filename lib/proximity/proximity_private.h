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
    mpq_t *normal;   /* [dim] away from the first, of any length; all 0 if they touch and apart was
                        asked */
};

/* An answer about M, given all zeros. Errors: MEMORY. */
typedef fmb_status fmb_proximity_way(fmb_solver *v, fmb_minkowski *m, fmb_proximity *out,
                                     fmb_result *res);
/* [give] The result of a public verb; without `apart` there is one only for frames that meet.
 * Errors: ARG, MEMORY. */
fmb_status fmb_proximity_find(fmb_solver *v, const fmb_two *two, fmb_norm norm, bool apart,
                              fmb_proximity_way *way, fmb_proximity **out, fmb_result *res);

/* Like fmb_proximity_way, but run as a query with this name, about a system without rows. Errors:
 * MEMORY, LIMIT.
 */
typedef fmb_status fmb_proximity_answer(fmb_minkowski *m, fmb_run *run, fmb_proximity *out,
                                        fmb_verdict *verdict);
fmb_status fmb_proximity_ask(fmb_solver *v, fmb_minkowski *m, const char *name,
                             fmb_proximity_answer *answer, fmb_proximity *out, fmb_result *res);

/* nearest.c: the point of M nearest to 0, as distance, points, shift and time; out may be NULL. */
fmb_proximity_answer fmb_find_nearest;

#endif
