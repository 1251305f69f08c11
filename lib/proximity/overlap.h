/* overlap.h: how far two frames overlap in the direction of a normal. */
#ifndef FMB_PROXIMITY_OVERLAP_H
#define FMB_PROXIMITY_OVERLAP_H

#include <gmp.h>
#include <stdbool.h>

enum { FMB_NORMALS_MOST_DIM = 8 };

/* M (minkowski.h) reaches from 0 in the direction of a normal n as far as overlap / size of n: its
 * length, or the sum of its coordinates without their signs. Numbers are whole; the size of the
 * Euclidean norm is a square. */
typedef struct fmb_least_overlap {
    bool found; /* else all normals are 0, and this one is at right angles to M, at overlap 0 */
    mpz_t normal[FMB_NORMALS_MOST_DIM], overlap, size;
} fmb_least_overlap;

#endif
