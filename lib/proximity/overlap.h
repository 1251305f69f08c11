/* overlap.h: how far two frames overlap in the direction of a normal. */
#ifndef FMB_PROXIMITY_OVERLAP_H
#define FMB_PROXIMITY_OVERLAP_H

#include <gmp.h>
#include <stdbool.h>

enum { FMB_NORMALS_MOST_DIM = 8 };

/* M (minkowski.h) reaches from 0 to overlap / size along a normal, size being the norm of the
 * normal: its length, or the sum of the absolute values of its coordinates. All are integers; for
 * the Euclidean norm, `size` is the square of the length. */
typedef struct fmb_least_overlap {
    bool found; /* else no choice has a normal; this one is perpendicular to M, with overlap 0 */
    mpz_t normal[FMB_NORMALS_MOST_DIM], overlap, size;
} fmb_least_overlap;

#endif
