/* packed_avx512.c: eight pairs at a time; see packed.h. */
#define FMB_LANES        8
#define FMB_PACKED_TABLE study_sat_packed_avx512

#include "study/sat/packed.h"

#include "pair/kernels/packed/pack.h"
