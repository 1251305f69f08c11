/* packed_avx2.c: four pairs at a time; see packed_kernels.h. */
#define FMB_LANES        4
#define FMB_PACKED_TABLE fmb_packed_avx2

#include "pair/kernels/packed/packed_verdict.h"

#include "pair/kernels/packed/pack.h"
