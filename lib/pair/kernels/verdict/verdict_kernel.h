/* verdict_kernel.h: verdicts by Fourier-Motzkin elimination. */
#ifndef FMB_PAIR_VERDICT_KERNEL_H
#define FMB_PAIR_VERDICT_KERNEL_H

#include "pair/kernels/verdict/verdict_cuboids.h"
#include "pair/kernels/verdict/verdict_simplices.h"

#define FMB_VERDICT_KERNEL(name, bits)                                                             \
    static fmb_pair_bits name(const double *block)                                                 \
    {                                                                                              \
        return bits;                                                                               \
    }

FMB_VERDICT_KERNEL(fmb_2d_cc, fmb_cuboids_2d(block, false))
FMB_VERDICT_KERNEL(fmb_2d_ct, fmb_simplices_2d(block, false, false))
FMB_VERDICT_KERNEL(fmb_2d_tt, fmb_simplices_2d(block, false, true))
FMB_VERDICT_KERNEL(fmb_2d_moving_cc, fmb_cuboids_2d(block, true))
FMB_VERDICT_KERNEL(fmb_2d_moving_ct, fmb_simplices_2d(block, true, false))
FMB_VERDICT_KERNEL(fmb_2d_moving_tt, fmb_simplices_2d(block, true, true))
FMB_VERDICT_KERNEL(fmb_3d_cc, fmb_cuboids_3d(block, false, false, FMB_ASK_ALL))
FMB_VERDICT_KERNEL(fmb_3d_ct, fmb_simplices_3d(block, false, false, false, FMB_ASK_ALL))
FMB_VERDICT_KERNEL(fmb_3d_tt, fmb_simplices_3d(block, false, true, false, FMB_ASK_ALL))
FMB_VERDICT_KERNEL(fmb_3d_moving_cc, fmb_cuboids_3d(block, true, false, FMB_ASK_ALL))
FMB_VERDICT_KERNEL(fmb_3d_moving_ct, fmb_simplices_3d(block, true, false, false, FMB_ASK_ALL))
FMB_VERDICT_KERNEL(fmb_3d_moving_tt, fmb_simplices_3d(block, true, true, false, FMB_ASK_ALL))

/* A block (simplex, cuboid) is swapped. */
#define FMB_SHAPES(name)                                                                           \
    {                                                                                              \
        {name##_cc, name##_ct},                                                                    \
        {                                                                                          \
            name##_ct, name##_tt                                                                   \
        }                                                                                          \
    }
#define FMB_VERDICTS                                                                               \
    {                                                                                              \
        {FMB_SHAPES(fmb_2d), FMB_SHAPES(fmb_2d_moving)},                                           \
        {                                                                                          \
            FMB_SHAPES(fmb_3d), FMB_SHAPES(fmb_3d_moving)                                          \
        }                                                                                          \
    }

#endif
