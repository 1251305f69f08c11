/* preimages.h: solutions above points of a projection, and directions above its directions.
 *
 * For each part of the system there is a program over the variables that go; a point of the
 * projection tells its right sides, and the oracle goes on from the point before.
 */
#ifndef FMB_SOLVE_PREIMAGES_H
#define FMB_SOLVE_PREIMAGES_H

#include "num/integers.h"
#include "solve/query/solver.h"

typedef struct fmb_preimages fmb_preimages;

/* place[dim]: the column of a variable among those that are kept, -1 if it goes; place and q
 * outlive it. In any case fmb_preimages_close what is not NULL. Errors: MEMORY, LIMIT, here and
 * below.
 */
fmb_status fmb_preimages_open(fmb_query *q, const int *place, fmb_preimages **out);
void fmb_preimages_close(fmb_preimages *l);

/* x[dim]: above the point y[k] / t, or if t = 0 the direction y, where y holds t behind its k
 * columns. strict: points only, and < counts; else it is read as <=. tight: some row of the
 * projection holds with equality there. *found false: there is none. */
fmb_status fmb_preimages_find(fmb_preimages *l, const fmb_integers *y, bool strict, bool tight,
                              mpq_t *x, bool *found);

#endif
