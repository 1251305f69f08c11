/* order_complete.h: proof that a projection lacks no row, by an order of elimination. */
#ifndef FMB_SOLVE_ORDER_COMPLETE_H
#define FMB_SOLVE_ORDER_COMPLETE_H

#include "solve/query/solver.h"

/* Append a claim WHOLE that names the variables with place[dim] >= 0 and proves nothing yet.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_query_claim_whole(fmb_query *q, const int *place, fmb_claim **out);

/* image is the projection on the variables with place[dim] >= 0, and its claims are the last. Add a
 * claim WHOLE that holds the order, and a claim FOLLOWS for each remaining row that is not in the
 * image; *done false: that takes more than `work` (proof/elimination.h), and the claims are as they
 * were. Errors: MEMORY, LIMIT. */
fmb_status fmb_query_order_complete(fmb_query *q, const int *place, const fmb_system *image,
                                    uint64_t work, bool *done);

#endif
