/* packed_narrow.c: what every processor has, as in pair_kernels_narrow.c; see packed_kernels.h. */
#ifndef FMB_PACKED_TABLE
#define FMB_PACKED_TABLE fmb_packed_narrow
#endif

#include "pair/kernels/packed/packed_verdict.h"

#include "pair/kernels/packed/pack.h"
