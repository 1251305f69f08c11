/* membership_private.h: the basis of a gauge, and walks from vertex to vertex; for the files of
 * membership.h.
 */
#ifndef FMB_LP_MEMBERSHIP_PRIVATE_H
#define FMB_LP_MEMBERSHIP_PRIVATE_H

#include "lp/redundancy/ray_shooting/membership.h"

/* Less is taken for the rounding error of 0: points are not longer than about 1, and w neither. */
#define FMB_GAUGE_ROUNDING 1e-9

/* ---- walls of the cube ----------------------------------------------------------------------- */

/* Wall 2 k is the point e_k / cube, wall 2 k + 1 its mirror image. */
#define FMB_GAUGE_WALLS (SIZE_MAX / 2)

static inline bool fmb_gauge_is_wall(size_t j)
{
    return j >= FMB_GAUGE_WALLS;
}

static inline double fmb_wall_coordinate(const fmb_gauge *g, size_t j)
{
    return ((j - FMB_GAUGE_WALLS) % 2 == 0 ? 1 : -1) / g->cube;
}

static inline size_t fmb_wall_axis(size_t j)
{
    return (j - FMB_GAUGE_WALLS) / 2;
}

/* ---- the basis ------------------------------------------------------------------------------- */

/* The corner of the cube on the side of q, or any. */
void fmb_gauge_start_from_cube(fmb_gauge *g, const double *q);
/* The inverse afresh; from the cube if the basis seems to be singular. */
void fmb_gauge_refresh(fmb_gauge *g);
/* reduced of points from, ... */
void fmb_gauge_reduce_points(fmb_gauge *g, size_t from);
/* entry = point j, written in the basis. */
void fmb_gauge_write(fmb_gauge *g, size_t j);
/* value = q, written in the basis. */
void fmb_gauge_find_values(fmb_gauge *g, const double *q);
/* along = row r of the inverse times each point. */
void fmb_gauge_price(fmb_gauge *g, size_t r);
/* Point j, just written, takes place r; along is the row that has just been priced, and gap is the
 * distance of w from the wall of j. */
void fmb_gauge_exchange(fmb_gauge *g, size_t r, size_t j, double gap);

/* ---- walks ----------------------------------------------------------------------------------- */

/* The dual method: up along edges for q. Errors: LIMIT, here and below; run may be NULL. */
fmb_status fmb_gauge_climb(fmb_gauge *g, const double *q, fmb_run *run, fmb_side_of_hull *out);
/* The primal method: back behind walls that w is beyond; *done false: it was stuck. */
fmb_status fmb_gauge_return(fmb_gauge *g, fmb_run *run, bool *done);

#endif
