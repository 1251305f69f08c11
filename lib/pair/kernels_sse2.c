/* kernels_sse2.c: two pairs at a time; every x86-64 processor can; see kernels.h. */
#define FMB_LANES 2
#define FMB_TABLE fmb_pair_kernels_sse2

#include "pair/inside.h"
