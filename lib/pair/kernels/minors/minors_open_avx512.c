/* minors_open_avx512.c: of eight pairs at a time; see minors_open.h. */
#define FMB_LANES       8
#define FMB_MINORS_LIST fmb_minors_list_avx512

#include "pair/kernels/minors/minors_open.h"
