/* sat_avx512.c: eight pairs at a time; see sat.h. */
#define FMB_LANES        8
#define FMB_PACKED_TABLE study_sat_packed_avx512
#define FMB_TABLE        study_sat_avx512

#include "study/sat/inside.h"
