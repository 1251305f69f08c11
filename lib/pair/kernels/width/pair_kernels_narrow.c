/* pair_kernels_narrow.c: what every processor has (lane.h); see pair_kernels.h. A test names the
 * table otherwise. */
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
