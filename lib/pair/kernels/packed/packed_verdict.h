/* packed_verdict.h: blocks of packed frames decided by elimination; see pack.h. */
#ifndef FMB_PAIR_PACKED_VERDICT_H
#define FMB_PAIR_PACKED_VERDICT_H

#include "pair/kernels/packed/packed_flat.h"
#include "pair/kernels/verdict/verdict_cuboids.h"
#include "pair/kernels/verdict/verdict_simplices.h"

#define FMB_PACKED_SINGLE packed_single_3d

/* dim, moves, shapes, single and asked are constant. */
FMB_INLINE fmb_pair_bits packed_ask(int dim, bool moves, int shapes, bool single, fmb_asked asked,
                                    const fmb_flat_kind *kind, const double *block)
{
    const bool simplices = shapes == FMB_PACKED_SIMPLICES;
    if (shapes == FMB_PACKED_ANY)
        return packed_ask_any(kind, block);
    if (shapes == FMB_PACKED_CUBOIDS)
        return dim == 2 ? fmb_cuboids_2d(block, moves)
                        : fmb_cuboids_3d(block, moves, single, asked);
    return dim == 2 ? fmb_simplices_2d(block, moves, simplices)
                    : fmb_simplices_3d(block, moves, simplices, single, asked);
}

#endif
