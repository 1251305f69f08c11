/* minors_avx512.c: eight pairs at a time; see minors_kernels.h. */
#define FMB_LANES        8
#define FMB_MINORS_TABLE fmb_minors_avx512
#define FMB_MINORS_LIST  fmb_minors_list_avx512

#include "pair/kernels/minors/minors_loops.h"
