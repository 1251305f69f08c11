/* met_points.h: points and directions of a projection that were met on the way to its rows.
 *
 * They are hints for whoever proves that no row is missing (project/completeness.h), and stand or
 * fall by that: corners of the projection are among them where an engine went by these, and above
 * some of them a solution is known already.
 */
#ifndef FMB_SOLVE_MET_POINTS_H
#define FMB_SOLVE_MET_POINTS_H

#include "num/integers.h"
#include "num/vec.h"

typedef struct fmb_met_point {
    fmb_vec y;      /* [k + 1] kept columns of the part, then t: the point y / t, or with t = 0 a
                       direction; in lowest terms */
    fmb_integers x; /* [n + 1] above it, over x[n] unless that is 0; size 0: not known */
} fmb_met_point;

/* Those of one part. */
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
/* At any time. */
void fmb_met_points_clear(fmb_met_points *m);

/* Add y, which is copied, with what lies above it (NULL: not known), which is taken over in any
 * case. num is one of k + 1 entries. Errors: MEMORY, LIMIT, what num->poll says. */
fmb_status fmb_met_points_add(fmb_met_points *m, const fmb_vec *y, fmb_integers *x, fmb_num *num);
/* That with this y, in lowest terms, if something above it is known; or NULL. */
const fmb_met_point *fmb_met_points_find(fmb_met_points *m, const fmb_vec *y);

#endif
