/* packed_narrow.c: for every processor; see packed.h. */
#if defined __SSE2__ && !defined FMB_LANE_PLAIN
#define FMB_LANES 2
#else
#define FMB_LANES 1
#endif
#ifndef FMB_PACKED_TABLE
#define FMB_PACKED_TABLE study_sat_packed_narrow
#endif

#include "study/sat/packed.h"

#include "pair/kernels/packed/pack.h"
