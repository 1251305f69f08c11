/* sat_avx2.c: four pairs at a time; see sat.h. */
#define FMB_LANES        4
#define FMB_PACKED_TABLE study_sat_packed_avx2
#define FMB_TABLE        study_sat_avx2

#include "study/sat/inside.h"
