/* minors_of_frames.h: pairs of frames in four to eight dimensions that are in no set, by the
 * kernels over records of sets: records of as many frames as there are lanes are made first.
 */
#ifndef FMB_PAIR_MINORS_OF_FRAMES_H
#define FMB_PAIR_MINORS_OF_FRAMES_H

#include "pair/kernels/minors_kernels.h"
#include "pair/single_pair.h"

/* Is a kernel sooner to answer n pairs of that dimension, four or more, than doubles, one pair
 * after another? It takes as long for one pair as for all lanes. */
bool fmb_minors_of_frames_pay(int dim, int n);

/* Is there a kernel for pair i that may pay? Then *out is its kind. */
bool fmb_minors_of_frames_kind(const fmb_pair_call *a, size_t i, fmb_minors_what *out);

/* The verdicts on pairs pair[0 ... n - 1] of that kind, at most as many as there are lanes, as
 * bits; *made: the pairs whose frames have records, and so are good. */
fmb_pair_bits fmb_minors_of_frames(const fmb_pair_call *a, fmb_minors_what what, const size_t *pair,
                                   int n, unsigned *made);

#endif
