/* shadow.h: the shadow of a polyhedron on a line or a plane. */
#ifndef FMB_HULL_SHADOW_H
#define FMB_HULL_SHADOW_H

#include "lp/dictionary/dictionary.h"
#include "num/weights.h"

/* An edge of the shadow: normal[0] x + normal[1] y <= bound, with coprime integers in normal. */
typedef struct fmb_edge {
    mpz_t normal[2];
    mpq_t bound;
    fmb_weights w; /* that give it, over the oracle's rows: >= 0, any sign for equalities */
} fmb_edge;

typedef struct fmb_edges {
    fmb_edge *edge;
    size_t size, capacity;
} fmb_edges;

/* From a feasible dictionary: the ends of the interval of x_i, as edges of normal (1, 0) and
 * (-1, 0). *done false: they are one point, or open. */
fmb_status fmb_shadow_interval(fmb_lp *lp, int i, fmb_edges *out, bool *done);
/* shadow_walk.c: the edges of the shadow on x_i and x_j. *done false: it is not described, because
 * some row is strict, or it has no inner points, or no vertex. */
fmb_status fmb_shadow_polygon(fmb_lp *lp, int i, int j, fmb_edges *out, bool *done);

/* An edge more, all 0. */
fmb_status fmb_edges_add(fmb_edges *list, fmb_mem *mem, fmb_edge **out);
void fmb_edges_clear(fmb_edges *list, fmb_mem *mem);

#endif
