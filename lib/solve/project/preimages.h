/* preimages.h: solutions that project to given points, and directions that project to directions.
 *
 * For each part of the system there is a program over the eliminated variables; a point of the
 * projection sets its right sides, and the oracle starts from its state for the previous point.
 */
#ifndef FMB_SOLVE_PREIMAGES_H
#define FMB_SOLVE_PREIMAGES_H

#include "num/integers.h"
#include "solve/query/solver.h"

typedef struct fmb_preimages fmb_preimages;

/* place[dim]: the column of a variable among the kept ones, -1 if it is eliminated; place and q
 * outlive *out. fmb_preimages_close it unless it is NULL, even after an error. Errors: MEMORY,
 * LIMIT, here and below. */
fmb_status fmb_preimages_open(fmb_query *q, const int *place, fmb_preimages **out);
void fmb_preimages_close(fmb_preimages *l);

/* A preimage x[dim] of the point y[k] / t, or of the direction y if t = 0; y holds t after its k
 * columns. strict (points only): strict rows must hold strictly; else < is read as <=. tight: some
 * row of the projection holds with equality there. *found false: there is no preimage. */
fmb_status fmb_preimages_find(fmb_preimages *l, const fmb_integers *y, bool strict, bool tight,
                              mpq_t *x, bool *found);

#endif
