/* sat.h: verdicts by separating axes. */
#ifndef FMB_PAIR_SAT_H
#define FMB_PAIR_SAT_H

#include "pair/front.h"

#define FMB_VERDICTS_BY_SAT                                                                        \
    {                                                                                              \
        {                                                                                          \
            {                                                                                      \
                0                                                                                  \
            }                                                                                      \
        }                                                                                          \
    }

#endif
