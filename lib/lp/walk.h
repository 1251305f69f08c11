/* walk.h: once around the shadow of a polyhedron on a plane. */
#ifndef FMB_LP_WALK_H
#define FMB_LP_WALK_H

#include "lp/lp.h"

/* An edge of the shadow: normal[0] x + normal[1] y <= bound, with coprime integers in normal. */
typedef struct fmb_edge {
    mpz_t normal[2];
    mpq_t bound;
    fmb_weights
        w; /* multipliers >= 0 over the oracle's rows (any sign for equalities) that give it */
} fmb_edge;

typedef struct fmb_edges {
    fmb_edge *edge;
    size_t size, capacity;
} fmb_edges;

/* From a feasible dictionary: the edges of the shadow on x_i and x_j. *done false: the shadow is
 * not described, because some row is strict, or it has no inner points, or no vertex. */
fmb_status fmb_lp_walk(fmb_lp *lp, int i, int j, fmb_edges *out, bool *done);
void fmb_edges_clear(fmb_edges *list, fmb_mem *mem);

#endif
