/* box.h: the box of the common points of two frames that meet. */
#ifndef FMB_PAIR_BOX_H
#define FMB_PAIR_BOX_H

#include "pair/front.h"

#define FMB_BOXES                                                                                  \
    {                                                                                              \
        {                                                                                          \
            {                                                                                      \
                {                                                                                  \
                    0                                                                              \
                }                                                                                  \
            }                                                                                      \
        }                                                                                          \
    }

#endif
