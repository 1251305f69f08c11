/* packed_flat.h: blocks of frames with any number of axes; see pack.h. */
#ifndef FMB_PAIR_PACKED_FLAT_H
#define FMB_PAIR_PACKED_FLAT_H

#include "pair/kernels/packed_kernels.h"
#include "pair/kernels/verdict/verdict_flat.h"

/* Not inlined into the loops over pairs, as it has its own loops over the kind. */
#define PACKED_APART static __attribute__((noinline))

PACKED_APART fmb_pair_bits packed_ask_any_2d(const fmb_flat_kind *kind, const double *block)
{
    return fmb_flat(2, kind, block);
}

PACKED_APART fmb_pair_bits packed_ask_any_3d(const fmb_flat_kind *kind, const double *block)
{
    return fmb_flat(3, kind, block);
}

#endif
