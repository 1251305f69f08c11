/* minkowski.h: the Minkowski difference of two frames, the points p - q that they have at one time:
 *
 *     M = P - Q + [0, 1] (speed of P - speed of Q),
 *
 * a polytope. The frames meet iff 0 is in M; its point nearest to 0 tells how far they are apart,
 * and its facets how deep they are in each other.
 *
 * Source: S. Cameron and R. Culley, Determining the minimum translational distance between two
 * convex polyhedra, IEEE Conf. Robotics and Automation 1986.
 */
#ifndef FMB_PROXIMITY_MINKOWSKI_H
#define FMB_PROXIMITY_MINKOWSKI_H

#include "proximity/two.h"

/* A frame at rest: origin, edges, speed (zeros if it stands). */
typedef struct fmb_minkowski_frame {
    fmb_shape shape; /* cuboid or simplex */
    int naxes;
    mpz_t *row; /* [naxes + 2][dim] */
} fmb_minkowski_frame;

/* All numbers are integers: true values times unit. */
typedef struct fmb_minkowski {
    fmb_mem *mem;
    int dim;
    bool moves;
    mpz_t unit;
    fmb_minkowski_frame frame[2];
    mpz_t *cell; /* [cells] all rows */
    size_t cells;
    mpz_t *drift; /* [dim] */
    mpz_t t[4];   /* scratch */
} fmb_minkowski;

/* The caller must call fmb_minkowski_clear even after an error. Errors: MEMORY. */
fmb_status fmb_minkowski_init(fmb_minkowski *m, const fmb_two *two, fmb_mem *mem);
void fmb_minkowski_clear(fmb_minkowski *m);

/* Divide coordinate j of all rows by 2^by[j], the largest power of 2 that divides them. This does
 * not change whether 0 is in M; distances and normals become those in scaled coordinates. */
void fmb_minkowski_shorten(fmb_minkowski *m, mp_bitcnt_t *by);

/* A vertex of M, as [FMB_VERTEX_ROWS][dim] numbers: itself, the points at rest of P and of Q that
 * it comes from, and the time (0 or 1) in the first place of the last row. */
enum { FMB_VERTEX_ROWS = 4 };
/* The vertex of M where w is least. */
void fmb_minkowski_lowest(fmb_minkowski *m, mpz_t *w, mpz_t *vertex);

/* [give] M as the projection of a system on its first dim variables: the others are the coordinates
 * in P, in Q, and t if something moves. Errors: MEMORY. */
fmb_status fmb_minkowski_system(fmb_minkowski *m, const fmb_alloc *mem, fmb_system **out);

/* out = a.b, [dim] each. */
void fmb_minkowski_dot(const fmb_minkowski *m, mpz_t *a, mpz_t *b, mpz_t out);

#endif
