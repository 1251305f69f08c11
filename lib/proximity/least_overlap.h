/* least_overlap.h: the normal in whose direction two frames overlap least, exactly, in up to eight
 * dimensions.
 */
#ifndef FMB_PROXIMITY_LEAST_OVERLAP_H
#define FMB_PROXIMITY_LEAST_OVERLAP_H

#include <fmb/proximity.h>

#include "proximity/minkowski.h"

enum { FMB_NORMALS_MOST_DIM = 8 };

/* M (minkowski.h) reaches from 0 in the direction of a normal n as far as overlap / size of n: its
 * length, or the sum of its coordinates without their signs. Numbers are whole; the size of the
 * Euclidean norm is a square. */
typedef struct fmb_least_overlap {
    bool found; /* else all normals are 0, and this one is at right angles to M, at overlap 0 */
    mpz_t normal[FMB_NORMALS_MOST_DIM], overlap, size;
} fmb_least_overlap;

/* Are there normals for M, and not too many? */
bool fmb_has_normals(const fmb_minkowski *m);

void fmb_least_overlap_init(fmb_least_overlap *x);
void fmb_least_overlap_clear(fmb_least_overlap *x);
/* Less than 0: they are apart, and there may be less. More: M has an interior, and this is the
 * depth. If it is 0 then they touch, or M is flat and they may be apart. Errors: MEMORY, LIMIT. */
fmb_status fmb_find_least_overlap(fmb_minkowski *m, fmb_norm norm, fmb_run *run,
                                  fmb_least_overlap *out);

#endif
