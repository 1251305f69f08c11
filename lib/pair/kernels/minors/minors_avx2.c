/* minors_avx2.c: four pairs at a time; see minors_kernels.h. */
#define FMB_LANES        4
#define FMB_MINORS_TABLE fmb_minors_avx2
#define FMB_MINORS_LIST  fmb_minors_list_avx2

#include "pair/kernels/minors/minors_loops.h"
