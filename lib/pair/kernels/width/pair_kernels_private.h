/* pair_kernels_private.h: all kernels of one width; the body of kernels_*.c, which set FMB_LANES
 * and name the table FMB_TABLE. */
#include "pair/kernels/pair_kernels.h"

#include "pair/kernels/box/box_kernel.h"
#include "pair/kernels/minors_kernels.h"
#include "pair/kernels/verdict/verdict_kernel.h"

extern const fmb_packed FMB_PACKED_TABLE;
extern const fmb_minor_kernels FMB_MINORS_TABLE;
const fmb_pair_kernels FMB_TABLE = {.width = FMB_LANES,
                                    .packed = &FMB_PACKED_TABLE,
                                    .minors = &FMB_MINORS_TABLE,
                                    .verdict = FMB_VERDICTS,
                                    .box = FMB_BOXES};
