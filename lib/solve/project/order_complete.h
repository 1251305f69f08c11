/* order_complete.h: that a projection lacks no row, told by an order in which variables go. */
#ifndef FMB_SOLVE_ORDER_COMPLETE_H
#define FMB_SOLVE_ORDER_COMPLETE_H

#include "solve/query/solver.h"

/* A claim WHOLE more, which names the variables with place[dim] >= 0 and proves nothing yet.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_query_claim_whole(fmb_query *q, const int *place, fmb_claim **out);

/* image is the projection on the variables with place[dim] >= 0, and its claims are the last. Add a
 * claim WHOLE that tells the order, and claims FOLLOWS for rows that are left beside those of the
 * image: *done; or leave the claims as they were, if that takes more work (proof/elimination.h).
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_query_order_complete(fmb_query *q, const int *place, const fmb_system *image,
                                    uint64_t work, bool *done);

#endif
