/* membership_private.h: the basis of a membership program, and walks from vertex to vertex; for the
 * files of membership.h.
 */
#ifndef FMB_LP_MEMBERSHIP_PRIVATE_H
#define FMB_LP_MEMBERSHIP_PRIVATE_H

#include "lp/redundancy/ray_shooting/membership.h"

/* Less is taken for the rounding error of 0: points are not longer than about 1, and w neither. */
#define FMB_MEMBERSHIP_ROUNDING 1e-9

/* ---- artificial points, of the cube ---------------------------------------------------------- */

/* Artificial point 2 k is e_k / cube, point 2 k + 1 its mirror image. */
#define FMB_MEMBERSHIP_ARTIFICIALS (SIZE_MAX / 2)

static inline bool fmb_membership_is_artificial(size_t j)
{
    return j >= FMB_MEMBERSHIP_ARTIFICIALS;
}

static inline double fmb_membership_artificial_coordinate(const fmb_membership *g, size_t j)
{
    return ((j - FMB_MEMBERSHIP_ARTIFICIALS) % 2 == 0 ? 1 : -1) / g->cube;
}

static inline size_t fmb_membership_artificial_axis(size_t j)
{
    return (j - FMB_MEMBERSHIP_ARTIFICIALS) / 2;
}

/* ---- the basis ------------------------------------------------------------------------------- */

/* The corner of the cube on the side of q, or any. */
void fmb_membership_start_from_cube(fmb_membership *g, const double *q);
/* The inverse afresh; from the cube if the basis seems to be singular. */
void fmb_membership_refresh(fmb_membership *g);
/* reduced of points from, ... */
void fmb_membership_reduce_points(fmb_membership *g, size_t from);
/* entry = point j, written in the basis. */
void fmb_membership_write(fmb_membership *g, size_t j);
/* value = q, written in the basis. */
void fmb_membership_find_values(fmb_membership *g, const double *q);
/* along = row r of the inverse times each point. */
void fmb_membership_price(fmb_membership *g, size_t r);
/* Point j, just written, takes place r; along is the row that has just been priced, and gap is the
 * distance of w from the hyperplane of j. */
void fmb_membership_pivot(fmb_membership *g, size_t r, size_t j, double gap);

/* ---- walks ----------------------------------------------------------------------------------- */

/* The dual method: up along edges for q. Errors: LIMIT, here and below; run may be NULL. */
fmb_status fmb_membership_run_dual(fmb_membership *g, const double *q, fmb_run *run,
                                   fmb_side_of_hull *out);
/* The primal method: back behind hyperplanes that w is beyond; *done false: it was stuck. */
fmb_status fmb_membership_run_primal(fmb_membership *g, fmb_run *run, bool *done);

#endif
