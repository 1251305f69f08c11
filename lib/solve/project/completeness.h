/* completeness.h: evidence that a projection lacks no row. */
#ifndef FMB_SOLVE_PROJECT_COMPLETENESS_H
#define FMB_SOLVE_PROJECT_COMPLETENESS_H

#include "solve/query/solver.h"

/* image is the projection on the variables with place[dim] >= 0, their columns, and its rows have
 * claims. Add claims CORNER and a claim WHOLE, unless that takes too long. A limit reached here
 * only omits them and does not stop the query. Errors: MEMORY. */
fmb_status fmb_query_prove_complete(fmb_query *q, const int *place, const fmb_system *image);

#endif
