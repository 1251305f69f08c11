/* inside.h: all kernels of one width; the body of kernels_*.c, which set FMB_LANES and name the
 * table FMB_TABLE. */
#include "pair/kernels.h"

#include "pair/box.h"
#include "pair/fmb.h"
#include "pair/sat.h"

const fmb_pair_kernels FMB_TABLE = {
    .width = FMB_LANES, .fmb = FMB_VERDICTS_BY_FMB, .sat = FMB_VERDICTS_BY_SAT, .box = FMB_BOXES};
