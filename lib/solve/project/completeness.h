/* completeness.h: evidence that a projection lacks no row. */
#ifndef FMB_SOLVE_PROJECT_COMPLETENESS_H
#define FMB_SOLVE_PROJECT_COMPLETENESS_H

#include "solve/query/solver.h"

/* image is the projection on the variables with place[dim] >= 0, their columns, and its rows have
 * their claims. Add claims CORNER and a claim WHOLE, if that does not take too long; within the
 * limits of the query, which is not stopped by them. Errors: MEMORY. */
fmb_status fmb_query_prove_complete(fmb_query *q, const int *place, const fmb_system *image);

#endif
