/* kernels_one.c: one pair at a time; see kernels.h. A test names the table otherwise. */
#define FMB_LANES 1
#ifndef FMB_TABLE
#define FMB_TABLE fmb_pair_kernels_one
#endif

#include "pair/inside.h"
