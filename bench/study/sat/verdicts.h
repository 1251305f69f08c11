/* verdicts.h: a kernel for each kind of pair; see kernels.h. */
#ifndef FMB_STUDY_SAT_VERDICTS_H
#define FMB_STUDY_SAT_VERDICTS_H

#include "study/sat/kernels.h"

static fmb_pair_bits sat_2d_cc(const double *block)
{
    return sat_decide_flat((sat_kind){2, false, false, false}, block);
}

static fmb_pair_bits sat_2d_ct(const double *block)
{
    return sat_decide_flat((sat_kind){2, false, false, true}, block);
}

static fmb_pair_bits sat_2d_tt(const double *block)
{
    return sat_decide_flat((sat_kind){2, false, true, true}, block);
}

static fmb_pair_bits sat_2d_moving_cc(const double *block)
{
    return sat_decide_flat((sat_kind){2, true, false, false}, block);
}

static fmb_pair_bits sat_2d_moving_ct(const double *block)
{
    return sat_decide_flat((sat_kind){2, true, false, true}, block);
}

static fmb_pair_bits sat_2d_moving_tt(const double *block)
{
    return sat_decide_flat((sat_kind){2, true, true, true}, block);
}

static fmb_pair_bits sat_3d_cc(const double *block)
{
    return sat_decide((sat_kind){3, false, false, false}, FMB_ASK_ALL, block);
}

static fmb_pair_bits sat_3d_ct(const double *block)
{
    return sat_decide((sat_kind){3, false, false, true}, FMB_ASK_ALL, block);
}

static fmb_pair_bits sat_3d_tt(const double *block)
{
    return sat_decide((sat_kind){3, false, true, true}, FMB_ASK_ALL, block);
}

static fmb_pair_bits sat_3d_moving_cc(const double *block)
{
    return sat_decide((sat_kind){3, true, false, false}, FMB_ASK_ALL, block);
}

static fmb_pair_bits sat_3d_moving_ct(const double *block)
{
    return sat_decide((sat_kind){3, true, false, true}, FMB_ASK_ALL, block);
}

static fmb_pair_bits sat_3d_moving_tt(const double *block)
{
    return sat_decide((sat_kind){3, true, true, true}, FMB_ASK_ALL, block);
}

/* A block (simplex, cuboid) is swapped. */
#define SAT_SHAPES(name)                                                                           \
    {                                                                                              \
        {name##_cc, name##_ct},                                                                    \
        {                                                                                          \
            name##_ct, name##_tt                                                                   \
        }                                                                                          \
    }
#define STUDY_VERDICTS_BY_SAT                                                                      \
    {                                                                                              \
        {SAT_SHAPES(sat_2d), SAT_SHAPES(sat_2d_moving)},                                           \
        {                                                                                          \
            SAT_SHAPES(sat_3d), SAT_SHAPES(sat_3d_moving)                                          \
        }                                                                                          \
    }

#endif
