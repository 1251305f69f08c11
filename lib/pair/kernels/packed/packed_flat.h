/* packed_flat.h: blocks of frames with any number of axes; see pack.h. */
#ifndef FMB_PAIR_PACKED_FLAT_H
#define FMB_PAIR_PACKED_FLAT_H

#include "pair/kernels/packed_kernels.h"
#include "pair/kernels/verdict/verdict_flat.h"

/* Not inlined into the loops over pairs, as it has its own loops over the kind. */
static FMB_NEVER_CLONED fmb_pair_bits packed_ask_any(const fmb_flat_kind *kind, const double *block)
{
    return kind->dim == 2 ? fmb_flat(2, kind, block) : fmb_flat(3, kind, block);
}

#endif
