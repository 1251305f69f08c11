/* pair_kernels_avx2.c: four pairs at a time; see pair_kernels.h. */
#define FMB_LANES        4
#define FMB_PACKED_TABLE fmb_packed_avx2
#define FMB_MINORS_TABLE fmb_minors_avx2
#define FMB_TABLE        fmb_pair_kernels_avx2

#include "pair/kernels/width/pair_kernels_private.h"
