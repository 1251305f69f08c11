/* fmb.h: verdicts by Fourier-Motzkin elimination. */
#ifndef FMB_PAIR_FMB_H
#define FMB_PAIR_FMB_H

#include "pair/fmb_cuboids.h"
#include "pair/fmb_simplices.h"

static fmb_pair_bits fmb_2d_cc(const double *block)
{
    return fmb_cuboids_2d(block, false);
}

static fmb_pair_bits fmb_2d_ct(const double *block)
{
    return fmb_simplices_2d(block, false, false);
}

static fmb_pair_bits fmb_2d_tt(const double *block)
{
    return fmb_simplices_2d(block, false, true);
}

static fmb_pair_bits fmb_2d_moving_cc(const double *block)
{
    return fmb_cuboids_2d(block, true);
}

static fmb_pair_bits fmb_2d_moving_ct(const double *block)
{
    return fmb_simplices_2d(block, true, false);
}

static fmb_pair_bits fmb_2d_moving_tt(const double *block)
{
    return fmb_simplices_2d(block, true, true);
}

static fmb_pair_bits fmb_3d_cc(const double *block)
{
    return fmb_cuboids_3d(block, false);
}

static fmb_pair_bits fmb_3d_ct(const double *block)
{
    return fmb_simplices_3d(block, false, false);
}

static fmb_pair_bits fmb_3d_tt(const double *block)
{
    return fmb_simplices_3d(block, false, true);
}

static fmb_pair_bits fmb_3d_moving_cc(const double *block)
{
    return fmb_cuboids_3d(block, true);
}

static fmb_pair_bits fmb_3d_moving_ct(const double *block)
{
    return fmb_simplices_3d(block, true, false);
}

static fmb_pair_bits fmb_3d_moving_tt(const double *block)
{
    return fmb_simplices_3d(block, true, true);
}

#define FMB_VERDICTS_BY_FMB                                                                        \
    {                                                                                              \
        {{fmb_2d_cc, fmb_2d_ct, fmb_2d_tt},                                                        \
         {fmb_2d_moving_cc, fmb_2d_moving_ct, fmb_2d_moving_tt}},                                  \
        {                                                                                          \
            {fmb_3d_cc, fmb_3d_ct, fmb_3d_tt},                                                     \
            {                                                                                      \
                fmb_3d_moving_cc, fmb_3d_moving_ct, fmb_3d_moving_tt                               \
            }                                                                                      \
        }                                                                                          \
    }

#endif
