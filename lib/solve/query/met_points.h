/* met_points.h: points and directions of a projection that engines met while finding its rows.
 *
 * They are hints for the proof that no row is missing (project/completeness.h), which checks them:
 * corners of the projection are among them if an engine found its rows from corners, and for some
 * of them a preimage is known already.
 */
#ifndef FMB_SOLVE_MET_POINTS_H
#define FMB_SOLVE_MET_POINTS_H

#include "num/integers.h"
#include "num/vec.h"

typedef struct fmb_met_point {
    fmb_vec y;      /* [k + 1] kept columns of the part, then t: the point y / t, or with t = 0 a
                       direction; in lowest terms */
    fmb_integers x; /* [n + 1] a preimage, over x[n] unless that is 0; size 0: not known */
} fmb_met_point;

/* The points and directions of one part. */
typedef struct fmb_met_points {
    fmb_mem *mem;
    int part;
    size_t width; /* k + 1 */
    fmb_met_point *point;
    size_t size, capacity;
    bool sorted;
} fmb_met_points;

/* Begin anew, for that part: k of its columns are kept. */
void fmb_met_points_begin(fmb_met_points *m, fmb_mem *mem, int part, size_t k);
/* Allowed at any time. */
void fmb_met_points_clear(fmb_met_points *m);

/* Add a copy of y with its preimage x (NULL: not known); x is taken over even after an error. num
 * has k + 1 entries. Errors: MEMORY, LIMIT, and those of num->poll. */
fmb_status fmb_met_points_add(fmb_met_points *m, const fmb_vec *y, fmb_integers *x, fmb_num *num);
/* The point with this y, in lowest terms, if a preimage of it is known; else NULL. */
const fmb_met_point *fmb_met_points_find(fmb_met_points *m, const fmb_vec *y);

#endif
