/* inside.h: all kernels of one width; the body of sat_*.c, which set FMB_LANES and name the table
 * FMB_TABLE. */
#include "study/sat/kernels.h"
#include "study/sat/sat.h"

const fmb_pair_kernels FMB_TABLE = {.width = FMB_LANES, .verdict = STUDY_VERDICTS_BY_SAT};
