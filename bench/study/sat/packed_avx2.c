/* packed_avx2.c: four pairs at a time; see packed.h. */
#define FMB_LANES        4
#define FMB_PACKED_TABLE study_sat_packed_avx2

#include "study/sat/packed.h"

#include "pair/kernels/packed/pack.h"
