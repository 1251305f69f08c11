/* pair_portfolio.h: the ways to an answer, one after another.
 *
 * Kernels (two and three dimensions, all axes), the general way in doubles, the exact query. Pairs
 * for the kernels wait in blocks, one for each kind, until a block is full; the rest is answered at
 * once.
 */
#ifndef FMB_PAIR_PAIR_PORTFOLIO_H
#define FMB_PAIR_PAIR_PORTFOLIO_H

#include "pair/pair_private.h"

/* Answer all pairs, of whose frames that is known; after a cancel, those that are left are UNKNOWN.
 * Errors: ARG, with k->error set, MEMORY. */
fmb_status fmb_pair_answer_all(fmb_pair *k, size_t n, const fmb_frame *p, const fmb_frame *q,
                               fmb_pair_known known, const fmb_pair_answers *out);

#endif
