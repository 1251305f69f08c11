/* pair_kernels_avx512.c: eight pairs at a time; see pair_kernels.h. */
#define FMB_LANES        8
#define FMB_PACKED_TABLE fmb_packed_avx512
#define FMB_MINORS_TABLE fmb_minors_avx512
#define FMB_TABLE        fmb_pair_kernels_avx512

#include "pair/kernels/width/pair_kernels_private.h"
