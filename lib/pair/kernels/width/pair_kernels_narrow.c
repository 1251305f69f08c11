/* pair_kernels_narrow.c: what every processor has: two pairs at a time on x86-64, elsewhere one;
 * see pair_kernels.h. A test names the table otherwise, and wants C alone. */
#if defined __SSE2__ && !defined FMB_LANE_PLAIN
#define FMB_LANES 2
#else
#define FMB_LANES 1
#endif
#ifndef FMB_PACKED_TABLE
#define FMB_PACKED_TABLE fmb_packed_narrow
#endif
#ifndef FMB_MINORS_TABLE
#define FMB_MINORS_TABLE fmb_minors_narrow
#endif
#ifndef FMB_TABLE
#define FMB_TABLE fmb_pair_kernels_narrow
#endif

#include "pair/kernels/width/pair_kernels_private.h"
