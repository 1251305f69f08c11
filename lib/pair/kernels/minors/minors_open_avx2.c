/* minors_open_avx2.c: of four pairs at a time; see minors_open.h. */
#define FMB_LANES       4
#define FMB_MINORS_LIST fmb_minors_list_avx2

#include "pair/kernels/minors/minors_open.h"
