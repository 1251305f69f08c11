/* packed_avx512.c: eight pairs at a time; see packed_kernels.h. */
#define FMB_LANES        8
#define FMB_PACKED_TABLE fmb_packed_avx512

#include "pair/kernels/packed/packed_verdict.h"

#include "pair/kernels/packed/pack.h"
