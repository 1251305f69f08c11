/* packed_narrow.c: what every processor has, as in pair_kernels_narrow.c; see packed_kernels.h. */
#if defined __SSE2__ && !defined FMB_LANE_PLAIN
#define FMB_LANES 2
#else
#define FMB_LANES 1
#endif
#ifndef FMB_PACKED_TABLE
#define FMB_PACKED_TABLE fmb_packed_narrow
#endif

#include "pair/kernels/packed/packed_verdict.h"

#include "pair/kernels/packed/pack.h"
