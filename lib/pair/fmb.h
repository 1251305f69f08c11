/* fmb.h: verdicts by Fourier-Motzkin elimination. */
#ifndef FMB_PAIR_FMB_H
#define FMB_PAIR_FMB_H

#include "pair/front.h"

#define FMB_VERDICTS_BY_FMB                                                                        \
    {                                                                                              \
        {                                                                                          \
            {                                                                                      \
                0                                                                                  \
            }                                                                                      \
        }                                                                                          \
    }

#endif
