/* kernels_one.c: one pair at a time, in plain C; see kernels.h. */
#define FMB_LANES 1
#define FMB_TABLE fmb_pair_kernels_one

#include "pair/inside.h"
