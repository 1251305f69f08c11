/* pair_portfolio.h: the methods for pairs, tried one after another.
 *
 * Kernels (two and three dimensions, all axes), the general method in doubles, the exact query.
 * Pairs for kernels are collected in blocks, one for each kind, until a block is full; other pairs
 * are answered at once.
 */
#ifndef FMB_PAIR_PAIR_PORTFOLIO_H
#define FMB_PAIR_PAIR_PORTFOLIO_H

#include "pair/pair_private.h"

/* Answer all pairs; known: of all their frames. After a cancel, the remaining pairs are UNKNOWN.
 * Errors: ARG, with k->error set, MEMORY. */
fmb_status fmb_pair_answer_all(fmb_pair *k, size_t n, const fmb_frame *p, const fmb_frame *q,
                               fmb_pair_known known, const fmb_pair_answers *out);

#endif
