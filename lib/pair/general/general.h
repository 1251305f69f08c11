/* general.h: pairs in any dimension, in doubles: guessed by linear programs, proved with an error
 * bound.
 */
#ifndef FMB_PAIR_GENERAL_H
#define FMB_PAIR_GENERAL_H

#include <fmb/pair.h>

#include "base/mem.h"

/* Workspace for one dimension. */
typedef struct fmb_general fmb_general;

/* [give] NULL without memory. The processor must have the instructions of simd. */
fmb_general *fmb_general_new(int dim, fmb_simd simd, fmb_mem *mem);
void fmb_general_free(fmb_general *g, fmb_mem *mem);

/* Do the frames meet? FEASIBLE: their relative interiors certainly have a common point; INFEASIBLE:
 * the closed frames certainly have none. Numbers are finite; nothing is allocated. */
fmb_verdict fmb_general_decide(fmb_general *g, const fmb_frame *p, const fmb_frame *q);

/* For frames that meet: all that out requests, except the verdict. Ends contain the exact ones, and
 * exceed them by at most 1e-12 (coordinates of q, times), or 1e-12 of the largest coordinate of a
 * corner of p or q at t = 0 or 1 (world). False, and nothing written, if that is not certain. */
bool fmb_general_answer(fmb_general *g, const fmb_frame *p, const fmb_frame *q,
                        const fmb_pair_answers *out);

#endif
