/* packed_narrow.c: for every processor; see packed.h. */
#ifndef FMB_PACKED_TABLE
#define FMB_PACKED_TABLE study_sat_packed_narrow
#endif

#include "study/sat/packed.h"

#include "pair/kernels/packed/pack.h"
