/* sat_narrow.c: for every processor: two pairs at a time on x86-64, elsewhere one; see sat.h. A
 * test renames the table and uses plain C. */
#ifndef FMB_PACKED_TABLE
#define FMB_PACKED_TABLE study_sat_packed_narrow
#endif
#ifndef FMB_TABLE
#define FMB_TABLE study_sat_narrow
#endif

#include "study/sat/inside.h"
