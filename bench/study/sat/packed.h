/* packed.h: blocks of packed frames decided by separating axes, in the loops of the library
 * (pair/kernels/packed/pack.h).
 */
#ifndef FMB_STUDY_SAT_PACKED_H
#define FMB_STUDY_SAT_PACKED_H

#include "pair/kernels/packed/packed_flat.h"
#include "study/sat/kernels.h"

/* dim, moves, shapes and asked are constant; there are no records of floats. */
FMB_INLINE fmb_pair_bits packed_ask(int dim, bool moves, int shapes, bool single, fmb_asked asked,
                                    const fmb_flat_kind *kind, const double *block)
{
    (void)single;
    const sat_kind k = {dim, moves, shapes == FMB_PACKED_SIMPLICES, shapes != FMB_PACKED_CUBOIDS};
    if (shapes == FMB_PACKED_ANY)
        return packed_ask_any(kind, block);
    return dim == 2 ? sat_decide_flat(k, block) : sat_decide(k, asked, block);
}

extern const fmb_packed FMB_PACKED_TABLE;

#endif
