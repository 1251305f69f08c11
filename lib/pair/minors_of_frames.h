/* minors_of_frames.h: pairs of frames in four to eight dimensions that are in no set, by the
 * kernels over records of sets: their records are made first.
 */
#ifndef FMB_PAIR_MINORS_OF_FRAMES_H
#define FMB_PAIR_MINORS_OF_FRAMES_H

#include "pair/kernels/minors_kernels.h"
#include "pair/single_pair.h"

/* Is there a kernel for pair i that may be sooner than doubles? Then *out is its kind. */
bool fmb_minors_of_frames_kind(const fmb_pair_call *a, size_t i, fmb_minors_what *out);

/* Is a kernel sooner to answer n pairs of such a kind? It takes as long for one pair as for as many
 * as there are lanes. */
bool fmb_minors_of_frames_pay(const fmb_pair_call *a, int n);

/* The verdicts on pairs pair[0 ... n - 1] of that kind, at most FMB_MINOR_PAIRS, as bits; *made:
 * the pairs whose frames have records, and so are good. */
fmb_pair_bits fmb_minors_of_frames(const fmb_pair_call *a, fmb_minors_what what, const size_t *pair,
                                   int n, unsigned *made);

#endif
