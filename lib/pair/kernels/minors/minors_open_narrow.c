/* minors_open_narrow.c: what every processor has, as in pair_kernels_narrow.c; see minors_open.h.
 */
#ifndef FMB_MINORS_LIST
#define FMB_MINORS_LIST fmb_minors_list_narrow
#endif

#include "pair/kernels/minors/minors_open.h"
