/* inside.h: all kernels of one width; the body of sat_*.c, which set FMB_LANES and name the table
 * FMB_TABLE. */
#include "pair/kernels/packed_kernels.h"
#include "study/sat/sat.h"
#include "study/sat/verdicts.h"

extern const fmb_packed FMB_PACKED_TABLE;
const fmb_pair_kernels FMB_TABLE = {
    .width = FMB_LANES, .packed = &FMB_PACKED_TABLE, .verdict = STUDY_VERDICTS_BY_SAT};
