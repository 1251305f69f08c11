/* basis_inverse.h: a basis and its inverse: the edges that leave a corner.
 *
 * The rows w_0, ..., w_{n-1} of a basis meet in a point. Edge r, e_r, leaves it along the other
 * rows: w_r.e_r = 1, w_k.e_r = 0. The edges are the columns of the inverse, which is kept as such
 * where it is small, and else as factors (updated_lu.h).
 */
#ifndef FMB_LP_BASIS_INVERSE_H
#define FMB_LP_BASIS_INVERSE_H

#include "lp/linalg/doubles/updated_lu.h"

typedef struct fmb_corner {
    const fmb_reals *f;
    size_t n;
    bool has_inverse;
    size_t *member;  /* [n] the basis: rows, or FMB_UNIT + j */
    size_t *old;     /* [n] scratch */
    double *inverse; /* [n][n]: number j of edge r is inverse[j * n + r] */
    fmb_spread work; /* [n] scratch, zero between calls */
    fmb_triangles triangles;
    size_t exchanges; /* since all was computed afresh */
    bool failed;      /* memory ran out on the way: afresh, before anything else */
} fmb_corner;

/* Of unit vectors, with factors or as seems best. In any case fmb_corner_clear it. Errors: MEMORY,
 * LIMIT. */
fmb_status fmb_corner_init(fmb_corner *c, const fmb_reals *f, bool factors);
void fmb_corner_clear(fmb_corner *c);

/* Take these members, with unit vectors instead of those that depend on others; places may change.
 * entry is scratch. Errors: MEMORY, LIMIT. */
fmb_status fmb_corner_meet(fmb_corner *c, const size_t *member, fmb_spread *entry);
/* Member i, just written, takes place r, whose edge this is. Errors: MEMORY, LIMIT. */
fmb_status fmb_corner_replace(fmb_corner *c, size_t r, size_t i, const fmb_spread *entry,
                              const fmb_spread *edge);
/* Have errors gathered since it was computed afresh? */
bool fmb_corner_is_stale(const fmb_corner *c);

/* How much each edge changes member i: i as a combination of the basis. */
void fmb_corner_write(fmb_corner *c, size_t i, fmb_spread *entry);
/* y times the basis = cost[n]. */
void fmb_corner_price(fmb_corner *c, const double *cost, fmb_spread *y);
void fmb_corner_edge(fmb_corner *c, size_t r, fmb_spread *edge);
/* Where the members meet, with these right sides by place, right[n]. */
void fmb_corner_point(fmb_corner *c, const double *right, fmb_spread *x);

#endif
